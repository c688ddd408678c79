// SPDX-License-Identifier: MIT
// How the literature finds the next point on a NURBS within a period, kept for comparison with
// interpolation by exact arc length.
#pragma once

#include "motion/geometry/nurbs.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// One NURBS block, traversed by the parameter u instead of the arc length.
class ParameterWalk {
 public:
  /// Requires a method other than arc_length. `nurbs` must outlive the walk.
  ParameterWalk(const Nurbs& nurbs, Method method, double chord_tolerance) noexcept;

  /// Realtime. Steps ahead by about `ds` mm and stops at the end of the curve:
  ///   taylor1      du = ds / |P'|                                     (000 eq. 6, first order)
  ///   taylor2      du = ds / |P'| - ds^2 (P' . P'') / (2 |P'|^4)      (004 eq. 7)
  ///   curvature3p  ds limited to sqrt(8 eps / kappa), kappa from the last three points (the
  ///               exact one until there are three), and
  ///                du = ds / |P'| with P' of the point before         (000 section 3.2)
  void step(double ds) noexcept;

  /// Whether the method covers all of `ds`, because its step is not too long for the chord
  /// tolerance.
  bool takes(double ds) const noexcept;

  /// Rebinds to the curve after it has moved in memory; the walk stays where it is.
  void rebind(const Nurbs& nurbs) noexcept { nurbs_ = &nurbs; }

  AxisVector position() const noexcept;
  /// Returns the arc length from the start of the curve to where the walk is, mm.
  double s() const noexcept;

 private:
  double increment(double ds) const noexcept;
  double from_standstill(double ds) const noexcept;
  double chord_limited(double ds) const noexcept;
  double exact_curvature() const noexcept;

  const Nurbs* nurbs_;
  Method method_;
  double chord_tolerance_;
  double u_, u_before_;
  AxisVector last_[3];  // the last three points, newest first
  int points_ = 1;
};

/// Returns the curvature of the circle through three points, 1/mm; 0 if they lie on a line.
double three_point_curvature(const AxisVector& a, const AxisVector& b,
                             const AxisVector& c) noexcept;

}  // namespace softcnc::ipo
