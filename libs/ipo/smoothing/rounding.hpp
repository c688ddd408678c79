// SPDX-License-Identifier: MIT
// A polyline with its turns spread out: a cubic spline whose second derivative is a sum of
// triangular basis functions.
//
// A polyline p(t) turns by jumps of p' at its vertices: p'' is a sum of impulses, k_i at t_i. Each
// is spread over a basis function, a triangle of the same area from `begin` over `peak` to `end`
// whose centroid is t_i. The curve c(t) with that second derivative is a cubic spline with
// continuous curvature, and the polyline itself where no basis function is. Symmetric basis
// functions of half-width w_i make c(t) differ from p(t) by the sum of k_i g_i(t), with
//
//     g_i(t) = (w_i - |t - t_i|)^3 / (6 w_i^2)   within w_i of t_i, and 0 elsewhere.
//
// So a single turn of |k| = 2 sin(theta / 2) is off by w |k| / 6 in its middle and nowhere by more;
// several together are off by at most the sum of |k_i| g_i, which is largest at a vertex.
#pragma once

#include <span>
#include <vector>

#include "ipo/tuning.hpp"
#include "motion/geometry/nurbs.hpp"

namespace softcnc::ipo {

/// A turn and its basis function; everything except the tangent jump is in mm along the polyline.
struct Turn {
  double t = 0;
  AxisVector tangent_jump = AxisVector::Zero();
  double begin = 0, peak = 0, end = 0;  // t is their mean
};

/// Returns a turn with a symmetric basis function.
Turn spread_evenly(double t, const AxisVector& tangent_jump, double width);

/// Returns g for a turn at such a distance, mm.
double rounding(double distance, double width) noexcept;

/// One line of the polyline, and from where on the path follows it.
struct PolylineEdge {
  double t;
  AxisVector point, direction;
};

/// Returns the curve from t0 to t1 by its parameter u = t - t0. `edges` cover that part; `turns`
/// are all that touch it.
NurbsSpec rounded(std::span<const PolylineEdge> edges, std::span<const Turn> turns, double t0,
                  double t1);

/// Whether two parameters are near each other, and not the same.
inline bool is_close(double a, double b, double least) noexcept {
  const double off = a < b ? b - a : a - b;
  return off < least && off > tuning::knots::kSamePlace;
}

}  // namespace softcnc::ipo
