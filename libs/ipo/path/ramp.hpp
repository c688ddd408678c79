// SPDX-License-Identifier: MIT
// A short part of a motion as a polynomial of time.
#pragma once

#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

/// A part of one move, with its speed and acceleration at both ends (mm, s).
struct Ramp {
  double s0 = 0, s1 = 0;
  double duration = 0;
  double v0 = 0, v1 = 0;
  double a0 = 0, a1 = 0;
  Limit limit = Limit::feed;
};

/// Position, speed, acceleration and jerk along the path: mm, mm/s, mm/s^2, mm/s^3.
struct Instant {
  double s = 0, v = 0, a = 0, j = 0;
};

/// s = s0 + v0 t + a0 t^2 / 2 + c3 t^3 + c4 t^4 + c5 t^5.
struct Quintic {
  double s0 = 0, v0 = 0, a0 = 0;
  double c3 = 0, c4 = 0, c5 = 0;

  double s(double t) const noexcept {
    return s0 + t * (v0 + t * (0.5 * a0 + t * (c3 + t * (c4 + t * c5))));
  }
  double v(double t) const noexcept {
    return v0 + t * (a0 + t * (3 * c3 + t * (4 * c4 + t * 5 * c5)));
  }
  double a(double t) const noexcept { return a0 + t * (6 * c3 + t * (12 * c4 + t * 20 * c5)); }
  double j(double t) const noexcept { return 6 * c3 + t * (24 * c4 + t * 60 * c5); }
  Instant at(double t) const noexcept { return {s(t), v(t), a(t), j(t)}; }

  /// Returns the same motion with t = 0 at t.
  Quintic from(double t) const noexcept {
    return {s(t), v(t), a(t), c3 + t * (4 * c4 + t * 10 * c5), c4 + 5 * t * c5, c5};
  }
};

/// Returns the polynomial that meets position, speed and acceleration at both ends of the ramp.
Quintic quintic(const Ramp& ramp) noexcept;

}  // namespace softcnc::ipo
