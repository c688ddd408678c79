// SPDX-License-Identifier: MIT
// What the ramps of a plan require of the axes, also between its nodes, where no constraint has
// been evaluated.
#pragma once

#include <vector>

#include "ipo/jerk_limited/plan_nodes.hpp"
#include "ipo/jerk_limited/plan_problem.hpp"
#include "ipo/path/ramp.hpp"

namespace softcnc::ipo {

/// What a ramp uses, as parts of what is allowed: of the axis accelerations and jerks, on the path
/// itself, and of the velocity limit.
struct Used {
  double constraints = 0, velocity = 0;

  bool keeps() const noexcept { return constraints <= 1 && velocity <= 1; }
};

/// Evaluates a ramp at a few instants of the motion as it will be run; `i` is the interval in which
/// it begins. Jumps at joints around it do not count.
Used used_by(const PlanSpan& span, std::size_t i, const Ramp& ramp, double max_q);

/// Evaluates all ramps, each from its node to the next.
std::vector<Used> used_by(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                          const PlanProblem& problem, const std::vector<Ramp>& ramps);

}  // namespace softcnc::ipo
