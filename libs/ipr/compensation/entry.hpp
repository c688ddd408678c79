// SPDX-License-Identifier: MIT
// The first move under cutter compensation.
#pragma once

#include "ipr/compensation/plane_curve.hpp"

namespace softcnc::ipr {

/// Ends at this distance to the left of the move's end (negative: to the right), mm, in the same
/// direction: of a line the parallel; of an arc the one that begins where the move does. Nothing,
/// if there is none.
std::optional<PlaneCurve> entry_beside(const PlaneCurve& move, double left);

}  // namespace softcnc::ipr
