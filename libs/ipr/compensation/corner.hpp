// SPDX-License-Identifier: MIT
// The corner between two moves of a contour, seen from the side on which the tool runs.
#pragma once

#include "ipr/compensation/plane_curve.hpp"

namespace softcnc::ipr {

enum class Corner : std::uint8_t {
  none,     // the parallels join
  outside,  // the tool turns around the corner
  inside,   // the parallels are cut off where they meet
};

/// Returns the kind of the corner between two moves. `side` is 1 for a tool on the left and -1 for
/// one on the right; `radius` is that of the tool, mm.
Corner corner_between(const PlaneCurve& before, const PlaneCurve& after, int side, double radius);

}  // namespace softcnc::ipr
