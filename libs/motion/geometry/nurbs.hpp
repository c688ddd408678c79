// SPDX-License-Identifier: MIT
// A NURBS curve of degree 1 to 9, as a function of its arc length.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/core/result.hpp"
#include "motion/geometry/arc_length.hpp"
#include "motion/geometry/bezier.hpp"
#include "motion/geometry/curve.hpp"
#include "motion/geometry/nurbs_spec.hpp"
#include "motion/geometry/span_place.hpp"

namespace softcnc {

/// Position and the first three derivatives by the parameter u (mm, mm/u, ...).
using NurbsDerivatives = std::array<AxisVector, 4>;

class Nurbs {
 public:
  static constexpr int kMaxDegree = kMaxBezierDegree;

  /// Checks the specification, turns every span into a Bezier segment and measures the curve.
  /// Errors: the SC30xx codes. The caller sets the position of the error.
  static Result<Nurbs> make(NurbsSpec spec);

  double length() const noexcept { return map_.length(); }
  /// Where the curve stands still, dq is its limit, and ddq and dddq, which may have none, are
  /// those a little further on `side`.
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
  double parameter(double s) const noexcept;
  double arc_length(double u) const noexcept;

  const NurbsSpec& spec() const noexcept { return spec_; }

 private:
  Nurbs() = default;
  void make_segments();
  void find_breaks();

  double width(int span) const noexcept;  // in u
  SpanPlace place(double u, Side side) const noexcept;
  /// `order` derivatives by t.
  template <int order>
  std::array<AxisVector, order + 1> evaluate(const SpanPlace& place) const noexcept;
  double span_speed(const SpanPlace& place) const noexcept;  // by t
  double standstill(int span) const noexcept;                // speed that counts as none
  PathPoint past(const SpanPlace& place, Side side) const noexcept;
  AxisVector end_tangent(const SpanPlace& place) const noexcept;
  SpanPlace slowest(const ArcLengthMap::Crowd& crowd) const noexcept;

  NurbsSpec spec_;
  std::vector<double> span_knots_;     // distinct knots: span i is [i, i + 1]
  std::vector<Homogeneous> segments_;  // Bezier points of each span, about its origin
  std::vector<AxisVector> origins_;
  double weight_ = 0;  // of all control points; 0 where they differ
  ArcLengthMap map_;
  std::vector<double> breaks_;
};

static_assert(Curve<Nurbs>);

}  // namespace softcnc
