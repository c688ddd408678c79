// SPDX-License-Identifier: MIT
// From the words of the command line to options.
#pragma once

#include <variant>

#include "settings/options.hpp"

namespace softcnc::app {

/// What was asked for; or, where there is nothing more to do, the exit status: 0 after --help and
/// --version (5 where they cannot be written), 2 after telling what is wrong with the command line.
std::variant<Options, int> parse_command_line(int argc, const char* const* argv);

}  // namespace softcnc::app
