// SPDX-License-Identifier: MIT
// Keys of state files that are names of variables, and what is said of unknown keys.
#pragma once

#include <string>
#include <string_view>

namespace softcnc::hal {

/// Returns the name of a global variable as programs are read: in lower case and without blanks.
/// Empty if it is no such name.
std::string global_name(std::string_view key);

/// Returns the message for a key that no state has.
std::string unknown_state_key(const std::string& path);

}  // namespace softcnc::hal
