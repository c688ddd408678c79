// SPDX-License-Identifier: MIT
// The part of a chain that one plan covers.
#pragma once

#include <algorithm>
#include <cstddef>

#include "ipo/path/chain.hpp"

namespace softcnc::ipo {

/// Speed and acceleration along the path, mm/s and mm/s^2.
struct Motion {
  double v = 0, a = 0;
};

/// Nodes [first, last] of a chain whose velocity limits have been derived. Positions on it are in
/// mm of the chain.
struct PlanSpan {
  const Chain& chain;
  const ConstraintList& constraints;
  std::size_t first, last;
  double share;          // of the axis accelerations and jerks
  bool replans = false;  // begins where no plan was made to be continued
  double jerk_part = 1;  // of the axis jerks: what the plan aims at

  AxisVector jerk_limits() const noexcept { return jerk_part * constraints.limits().jerk; }
  double s(std::size_t node) const noexcept { return chain.nodes[node].s; }
  const Interval& interval(std::size_t i) const noexcept { return chain.intervals[i]; }

  /// Returns the position in the move of interval i, mm.
  double move_s(std::size_t i, double at) const noexcept {
    return std::clamp(interval(i).s0 + (at - s(i)), interval(i).s0, interval(i).s1);
  }
  /// Returns the derivatives of the path itself, not those stored in the interval.
  PathPoint point(std::size_t i, double at, Side side) const noexcept {
    const Interval& in = interval(i);
    return in.straight() ? in.left : softcnc::at(*in.path, move_s(i, at), side);
  }
};

}  // namespace softcnc::ipo
