// SPDX-License-Identifier: MIT
// A vertex between two lines of a polyline, and the line after it.
#pragma once

#include <cstddef>

#include "ipo/path/piece.hpp"
#include "motion/core/axes.hpp"

namespace softcnc::ipo {

struct LineVertex {
  AxisVector point = AxisVector::Zero();
  double t = 0;  // mm along the lines
  AxisVector direction = AxisVector::Zero();
  AxisVector tangent_jump = AxisVector::Zero();
  double turn = 0;             // |tangent_jump|
  double tolerance = 0;        // mm, of the curve from the lines here
  double deviation = 0;        // mm, of the line after it from the programmed ones
  double width_limit = 0;      // W
  double width = 0;            // w
  double spacing = 0;          // mm, of knots that lines like these allow
  std::size_t programmed = 0;  // lines before it
  bool dense = false;
  MoveAttributes attributes;

  /// Returns the point of the line after it at t.
  AxisVector at(double place) const { return point + (place - t) * direction; }
};

}  // namespace softcnc::ipo
