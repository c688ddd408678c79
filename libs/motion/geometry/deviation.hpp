// SPDX-License-Identifier: MIT
// The distance of a point from paths, or from a line segment.
#pragma once

#include "motion/geometry/path.hpp"

namespace softcnc {

/// Returns the distance, mm, of p from the segment from a to b; they may be the same point.
double distance_to_segment(const AxisVector& p, const AxisVector& a, const AxisVector& b) noexcept;

/// A part of a path, mm.
struct Portion {
  const Path* path;
  double s0, s1;
};

/// Returns the arc length between `portion.s0` and `portion.s1` at which the path is nearest to
/// `point`: the minimum that Newton's method finds from `guess`.
double nearest(const Portion& portion, const AxisVector& point, double guess) noexcept;

/// Returns where the whole portion comes nearest to `point`: no other place is nearer by more than
/// a thousandth of the distance and a nanometre.
double nearest(const Portion& portion, const AxisVector& point) noexcept;

}  // namespace softcnc
