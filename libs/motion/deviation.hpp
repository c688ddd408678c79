// SPDX-License-Identifier: MIT
// How far a point lies from paths, or from a straight way between two others.
#pragma once

#include <span>

#include "motion/path.hpp"

namespace softcnc {

/// Distance, mm, of p from the straight way from a to b; they may be the same point.
double distance_to_segment(const AxisVector& p, const AxisVector& a, const AxisVector& b) noexcept;

/// A part of a path, mm.
struct Portion {
  const Path* path;
  double s0, s1;
};

/// The arc length between `portion.s0` and `portion.s1` at which the path is nearest to `point`:
/// the minimum that Newton's method finds from `guess`.
double nearest(const Portion& portion, const AxisVector& point, double guess) noexcept;

/// Distance, mm, of a point from what is nearest among several paths. Each is searched at
/// `samples` places, and from the nearest of them by Newton's method.
double distance(std::span<const Portion> portions, const AxisVector& point,
                int samples = 32) noexcept;

}  // namespace softcnc
