// SPDX-License-Identifier: MIT
// The extent of a path along each axis: its true extrema, wherever they lie on it.
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

/// Returns the smallest box around every point of the path; for a NURBS to 1e-9 mm.
Extent extent(const Path& path);

/// Returns a box that surely contains all of the path, quickly computed: for a line and an arc the
/// smallest one, for a NURBS that of its control points.
Extent bounds(const Path& path);

}  // namespace softcnc
