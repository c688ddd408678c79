// SPDX-License-Identifier: MIT
// The cubic spline through given points, as a NURBS (paper 003, chapter 4: the Ferguson curve).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "motion/core/axes.hpp"
#include "motion/core/result.hpp"
#include "motion/geometry/nurbs_spec.hpp"

namespace softcnc {

/// Two points closer than this are one, mm.
inline constexpr double kSplineSamePoint = 1e-9;

/// A spline is global: every point changes all of it. Collectors of points stop here, so that
/// memory stays bounded.
inline constexpr std::size_t kMaxSplinePoints = 10000;

/// How far the parameter goes on from one point to the next, in mm: by the length of the chord, so
/// that unequal distances neither overshoot nor loop, or by the same everywhere, the mean chord. At
/// equal distances both are the same curve; paper 003 does not say which one it has.
enum class SplineParameter : std::uint8_t { chord_length, uniform };
inline constexpr std::array<std::string_view, 2> kSplineParameterNames{"chord-length", "uniform"};

/// Directions of the curve at its ends, of any length but 0. An end without one is natural: it has
/// no curvature. The curve leaves an end with a direction as fast as its first chord, by the
/// parameter.
struct SplineEnds {
  std::optional<AxisVector> first, last;
};

/// Returns the C2 cubic through the points in their order as an exact NURBS of degree 3 whose
/// weights are 1. The knots are the parameters of the points. Errors: SC2350 fewer than two points,
/// SC2351 two consecutive points that are the same. The caller sets the position; points count from
/// 1 in the message.
Result<NurbsSpec> cubic_spline(std::span<const AxisVector> points,
                               SplineParameter parameter = SplineParameter::chord_length,
                               const SplineEnds& ends = {});

}  // namespace softcnc
