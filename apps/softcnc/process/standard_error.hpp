// SPDX-License-Identifier: MIT
// Text on standard error: a machine does not stop because nobody reads it.
#pragma once

#include <string_view>

namespace softcnc::app {

/// Writes text, and waits for a slow reader unless a signal asks for a stop meanwhile. Returns
/// false where it cannot be written and is dropped.
bool write_to_stderr(std::string_view text) noexcept;

/// From here on nobody waits for a reader of standard error: a signal has asked for a stop.
void stop_waiting_for_stderr() noexcept;

/// Writes text of a display: what would have to wait is dropped as well.
void display_on_stderr(std::string_view text) noexcept;

/// Standard descriptors that are closed are opened for what fails: a file that is opened later must
/// not take the place of one of them, and with it what is meant for a person.
void occupy_standard_descriptors() noexcept;

}  // namespace softcnc::app
