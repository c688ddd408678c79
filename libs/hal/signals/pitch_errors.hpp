// SPDX-License-Identifier: MIT
// The pitch errors of a lead screw as a function of its position, and the function that undoes it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// A function of a position, mm: linear between the points of a table, constant before the first
/// and after the last of them, 0 without any.
class PitchErrors {
 public:
  explicit PitchErrors(std::vector<PitchPoint> table) : table_(std::move(table)) {}

  /// Returns the error, mm, at a position. Realtime.
  double operator()(double position) const noexcept {
    if (table_.empty()) return 0;
    const auto after =
        std::upper_bound(table_.begin(), table_.end(), position,
                         [](double at, const PitchPoint& point) { return at < point.position; });
    if (after == table_.begin()) return after->error;
    const PitchPoint& low = after[-1];
    if (after == table_.end()) return low.error;
    const double part = (position - low.position) / (after->position - low.position);
    return low.error + part * (after->error - low.error);
  }

  bool empty() const noexcept { return table_.empty(); }

 private:
  std::vector<PitchPoint> table_;
};

/// Returns the function c with q + e(q) = p for q = p + c(p), where e are the errors of `table`: a
/// screw that is sent to p + c(p) puts the table to p. Since e is linear between its points, c is
/// linear between theirs. Requires errors that change less than their positions.
inline PitchErrors pitch_compensation(const std::vector<PitchPoint>& table) {
  std::vector<PitchPoint> inverse;
  inverse.reserve(table.size());
  for (const PitchPoint& point : table)
    inverse.push_back({point.position + point.error, -point.error});
  return PitchErrors(std::move(inverse));
}

}  // namespace softcnc::hal
