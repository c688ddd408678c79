// SPDX-License-Identifier: MIT
// Lines and arcs in the plane of X and Y.
#pragma once

#include "motion/geometry/path.hpp"

namespace softcnc::test {

inline Line line(const AxisVector& from, const AxisVector& to) { return {from, to}; }

inline Arc arc(const AxisVector& from, const AxisVector& to, const AxisVector& center, bool ccw) {
  return Arc::make({from, to, center, Plane::xy, ccw, 0}).value();
}

/// About the origin, counter-clockwise from X.
inline Arc circle(double radius) {
  return arc({radius, 0, 0}, {radius, 0, 0}, AxisVector::Zero(), true);
}

}  // namespace softcnc::test
