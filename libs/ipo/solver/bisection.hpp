// SPDX-License-Identifier: MIT
// Bisection where each evaluation is expensive.
#pragma once

#include <algorithm>
#include <optional>

namespace softcnc::ipo {

/// Returns the first k of 0 to `last` for which holds(k), where it normally holds for all larger
/// ones, too; nothing if it was found to hold nowhere. Steps away from `guess` double until k is
/// bracketed, then the bracket is halved.
template <typename Holds>
std::optional<int> bisect(int guess, int last, Holds&& holds) {
  int k = std::clamp(guess, 0, last), no = -1, yes = last + 1;
  for (int step = 1; k > no && k < yes; ++step) {
    const bool held = holds(k);
    (held ? yes : no) = k;
    if (held && no < 0) k = std::max(yes - step, 0);
    if (!held && yes > last) k = std::min(no + step, last);
    if (no >= 0 && yes <= last) break;
  }
  while (yes <= last && yes - no > 1) {
    k = no + (yes - no) / 2;
    (holds(k) ? yes : no) = k;
  }
  if (yes > last) return std::nullopt;
  return yes;
}

}  // namespace softcnc::ipo
