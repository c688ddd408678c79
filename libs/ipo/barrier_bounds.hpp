// SPDX-License-Identifier: MIT
// The inequalities of an interior point method: each with its slack, its multiplier and the step of
// both.
#pragma once

#include <algorithm>

#include "ipo/speed_spline.hpp"

namespace softcnc::ipo {

/// A bound g(q) + slack = 0 with its multiplier, and the step of both.
struct Bound {
  double slack = 1, multiplier = 1;
  double slack_step = 0, multiplier_step = 0;

  /// What the row asks of the gradient for the complementarity `aim`.
  double pull(double g, double aim) const noexcept {
    return (aim + multiplier * (g + slack)) / slack;
  }
  void find_step(double g, double g_step, double aim) noexcept {
    slack_step = -(g + slack) - g_step;
    multiplier_step = (aim - multiplier * slack_step) / slack - multiplier;
  }
  double correction() const noexcept { return slack_step * multiplier_step; }
};

inline constexpr double kToBoundary = 0.99;  // of the way to the nearest bound

/// The longest step within both bounds.
struct StepLength {
  double primal = 1, dual = 1;
  void include(const Bound& bound) noexcept {
    if (bound.slack_step < 0)
      primal = std::min(primal, -kToBoundary * bound.slack / bound.slack_step);
    if (bound.multiplier_step < 0)
      dual = std::min(dual, -kToBoundary * bound.multiplier / bound.multiplier_step);
  }
};

/// A row as it is used: upper: +(a q + b q' + c q'') + tangent q <= bound, lower likewise with -.
struct TwoBounds {
  double a, b, c, tangent, bound;
  Bound upper, lower;

  double value(const SpeedSquare& at) const noexcept { return a * at.q + b * at.dq + c * at.ddq; }
  double rest(const SpeedSquare& at) const noexcept { return tangent * at.q - bound; }
};

/// Symmetric, in (q, q', q'').
struct Curvature {
  double qq = 0, qd = 0, qe = 0, dd = 0, de = 0, ee = 0;
  void add(double weight, double a, double b, double c) noexcept {
    qq += weight * a * a;
    qd += weight * a * b;
    qe += weight * a * c;
    dd += weight * b * b;
    de += weight * b * c;
    ee += weight * c * c;
  }
};

}  // namespace softcnc::ipo
