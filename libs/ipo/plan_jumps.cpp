// SPDX-License-Identifier: MIT
#include "ipo/plan_jumps.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// mm: nothing that passes a joint at v comes further within the reach of the jump.
double farthest(const PlanSpan& span, double v) noexcept {
  const double t = kJumpReach * span.constraints.fine_period();
  return (v + 0.5 * span.constraints.acceleration_limits().norm() * t) * t;
}

/// Nothing that passes a joint at v takes fewer periods for a way.
double fewest_periods(const PlanSpan& span, double v, double way) noexcept {
  const double a = span.constraints.acceleration_limits().norm();
  return 2 * way / (v + std::sqrt(v * v + 2 * a * way)) / span.constraints.fine_period();
}

BendJump jump_at(const Node& node) noexcept {
  return {node.s, std::sqrt(node.cap.q), node.bend, std::nullopt};
}

}  // namespace

std::vector<BendJump> find_jumps(const PlanSpan& span, const std::vector<PlanNode>& nodes) {
  const auto& chain = span.chain.nodes;
  std::vector<BendJump> jumps;
  for (std::size_t n = span.first + 1; n-- > 0;) {
    if (nodes.front().s - chain[n].s > farthest(span, std::sqrt(chain[n].cap.q))) break;
    if (chain[n].passes_bend()) jumps.push_back(jump_at(chain[n]));
  }
  std::reverse(jumps.begin(), jumps.end());
  for (std::size_t p = 1; p + 1 < nodes.size(); ++p) {
    const Node& node = chain[nodes[p].interval];
    if (!nodes[p].joint || !node.passes_bend()) continue;
    jumps.push_back(jump_at(node));
    jumps.back().node = p;
  }
  return jumps;
}

std::vector<JumpLoad> jump_loads(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                                 const std::vector<BendJump>& jumps) {
  std::vector<JumpLoad> loads(nodes.size());
  for (const BendJump& jump : jumps) {
    const double most = farthest(span, jump.fastest);
    const auto first = std::partition_point(
        nodes.begin(), nodes.end(), [&](const PlanNode& node) { return node.s < jump.s - most; });
    for (auto node = first; node != nodes.end() && node->s <= jump.s + most; ++node) {
      const double periods = fewest_periods(span, jump.fastest, std::abs(node->s - jump.s));
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
