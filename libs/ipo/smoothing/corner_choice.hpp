// SPDX-License-Identifier: MIT
// Whether a corner is passed sooner on a curve that rounds it, or by a rest in it.
//
// A curve takes its length over the speed at its tightest place, or part of that: where the
// accelerations or the jerk of the axes limit that speed, the ends of the curve are faster and some
// of it is braking that a rest would ask for as well. What a rest takes from there on is the speed
// over the deceleration, to standstill and back, less what the way of the curve takes at the feed.
#pragma once

#include "ipo/limits/constraint.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// A curve that replaces a corner, at its tightest place.
struct RoundedCorner {
  double length = 0;                        // mm, of all of it
  AxisVector tangent = AxisVector::Zero();  // of the line or curve that leads into it
  AxisVector ddq = AxisVector::Zero();      // 1/mm
  AxisVector dddq = AxisVector::Zero();     // 1/mm^2, the largest by axis
  double feed = 0;                          // mm/s; kUnlimited: a rapid
};

class CornerChoice {
 public:
  explicit CornerChoice(const Machine& machine);

  /// False where a rest in the corner is sooner behind it.
  bool is_sooner(const RoundedCorner& corner) const noexcept;

 private:
  double fastest(const RoundedCorner& corner) const noexcept;

  AxisVector velocity_, acceleration_, jerk_;  // of absent axes and without limits: unlimited
  double period_, chord_tolerance_, feed_, tangential_, normal_;
};

}  // namespace softcnc::ipo
