// SPDX-License-Identifier: MIT
// The first and the last ramp of a motion: s(t) = j t^3 / 6 from or to rest.
//
// At rest q = v^2 has an infinite second derivative by arc length, so a polynomial in s cannot
// begin there. Over a distance too short to matter the motion is therefore given in closed form.
#pragma once

#include "ipo/jerk_limited/plan_span.hpp"
#include "ipo/path/ramp.hpp"
#include "ipo/solver/speed_spline.hpp"

namespace softcnc::ipo {

struct RestRamp {
  double jerk = 0, duration = 0;

  double length() const noexcept { return jerk * duration * duration * duration / 6; }
  double speed() const noexcept { return 0.5 * jerk * duration * duration; }
  double acceleration() const noexcept { return jerk * duration; }
  /// Returns q where it meets the plan; `sign` is 1 for a start, -1 for an end.
  SpeedSquare square(double sign) const noexcept {
    return {speed() * speed(), sign * 2 * acceleration(), 0};
  }
  /// Returns the ramp between two positions of the move.
  Ramp start(double s0, double s1) const noexcept {
    return {s0, s1, duration, 0, speed(), 0, acceleration(), Limit::jerk};
  }
  Ramp end(double s0, double s1) const noexcept {
    return {s0, s1, duration, speed(), 0, -acceleration(), 0, Limit::jerk};
  }
};

/// Returns the ramp at the beginning of interval i, or at its end: short, slow, a small part of the
/// interval, and within all axis limits.
RestRamp rest_ramp(const PlanSpan& span, std::size_t i, Side of_rest) noexcept;

}  // namespace softcnc::ipo
