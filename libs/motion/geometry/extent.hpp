// SPDX-License-Identifier: MIT
// How far a path reaches along each axis: its true extrema, wherever on it they lie.
#pragma once

#include "motion/geometry/path.hpp"

namespace softcnc {

/// A box around points.
struct Extent {
  AxisVector min, max;

  explicit Extent(const AxisVector& point) : min(point), max(point) {}
  void include(const AxisVector& point) noexcept {
    min = min.cwiseMin(point);
    max = max.cwiseMax(point);
  }
};

/// The smallest box around every point of the path; of a NURBS to 1e-9 mm.
Extent extent(const Path& path);

/// A box that surely holds all of the path, quickly found: for a line and an arc the smallest one,
/// for a NURBS that of its control points.
Extent bounds(const Path& path);

}  // namespace softcnc
