// SPDX-License-Identifier: MIT
// What the ramps of a plan ask of the axes, between its nodes too, where no row has looked.
#pragma once

#include <vector>

#include "ipo/jerk/plan_nodes.hpp"
#include "ipo/jerk/plan_problem.hpp"
#include "ipo/path/ramp.hpp"

namespace softcnc::ipo {

/// What a ramp uses, in parts of what is allowed: of the axis accelerations and jerks, on the path
/// itself, and of the cap.
struct Used {
  double rows = 0, cap = 0;

  bool keeps() const noexcept { return rows <= 1 && cap <= 1; }
};

/// At a few instants of the motion as it will be driven; `i`: interval in which it begins. Joints
/// around are not felt.
Used used_by(const PlanSpan& span, std::size_t i, const Ramp& ramp, double cap);

/// By ramp, each from its node to the next.
std::vector<Used> used_by(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                          const PlanProblem& problem, const std::vector<Ramp>& ramps);

}  // namespace softcnc::ipo
