// SPDX-License-Identifier: MIT
// The curve of least jerk in the tube around a stretch of lines.
//
// Over the control points of a spline of degree 5, whose parameter t is the length of the lines,
//
//     integral of (v^3 |c'''| / J)^2 + mu |n . (c - p)|^2 / P^2   dt
//
// is minimised, v being the speed that the curvature of the last solution permits, so that the
// first term is 1 where the jerk limit is met; |n . (c - p)| <= P at places of every line, n being
// across it, and |t . (c - p)| small against P. The second term keeps the curve in the middle of
// the tube where nothing is gained by leaving it. How far the curve really is from the lines is
// then measured (tube_check.hpp), and where it is too far the bound is tightened for the next
// solution.
#pragma once

#include <vector>

#include "ipo/rebuild/guide.hpp"
#include "ipo/rebuild/quintic.hpp"
#include "ipo/rebuild/speed_estimate.hpp"
#include "ipo/rebuild/tube_check.hpp"

namespace softcnc::ipo {

struct TubeWindow {
  QuinticSpline spline;                   // where the solution begins from, then the solution
  std::size_t fixed_first = 0;            // control points that stay, at its beginning
  std::size_t fixed_last = 0;             // and at its end
  const QuinticSpline* before = nullptr;  // the last solution, which it continues
  std::size_t first_span = 0;             // the spans before shape only what has been settled
  std::vector<double> tightened;          // of the tolerance, by span
  std::vector<Foot> feet{};               // where the solution passes the vertices of the lines
  double furthest = 0;                    // mm
};

/// Returns false where no curve was found that stays in the tube.
bool solve(TubeWindow& window, const Guide& guide, const ShapeLimits& limits);

}  // namespace softcnc::ipo
