// SPDX-License-Identifier: MIT
// A polyline with its turns spread out: a cubic spline whose second derivative is a sum of hats.
//
// A polyline p(t), t its own length, turns by jumps of its direction at its vertices: p'' is a sum
// of impulses, k_i at t_i. Each is spread over the hat of half-width w_i around it, of the same
// area. The curve c(t) whose second derivative that is, is a cubic spline with continuous
// curvature, and differs from p(t) by the sum of k_i g_i(t), with
//
//     g_i(t) = (w_i - |t - t_i|)^3 / (6 w_i^2)   within w_i of t_i, and 0 elsewhere.
//
// So a turn of |k| = 2 sin(theta / 2) alone is off by w |k| / 6 in its middle and nowhere by more;
// several together are off by no more than the sum of |k_i| g_i, which is largest at a vertex.
#pragma once

#include <span>
#include <vector>

#include "motion/nurbs.hpp"

namespace softcnc::ipo {

struct Turn {
  double t = 0;      // mm along the polyline
  double width = 0;  // mm: half of the hat
  AxisVector kink = AxisVector::Zero();

  double begin() const noexcept { return t - width; }
  double end() const noexcept { return t + width; }
};

/// g, for a turn at such a distance, mm.
double rounding(double distance, double width) noexcept;

/// One line of the polyline, and from where on the path is on it.
struct Edge {
  double t;
  AxisVector point, direction;
};

/// The curve from t0 to t1 by its parameter u = t - t0. `edges` reach over that stretch; `turns`
/// are all that touch it.
NurbsSpec rounded(std::span<const Edge> edges, std::span<const Turn> turns, double t0, double t1);

/// Parameters closer than this are one, mm.
inline constexpr double kSamePlace = 1e-9;

}  // namespace softcnc::ipo
