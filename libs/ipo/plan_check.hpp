// SPDX-License-Identifier: MIT
// What a plan asks of the axes between its nodes, where no row has looked.
#pragma once

#include <vector>

#include "ipo/plan_nodes.hpp"
#include "ipo/speed_problem.hpp"

namespace softcnc::ipo {

/// By interval between two nodes: what its middle uses, in parts of what is allowed there.
/// Acceleration and jerk are those of the axes, on the path itself.
struct Used {
  double rows = 0, cap = 0;
};
std::vector<Used> used_between(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                               const SpeedProblem& problem,
                               const std::vector<double>& coefficients);

}  // namespace softcnc::ipo
