// SPDX-License-Identifier: MIT
// Which errors of a program are but one mistake: those that one character, where an error is told,
// mends together.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "motion/core/diagnostic.hpp"

namespace softcnc::ipr {

/// What reading a program tells.
struct Verdict {
  std::vector<Diagnostic> errors;
  std::map<int, int> lines_run;  // of the program's own text, and how often
  std::set<int> lines_in_doubt;  // those of them of which something is not known
  std::int64_t work = 0;         // bytes read, those read again among them
};

/// Reads a program with this text; the same for the same text.
using Judge = std::function<Verdict(const std::string& text)>;

/// By error, in the order in which they were told: whether it follows from one on another line, or
/// from another one on its own. It does where one character in the place of an error (another one,
/// one more, one less, two exchanged) or a line that stands there twice makes that line right, and
/// this error goes with it, while every line with an error that goes is run, as before, with
/// nothing unknown, and no other error comes: the search of Burke and Fisher (ACM TOPLAS 9, 1987)
/// for a repair of one symbol, held against the whole program. Of several such lines the one counts
/// that leaves the fewest errors. A way beyond the travel never follows from another error of its
/// line, and what the judge does not tell of the text as it is from nothing. The same for the same
/// arguments: work is counted, and for long programs not everything is tried.
std::vector<bool> follow_from_others(std::string text, std::span<const Diagnostic> errors,
                                     const Judge& judge);

}  // namespace softcnc::ipr
