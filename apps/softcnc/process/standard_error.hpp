// SPDX-License-Identifier: MIT
// Words for a person, on standard error: a machine does not stop because nobody reads them.
#pragma once

#include <string_view>

namespace softcnc::app {

/// Waits for a reader that is slow, unless a signal asks for a stop meanwhile. What cannot be
/// written is dropped: false.
bool write_to_stderr(std::string_view text) noexcept;

/// From here on nobody waits for a reader of standard error: a signal has asked for a stop.
void stop_waiting_for_stderr() noexcept;

/// For a display: what would have to wait is dropped as well.
void display_on_stderr(std::string_view text) noexcept;

/// Standard descriptors that are closed are opened for what fails: a file that is opened later must
/// not take the place of one of them, and with it what is meant for a person.
void occupy_standard_descriptors() noexcept;

}  // namespace softcnc::app
