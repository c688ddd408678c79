// SPDX-License-Identifier: MIT
// Which errors of a program are but one mistake: what one other character of a line mends.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ipr/interpreter.hpp"

namespace softcnc::ipr {

/// By error, in the order in which they were told: whether it follows from one on another line, or
/// from an earlier one on its own. It does where a line with an error becomes right by one
/// character (another one, one more, one less, or two exchanged) and this error goes with it, while
/// no other comes; of several such lines the one counts that leaves the fewest errors. What reading
/// the text alone does not tell, as a way beyond the travel, is never said to follow. The same for
/// the same arguments: how much is tried is counted, and for long programs not everything is.
std::vector<bool> follow_from_others(std::string text, std::span<const Diagnostic> errors,
                                     Machine machine, InterpreterOptions options,
                                     const MachineState& state = {});

}  // namespace softcnc::ipr
