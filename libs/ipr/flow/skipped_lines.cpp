// SPDX-License-Identifier: MIT
// A line that lies ahead of all that is known leaves a stretch after it; one within a stretch
// divides it.
#include "ipr/flow/skipped_lines.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace softcnc::ipr {

void SkippedLines::read(int line, const Reader::Place& after, bool moved) {
  const int before = std::exchange(last_read_, line);
  if (line <= known_.line) return cut_out(moved ? line : before + 1, line, after);
  const bool passed = moved && line > known_.line + 1;
  if (passed && stretches_.size() < kMost) stretches_.push_back({known_, line - 1});
  known_ = after;
}

std::deque<SkippedLines::Stretch> SkippedLines::take(bool rest) {
  constexpr int kEnd = std::numeric_limits<int>::max();
  if (rest && known_.line < kEnd) stretches_.push_back({std::exchange(known_, {0, kEnd}), kEnd});
  return std::exchange(stretches_, {});
}

/// Between lines that are read one after the other there are none but empty ones: all of them lie
/// in one stretch, or in none.
void SkippedLines::cut_out(int first, int line, const Reader::Place& after) {
  auto at = std::lower_bound(stretches_.begin(), stretches_.end(), first,
                             [](const Stretch& one, int of) { return one.last < of; });
  if (at == stretches_.end() || at->begin.line >= line) return;
  const Stretch whole = *at;
  at = stretches_.erase(at);
  if (line < whole.last) at = stretches_.insert(at, {after, whole.last});
  const bool begun = first > whole.begin.line + 1;
  if (begun && stretches_.size() < kMost) stretches_.insert(at, {whole.begin, first - 1});
}

}  // namespace softcnc::ipr
