// SPDX-License-Identifier: MIT
// The first move under cutter compensation.
#pragma once

#include "ipr/compensation/plane_curve.hpp"

namespace softcnc::ipr {

/// Returns the first move of the tool, which ends `left` mm to the left of the end of `move`
/// (negative: to the right), in the same direction: for a line its parallel, for an arc the one
/// that begins where the move does. Returns nothing if there is none.
std::optional<PlaneCurve> entry_beside(const PlaneCurve& move, double left);

}  // namespace softcnc::ipr
