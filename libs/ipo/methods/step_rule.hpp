// SPDX-License-Identifier: MIT
// The rule by which a method of the literature steps along a curve, and what the rule is given.
#pragma once

#include "motion/geometry/nurbs.hpp"

namespace softcnc::ipo {

/// Where a walk through the parameter of a curve is.
struct WalkPlace {
  const Nurbs* nurbs;
  double u, u_before;      // now, and one step before
  AxisVector last[3];      // the last points, newest first,
  int points;              // and how many of them there are
  double chord_tolerance;  // mm
  double part = 1;         // of a period, which the next step may take
};

/// Realtime. Returns the change of the parameter that the method takes for `ds` mm, the planned
/// speed integrated over the step.
using Increment = double (*)(const WalkPlace& place, double ds) noexcept;
/// Realtime. Returns the longest step, mm, that the method takes from there, in that part of a
/// period.
using LongestStep = double (*)(const WalkPlace& place) noexcept;

struct StepRule {
  Increment increment = nullptr;
  LongestStep longest = nullptr;  // null: any step
};

/// Returns the change of the parameter over `ds` mm by the arc length. Where the curve stands still
/// (repeated control points) no method has a derivative to divide by.
double from_standstill(const WalkPlace& place, double ds) noexcept;

/// du = ds / |P'|: paper 000, equation 6, to the first order.
double taylor1_increment(const WalkPlace& place, double ds) noexcept;

/// du = ds / |P'| - ds^2 (P' . P'') / (2 |P'|^4): paper 004, equation 7.
double taylor2_increment(const WalkPlace& place, double ds) noexcept;

/// du = ds / |P'| with P' of the point before, ds limited to sqrt(8 eps / kappa), kappa from the
/// last three points (the exact one until there are three): paper 000, section 3.2.
double three_point_increment(const WalkPlace& place, double ds) noexcept;
double three_point_longest(const WalkPlace& place) noexcept;

/// Solves du/dt = v(t) / |P'(u)| by one step of the classical Runge-Kutta method of order 4 (Kutta
/// 1901), with the planned distance s as the variable instead of t: du/ds = 1 / |P'(u)|. So the
/// error is that of the curve alone, wherever the plan begins to brake.
double rk4_increment(const WalkPlace& place, double ds) noexcept;

/// The speed-controlled interpolator of Yeh and Hsu, Computer-Aided Design 31 (1999) 349-357: a
/// Taylor step of first order to u', then the compensatory parameter
///   eps = (-(D . C') + sqrt((D . C')^2 - |C'|^2 (|D|^2 - ds^2))) / |C'|^2
/// with D = P(u') - P(u) and C' = P'(u'), by which the chord becomes ds long, to the first order in
/// eps. There is no compensation where the root is imaginary.
double yeh_hsu_1999_increment(const WalkPlace& place, double ds) noexcept;

/// The adaptive-feed interpolator of Yeh and Hsu, Computer-Aided Design 34 (2002) 229-237: a Taylor
/// step of second order, no longer than 2 sqrt(rho^2 - (rho - eps)^2), rho the radius of curvature
/// where the step begins. Where rho is eps or less, it is no longer than 2 eps.
double yeh_hsu_2002_increment(const WalkPlace& place, double ds) noexcept;
double yeh_hsu_2002_longest(const WalkPlace& place) noexcept;

/// Returns the curvature of the curve where the walk is, 1/mm; 0 where the curve stands still.
double curvature_at(const WalkPlace& place) noexcept;

/// Returns the curvature of the circle through three points, 1/mm; 0 if they lie on a line.
double three_point_curvature(const AxisVector& a, const AxisVector& b,
                             const AxisVector& c) noexcept;

}  // namespace softcnc::ipo
