// SPDX-License-Identifier: MIT
// The cubic spline through given points, as a NURBS (paper 003, chapter 4: the Ferguson curve).
#pragma once

#include <span>

#include "motion/core/axes.hpp"
#include "motion/core/result.hpp"
#include "motion/geometry/nurbs_spec.hpp"

namespace softcnc {

/// Two points closer than this are one, mm.
inline constexpr double kSplineSamePoint = 1e-9;

/// A spline is global: every point changes all of it. Collectors of points stop here, so that
/// memory stays bounded.
inline constexpr std::size_t kMaxSplinePoints = 10000;

/// Returns the C2 cubic through the points in their order, its ends natural (no curvature), as an
/// exact NURBS of degree 3 whose weights are 1. The parameter is the sum of the chords, in mm: so
/// unequal distances neither overshoot nor loop, and dC/du is nearly a unit vector. The knots are
/// the parameters of the points. Errors: SC2350 fewer than two points, SC2351 two consecutive
/// points that are the same. The caller sets the position; points count from 1 in the message.
Result<NurbsSpec> natural_spline(std::span<const AxisVector> points);

}  // namespace softcnc
