// SPDX-License-Identifier: MIT
// A place between two lines of a run, and the line behind it.
#pragma once

#include <cstddef>

#include "ipo/path/piece.hpp"
#include "motion/core/axes.hpp"

namespace softcnc::ipo {

struct LineVertex {
  AxisVector point = AxisVector::Zero();
  double t = 0;  // mm along the lines
  AxisVector direction = AxisVector::Zero();
  AxisVector kink = AxisVector::Zero();
  double turn = 0;             // |kink|
  double tolerance = 0;        // mm, of the curve from the lines here
  double deviation = 0;        // mm, of the line behind from the programmed ones
  double reach = 0;            // W
  double width = 0;            // w
  double spacing = 0;          // mm, of knots that lines like these may bear
  std::size_t programmed = 0;  // lines before it
  bool dense = false;
  Manner manner;

  /// Of the line behind, at t.
  AxisVector at(double place) const { return point + (place - t) * direction; }
};

}  // namespace softcnc::ipo
