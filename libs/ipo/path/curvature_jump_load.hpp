// SPDX-License-Identifier: MIT
// What a joint at which x'' jumps takes from the jerk of the axes around it.
#pragma once

#include <algorithm>

#include "ipo/tuning.hpp"
#include "motion/core/axes.hpp"

namespace softcnc::ipo {

/// An acceleration that jumps by b appears in a third difference as b B(t) / T, t periods from the
/// middle of its samples, where B is the quadratic B-spline over three periods, at most 3/4. The
/// jerk around it appears as its average weighted by B. So every sample keeps a limit if the jerk
/// plus b w(t) / T keeps it, provided that the average of w by B is nowhere below B; w is a
/// trapezoid.
inline double jump_weight(double periods) noexcept {
  return tuning::joints::kJumpWeight *
         std::clamp((tuning::joints::kJumpPeriods - periods) /
                        (tuning::joints::kJumpPeriods - tuning::joints::kJumpFlat),
                    0.0, 1.0);
}

/// What jumps add to the jerk of each axis, towards + and towards -; both are positive.
struct CurvatureJumpLoad {
  AxisVector above = AxisVector::Zero(), below = AxisVector::Zero();

  void add(const AxisVector& jump) noexcept {
    above += jump.cwiseMax(0.0);
    below -= jump.cwiseMin(0.0);
  }
};

}  // namespace softcnc::ipo
