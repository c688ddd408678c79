// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/plan_jumps.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/corner_limits.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

double felt_time(const PlanSpan& span) noexcept {
  return tuning::joints::kJumpPeriods * span.constraints.limits().fine_period;
}

/// Returns the least time, s, in which anything that passes the joint covers a distance. It has
/// gained its acceleration a from rest, so that a^2 <= 2 j v, and dv/dt <= sqrt(2 j v) after it.
double fewest_seconds(const CurvatureJump& jump, double distance) noexcept {
  const double v = jump.fastest, j = jump.most_j;
  const double by_acceleration = 2 * distance / (v + std::sqrt(v * v + 2 * jump.most_u * distance));
  if (!(j < kUnlimited)) return by_acceleration;
  const double rise = std::sqrt(0.5 * j);  // of sqrt(v)
  return std::max(by_acceleration,
                  (std::cbrt(v * std::sqrt(v) + 3 * rise * distance) - std::sqrt(v)) / rise);
}

/// Returns a distance, mm: nothing that passes the joint is further away while the jump matters.
double farthest(const PlanSpan& span, const CurvatureJump& jump) noexcept {
  const double t = felt_time(span), v = jump.fastest;
  const double by_acceleration = (v + 0.5 * jump.most_u * t) * t;
  return std::min(by_acceleration,
                  (v + 0.5 * (std::sqrt(2 * jump.most_j * v) + jump.most_j * t / 3) * t) * t);
}

CurvatureJump jump_at(const PlanSpan& span, std::size_t n) noexcept {
  const Node& node = span.chain.nodes[n];
  const Directions around = span.chain.directions_around(n, felt_time(span));
  return {node.s,
          std::min(std::sqrt(node.velocity_limit.q),
                   fastest_beside_rest(span.chain, span.constraints, n)),
          span.constraints.most_u(around),
          tuning::joints::kCurved * around.most(span.constraints.limits().jerk),
          node.curvature_jump,
          std::nullopt};
}

/// Returns the highest q at a node of a plan.
double highest_q(const PlanSpan& span, const PlanNode& node) noexcept {
  const Chain& chain = span.chain;
  return std::max({chain.inside[node.interval].velocity_limit.q,
                   chain.nodes[node.interval].velocity_limit.q,
                   chain.nodes[node.interval + 1].velocity_limit.q});
}

/// Adds what a jump takes at a node, `per_second` times that of its acceleration.
void add_jump(const PlanSpan& span, const PlanNode& node, const CurvatureJump& jump,
              double per_second, NodeLoad& load) noexcept {
  const double q = jump.fastest * jump.fastest;
  const AxisVector whole = load.whole + jump.ddq.cwiseAbs() * (q * per_second);
  const AxisVector most = tuning::joints::kWholeJump * span.jerk_limits();
  if (q <= tuning::joints::kFarSlower * highest_q(span, node) &&
      (whole.array() <= most.array()).all())
    load.whole = whole;
  else
    load.per_q.add(jump.ddq * per_second);
}

}  // namespace

std::vector<CurvatureJump> find_jumps(const PlanSpan& span, const std::vector<PlanNode>& nodes) {
  const auto& chain = span.chain.nodes;
  std::vector<CurvatureJump> jumps;
  double time = 0;
  for (std::size_t n = span.first + 1; n-- > 0 && time < felt_time(span);) {
    if (chain[n].passes_curvature_jump()) {
      const CurvatureJump jump = jump_at(span, n);
      if (nodes.front().s - jump.s <= farthest(span, jump)) jumps.push_back(jump);
    }
    if (n > 0) time += span.interval(n - 1).shortest_time();
  }
  std::reverse(jumps.begin(), jumps.end());
  for (std::size_t p = 1; p + 1 < nodes.size(); ++p) {
    const Node& node = chain[nodes[p].interval];
    if (!nodes[p].joint || !node.passes_curvature_jump()) continue;
    jumps.push_back(jump_at(span, nodes[p].interval));
    jumps.back().node = p;
  }
  return jumps;
}

std::vector<NodeLoad> curvature_jump_loads(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                                           const std::vector<CurvatureJump>& jumps) {
  const double period = span.constraints.limits().fine_period;
  std::vector<NodeLoad> loads(nodes.size());
  for (const CurvatureJump& jump : jumps) {
    const double most = farthest(span, jump);
    const auto first = std::partition_point(
        nodes.begin(), nodes.end(), [&](const PlanNode& node) { return node.s < jump.s - most; });
    for (auto node = first; node != nodes.end() && node->s <= jump.s + most; ++node) {
      const double periods = fewest_seconds(jump, std::abs(node->s - jump.s)) / period;
      const double weight = jump_weight(std::max(periods - tuning::joints::kJumpNearer, 0.0));
      add_jump(span, *node, jump, weight / period,
               loads[static_cast<std::size_t>(node - nodes.begin())]);
    }
  }
  return loads;
}

PassedJumps::PassedJumps(const PlanSpan& span, const std::vector<CurvatureJump>& jumps,
                         double start_s, const SpeedSquare& start, const std::vector<Ramp>& ramps)
    : period_(span.constraints.limits().fine_period) {
  passed_.reserve(jumps.size());
  double t = 0;
  std::size_t p = 0;
  const auto pass = [&](const CurvatureJump& jump, double at, double q) {
    passed_.push_back({at, jump.ddq * (q / period_)});
  };
  for (const CurvatureJump& jump : jumps) {
    if (!jump.node) {
      const double distance = start_s - jump.s, most = jump.fastest * jump.fastest;
      pass(jump, -distance / std::sqrt(start.q),
           std::clamp(start.q - distance * start.dq, 0.0, most));
      continue;
    }
    for (; p < *jump.node; ++p) t += ramps[p].duration;
    pass(jump, t, ramps[p].v0 * ramps[p].v0);
  }
}

CurvatureJumpLoad PassedJumps::at(double t) noexcept {
  const double felt = tuning::joints::kJumpPeriods * period_;
  while (first_ < passed_.size() && passed_[first_].t < t - felt) ++first_;
  CurvatureJumpLoad load;
  for (std::size_t k = first_; k < passed_.size() && passed_[k].t < t + felt; ++k)
    load.add(passed_[k].jump * jump_weight(std::abs(t - passed_[k].t) / period_));
  return load;
}

}  // namespace softcnc::ipo
