// SPDX-License-Identifier: MIT
// How far a point lies from paths, or from a straight way between two others.
#pragma once

#include "motion/geometry/path.hpp"

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

/// Where the whole portion comes nearest to `point`: no other place is nearer by more than a
/// thousandth of the distance and a nanometre.
double nearest(const Portion& portion, const AxisVector& point) noexcept;

}  // namespace softcnc
