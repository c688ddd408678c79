// SPDX-License-Identifier: MIT
// What is wrong with a command line, in the words of softcnc.
#pragma once

#include <string>

namespace softcnc::app {

/// Returns a sentence of CLI11 2.1 in softcnc's words; one that is not known as it is.
std::string usage_error(const std::string& of_parser);

}  // namespace softcnc::app
