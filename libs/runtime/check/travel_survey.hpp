// SPDX-License-Identifier: MIT
// Where the moves of a program go, by the work system that they belong to.
#pragma once

#include <limits>
#include <map>

#include "motion/model/block.hpp"

namespace softcnc::runtime {

/// How far moves go along each axis, mm, machine coordinates; above max: nowhere.
struct TravelSpan {
  AxisVector min = AxisVector::Constant(std::numeric_limits<double>::infinity());
  AxisVector max = AxisVector::Constant(-std::numeric_limits<double>::infinity());

  bool empty(int axis) const noexcept { return !(min[axis] <= max[axis]); }
  void include(int axis, double low, double high) noexcept;
};

/// Collects the extent of a program. An axis counts where a move changes it: where it rests, it is
/// where an earlier move, or the machine, has left it.
class TravelSurvey {
 public:
  void add(const Move& move);

  /// Returns the spans by Move::work_system.
  const std::map<int, TravelSpan>& by_system() const noexcept { return spans_; }
  /// Returns the span of all moves.
  TravelSpan all() const noexcept;

 private:
  std::map<int, TravelSpan> spans_;
};

}  // namespace softcnc::runtime
