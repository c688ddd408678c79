// SPDX-License-Identifier: MIT
// What only the later rounds of a loop without an end reach.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "motion/core/diagnostic.hpp"

namespace softcnc::app {

/// Part of an endless program, read from its beginning.
struct Rounds {
  std::map<int, int> run;                          // how often each line was
  std::map<std::pair<int, Code>, int> first_told;  // in which round of its line a code was
};

/// Reads until a loop has run so many lines.
using ReadRounds = std::function<Rounds(int block_limit)>;

/// Whether a line leads beyond the travel, or beyond all that is computed with.
bool leads_too_far(const Diagnostic& diagnostic);

/// By error: whether it tells of a line of the loop that has no end, which leads too far only
/// because of that. All false if no loop is told to have no end.
std::vector<bool> follow_from_endless_loop(std::span<const Diagnostic> errors,
                                           const ReadRounds& read);

}  // namespace softcnc::app
