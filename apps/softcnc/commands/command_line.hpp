// SPDX-License-Identifier: MIT
// From the words of the command line to options.
#pragma once

#include <variant>

#include "settings/options.hpp"

namespace softcnc::app {

/// The exit status after a wrong command line.
inline constexpr int kWrongUsage = 2;

/// Returns the options; or, where there is nothing more to do, the exit status: 0 after --help and
/// --version (5 where they cannot be written), 2 after reporting a wrong command line.
std::variant<Options, int> parse_command_line(int argc, const char* const* argv);

}  // namespace softcnc::app
