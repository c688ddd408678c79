// SPDX-License-Identifier: MIT
// The places of the lines at which a curve is held to them.
#pragma once

#include <vector>

#include "ipo/rebuild/tube_window.hpp"

namespace softcnc::ipo {

struct Tie {
  double t;
  std::size_t span;
  std::size_t line;
  bool vertex;
  AxisVector point, tangent;
  double tolerance;
  double slip;    // mm along the lines
  double weight;  // mm of the lines for which it stands
};

/// Returns the vertices inside a window, and places between them where lines are long against knot
/// spans, in their order.
std::vector<Tie> ties_of(const TubeWindow& window, const Guide& guide);

}  // namespace softcnc::ipo
