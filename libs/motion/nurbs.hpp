// SPDX-License-Identifier: MIT
// A NURBS curve of degree 1 to 9, as a function of its arc length.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/arc_length.hpp"
#include "motion/curve.hpp"
#include "motion/result.hpp"

namespace softcnc {

struct NurbsSpec {
  int degree = 3;
  std::vector<AxisVector> control;  // mm
  std::vector<double> weights;      // > 0, as many as control points
  std::vector<double> knots;        // control points + degree + 1, clamped at both ends
};

/// Position and the first three derivatives by the parameter u (mm, mm/u, ...).
using NurbsDerivatives = std::array<AxisVector, 4>;

class Nurbs {
 public:
  static constexpr int kMaxDegree = 9;

  /// Checks the specification, turns every span into a Bezier segment and measures the curve.
  /// Errors: the SC30xx codes; the place of the error is left to the caller.
  static Result<Nurbs> make(NurbsSpec spec);

  double length() const noexcept { return map_.length(); }
  PathPoint at(double s, Side side = Side::after) const noexcept;
  AxisVector position(double s) const noexcept;

  /// Interior points of arc length where a derivative may jump (every inner knot, every place where
  /// the curve stands still), ascending; 0 and length() are not among them.
  std::span<const double> breaks() const noexcept { return breaks_; }

  /// By the parameter, u_first() <= u <= u_last(); `side` counts at knots. No allocation.
  AxisVector point(double u) const noexcept;
  NurbsDerivatives derivatives(double u, Side side = Side::after) const noexcept;
  double speed(double u, Side side = Side::after) const noexcept;  // |dC/du|
  double u_first() const noexcept { return spec_.knots.front(); }
  double u_last() const noexcept { return spec_.knots.back(); }

  /// The parameter at arc length s, and the arc length from the start to u. Exact to 1e-12 of the
  /// length.
  double parameter(double s) const noexcept { return map_.parameter(s); }
  double arc_length(double u) const noexcept { return map_.arc_length(u); }

  const NurbsSpec& spec() const noexcept { return spec_; }

 private:
  // See nurbs.cpp.
  struct Span;

  NurbsSpec spec_;
  std::vector<double> span_knots_;            // distinct knots: span i is [i, i + 1]
  std::vector<Eigen::Vector4d> bezier_;       // degree + 1 homogeneous points a span, local origin
  std::vector<AxisVector> origin_;            // local origin of each span
  ArcLengthMap map_;
  std::vector<double> breaks_;

  Nurbs() = default;
};

static_assert(Curve<Nurbs>);

}  // namespace softcnc
