// SPDX-License-Identifier: MIT
// What a joint at which x'' jumps takes from the jerk of the axes around it.
#pragma once

#include <algorithm>

#include "motion/core/axes.hpp"

namespace softcnc::ipo {

/// w: beyond so many periods it is 0, up to so many it is highest.
inline constexpr double kJumpReach = 2, kJumpFlat = 0.5;

/// An acceleration that jumps by b shows in a third difference as b B(t) / T, t periods from the
/// middle of its rows: B is the quadratic B-spline over three periods, no higher than 3/4. The jerk
/// around shows as its average by the weight B. So every row keeps a limit if the jerk keeps it
/// with b w(t) / T on top, w being such that its average by B is nowhere below B: a trapezoid.
inline double jump_weight(double periods) noexcept {
  constexpr double kHighest = 0.7942;  // 3/4 of 18/17: B leaves 17/18 of it in the middle
  return kHighest * std::clamp((kJumpReach - periods) / (kJumpReach - kJumpFlat), 0.0, 1.0);
}

/// Where a plan asks for it joints are so many periods nearer, so that its nodes need not lie at
/// the very corners of w.
inline constexpr double kJumpNearer = 0.1;

/// What jumps add to the jerk of each axis, towards + and towards -; both are positive.
struct JumpLoad {
  AxisVector above = AxisVector::Zero(), below = AxisVector::Zero();

  void add(const AxisVector& jump) noexcept {
    above += jump.cwiseMax(0.0);
    below -= jump.cwiseMin(0.0);
  }
};

}  // namespace softcnc::ipo
