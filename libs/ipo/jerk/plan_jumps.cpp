// SPDX-License-Identifier: MIT
#include "ipo/jerk/plan_jumps.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

double reach(const PlanSpan& span) noexcept { return kJumpReach * span.constraints.fine_period(); }

/// mm: nothing that passes the joint comes further within the reach of the jump.
double farthest(const PlanSpan& span, const BendJump& jump) noexcept {
  const double t = reach(span);
  return (jump.fastest + 0.5 * jump.most_u * t) * t;
}

/// Nothing that passes the joint takes fewer periods for a way.
double fewest_periods(const PlanSpan& span, const BendJump& jump, double way) noexcept {
  const double v = jump.fastest;
  return 2 * way / (v + std::sqrt(v * v + 2 * jump.most_u * way)) / span.constraints.fine_period();
}

BendJump jump_at(const PlanSpan& span, std::size_t n) noexcept {
  const Node& node = span.chain.nodes[n];
  const Directions around = span.chain.directions_around(n, reach(span));
  return {node.s, std::sqrt(node.cap.q), span.constraints.most_u(around), node.bend, std::nullopt};
}

}  // namespace

std::vector<BendJump> find_jumps(const PlanSpan& span, const std::vector<PlanNode>& nodes) {
  const auto& chain = span.chain.nodes;
  std::vector<BendJump> jumps;
  for (std::size_t n = span.first + 1; n-- > 0;) {
    const BendJump jump = jump_at(span, n);
    if (nodes.front().s - jump.s > farthest(span, jump)) break;
    if (chain[n].passes_bend()) jumps.push_back(jump);
  }
  std::reverse(jumps.begin(), jumps.end());
  for (std::size_t p = 1; p + 1 < nodes.size(); ++p) {
    const Node& node = chain[nodes[p].interval];
    if (!nodes[p].joint || !node.passes_bend()) continue;
    jumps.push_back(jump_at(span, nodes[p].interval));
    jumps.back().node = p;
  }
  return jumps;
}

std::vector<JumpLoad> jump_loads(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                                 const std::vector<BendJump>& jumps) {
  std::vector<JumpLoad> loads(nodes.size());
  for (const BendJump& jump : jumps) {
    const double most = farthest(span, jump);
    const auto first = std::partition_point(
        nodes.begin(), nodes.end(), [&](const PlanNode& node) { return node.s < jump.s - most; });
    for (auto node = first; node != nodes.end() && node->s <= jump.s + most; ++node) {
      const double periods = fewest_periods(span, jump, std::abs(node->s - jump.s));
      const double weight = jump_weight(std::max(periods - kJumpNearer, 0.0));
      loads[static_cast<std::size_t>(node - nodes.begin())].add(
          jump.bend * (weight / span.constraints.fine_period()));
    }
  }
  return loads;
}

PassedJumps::PassedJumps(const PlanSpan& span, const std::vector<BendJump>& jumps, double start_s,
                         const SpeedSquare& start, const std::vector<Ramp>& ramps)
    : period_(span.constraints.fine_period()) {
  passed_.reserve(jumps.size());
  double t = 0;
  std::size_t p = 0;
  const auto pass = [&](const BendJump& jump, double at, double q) {
    passed_.push_back({at, jump.bend * (q / period_)});
  };
  for (const BendJump& jump : jumps) {
    if (!jump.node) {
      const double way = start_s - jump.s, most = jump.fastest * jump.fastest;
      pass(jump, -way / std::sqrt(start.q), std::clamp(start.q - way * start.dq, 0.0, most));
      continue;
    }
    for (; p < *jump.node; ++p) t += ramps[p].duration;
    pass(jump, t, ramps[p].v0 * ramps[p].v0);
  }
}

JumpLoad PassedJumps::at(double t) noexcept {
  const double reach = kJumpReach * period_;
  while (first_ < passed_.size() && passed_[first_].t < t - reach) ++first_;
  JumpLoad load;
  for (std::size_t k = first_; k < passed_.size() && passed_[k].t < t + reach; ++k)
    load.add(passed_[k].jump * jump_weight(std::abs(t - passed_[k].t) / period_));
  return load;
}

}  // namespace softcnc::ipo
