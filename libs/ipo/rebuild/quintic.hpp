// SPDX-License-Identifier: MIT
// A spline of degree 5 by its knots and control points: basis functions, Bezier points, parts.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "ipo/solver/tube_program.hpp"
#include "motion/core/axes.hpp"
#include "motion/geometry/nurbs_spec.hpp"

namespace softcnc::ipo {

inline constexpr std::size_t kQuinticDegree = 5;

/// Span j lies between knots[j + 5] and knots[j + 6]; the control points j to j + 5 shape it.
struct QuinticSpline {
  std::vector<double> knots;  // control points + 6
  std::vector<AxisVector> control;

  std::size_t spans() const noexcept { return control.size() - kQuinticDegree; }
  double begin(std::size_t span) const noexcept { return knots[span + kQuinticDegree]; }
  double end(std::size_t span) const noexcept { return knots[span + kQuinticDegree + 1]; }
  /// Returns the span of t, the last one at the end.
  std::size_t span_at(double t) const noexcept;
};

/// Returns the mean of the knots inside control point `i`, its place by the parameter.
double greville(std::span<const double> knots, std::size_t i) noexcept;

/// Returns the derivative of that order, 0 to 3, of the six basis functions of a span at t.
QuinticBasis quintic_basis(std::span<const double> knots, std::size_t span, double t, int order);

/// The points of a polynomial of degree 5 over an interval, which is 0 to 1.
struct QuinticBezier {
  std::array<AxisVector, kQuinticOrder> points;

  AxisVector at(double x) const noexcept;
  /// Returns the point and its derivative by x.
  std::pair<AxisVector, AxisVector> with_slope(double x) const noexcept;
  /// Returns the part from 0 to x, and keeps the rest.
  QuinticBezier cut_front(double x) noexcept;
  QuinticBezier between(double x0, double x1) const noexcept;
};

QuinticBezier bezier_of(const QuinticSpline& spline, std::size_t span);

/// Returns the part from t0 to t1 as a curve of its own, whose parameter begins with 0.
NurbsSpec part_of(const QuinticSpline& spline, double t0, double t1);

}  // namespace softcnc::ipo
