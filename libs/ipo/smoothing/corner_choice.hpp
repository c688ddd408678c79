// SPDX-License-Identifier: MIT
// Whether a corner is passed sooner on a curve that rounds it, or with a rest in it.
//
// A curve takes its length over the speed at its tightest place, or a part of that: where the
// accelerations or the jerk of the axes limit that speed, the ends of the curve are faster, and
// some of it is braking that a rest would require as well. A rest takes, in addition, the speed
// over the deceleration, to standstill and back, less the time of the length of the curve at the
// feed. With a contour tolerance, speeds fall slowly towards the curve, and the axes have to come
// to a rest.
#pragma once

#include <optional>

#include "ipo/limits/contour_limit.hpp"
#include "ipo/limits/planner_limits.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// A curve that replaces a corner, at its tightest place.
struct RoundedCorner {
  double length = 0;                        // mm, of all of it
  AxisVector tangent = AxisVector::Zero();  // of the line or curve that leads into it
  AxisVector ddq = AxisVector::Zero();      // 1/mm
  AxisVector dddq = AxisVector::Zero();     // 1/mm^2, the largest by axis
  double feed = 0;                          // mm/s; kUnlimited: a rapid
  double room = 0;                          // mm: the shorter one of the paths that it joins
};

class CornerChoice {
 public:
  explicit CornerChoice(const Machine& machine);

  /// Returns false where a rest in the corner is sooner.
  bool is_sooner(const RoundedCorner& corner) const noexcept;

 private:
  double fastest(const RoundedCorner& corner) const noexcept;

  AxisVector velocity_, acceleration_, jerk_;  // of absent axes and without limits: unlimited
  std::optional<ContourLimit> contour_;
  double period_, chord_tolerance_, feed_, tangential_, normal_;
};

}  // namespace softcnc::ipo
