// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/plan_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ipo/path/curvature_jump_load.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

bool same(const AxisVector& a, const AxisVector& b) noexcept {
  return (a - b).norm() <= tuning::nodes::kSame * (a.norm() + b.norm());
}

bool is_joint(const PlanSpan& span, std::size_t node) noexcept {
  const Interval &before = span.interval(node - 1), &after = span.interval(node);
  return before.ends_move || !same(before.right.dq, after.left.dq) ||
         !same(before.right.ddq, after.left.ddq) || !same(before.right.dddq, after.left.dddq);
}

/// Returns how far, mm, beside a joint at which x'' jumps that matters most, so that a node is to
/// be there; 0 where it hardly counts.
double jump_step(const PlanSpan& span, std::size_t joint) noexcept {
  const Node& node = span.chain.nodes[joint];
  if (!node.passes_curvature_jump()) return 0;
  const double period = span.constraints.limits().fine_period;
  const double used =
      node.curvature_jump.cwiseAbs().cwiseQuotient(span.constraints.limits().jerk).maxCoeff() *
      node.velocity_limit.q;
  return used > tuning::nodes::kFeltJump * period
             ? (tuning::joints::kJumpFlat + tuning::joints::kJumpNearer) * period *
                   std::sqrt(node.velocity_limit.q)
             : 0;
}

/// Returns the spacing that steep limits require where the path is level.
double limit_spacing(const Interval& in) noexcept {
  const VelocityLimit &left = in.left_limit, &right = in.right_limit;
  const double change = std::abs(right.q - left.q);
  if (!is_steep(left.limit) && !is_steep(right.limit)) return kUnlimited;
  return change > 0 ? tuning::nodes::kLimitChange * std::min(left.q, right.q) * in.length() / change
                    : kUnlimited;
}

/// The spacing that the curvature of the path and its velocity limits require, at the nodes of the
/// chain.
class CurvatureSpacing {
 public:
  explicit CurvatureSpacing(const PlanSpan& span)
      : span_(span), h_(span.last - span.first + 1, 0.0) {
    std::fill(h_.begin(), h_.end(), kUnlimited);
    for (std::size_t i = span.first; i < span.last; ++i) {
      const Interval& in = span.interval(i);
      const double h =
          std::min(tuning::nodes::kTurn / std::max(in.left.ddq.norm(), in.right.ddq.norm()),
                   limit_spacing(in));
      at(i) = std::min(at(i), h);
      at(i + 1) = std::min(at(i + 1), h);
    }
    for (std::size_t i = span.first; i < span.last; ++i)
      at(i + 1) = std::min(at(i + 1), at(i) + tuning::nodes::kGrading * span.interval(i).length());
    for (std::size_t i = span.last; i-- > span.first;)
      at(i) = std::min(at(i), at(i + 1) + tuning::nodes::kGrading * span.interval(i).length());
  }

  double operator()(std::size_t i, double s) const noexcept {
    const double left = h_[i - span_.first], right = h_[i + 1 - span_.first];
    return std::min(left + tuning::nodes::kGrading * (s - span_.s(i)),
                    right + tuning::nodes::kGrading * (span_.s(i + 1) - s));
  }

 private:
  double& at(std::size_t node) noexcept { return h_[node - span_.first]; }

  const PlanSpan& span_;
  std::vector<double> h_;
};

/// The nodes of a plan, from one joint to the next.
class NodePlacement {
 public:
  NodePlacement(const PlanSpan& span, const SpeedGuess& guess, double from)
      : span_(span),
        guess_(guess),
        curvature_spacing_(span),
        shortest_(tuning::nodes::kShortestTime * span.constraints.limits().fine_period),
        nodes_{{span.first, from, false}},
        interval_(span.first),
        begin_(from) {}

  void begin_with(std::span<const ProvenNode> given) {
    for (const ProvenNode& node : given) {
      push(span_.last, node.s);
      nodes_.back().joint = node.joint;
    }
    begin_ = nodes_.back().s;
  }

  double reached() const noexcept { return begin_; }

  void go_to(std::size_t joint, double end) {
    const bool ends = joint == span_.last;
    const double beside = ends ? 0 : jump_step(span_, joint);
    if (beside_ > 0 && end - begin_ > 2 * beside_) add(joint, begin_ + beside_);
    if (beside > 0 && end - nodes_.back().s > 2 * beside) add(joint, end - beside);
    fill_to(joint, end);
    interval_ = std::min(joint, span_.last - 1);
    nodes_.push_back({interval_, end, !ends});
    begin_ = end;
    beside_ = beside;
  }

  std::vector<PlanNode> take() { return std::move(nodes_); }

 private:
  double spacing(std::size_t i, double s) const noexcept {
    return std::min(guess_.spacing(s),
                    std::max(curvature_spacing_(i, s), shortest_ * guess_.speed(s)));
  }

  void fill_to(std::size_t joint, double end) {
    double s = nodes_.back().s;
    while (nodes_.size() <= tuning::nodes::kMost) {
      const double h = spacing(interval_, s);
      const double left = end - s;
      if (left <= 1.25 * h) break;
      s += left < 2.5 * h ? 0.5 * left : h;
      push(joint, s);
    }
  }

  void add(std::size_t joint, double s) {
    fill_to(joint, s);
    push(joint, s);
  }

  void push(std::size_t joint, double s) {
    while (interval_ + 1 < joint && span_.s(interval_ + 1) <= s) ++interval_;
    nodes_.push_back({interval_, s, false});
  }

  const PlanSpan& span_;
  const SpeedGuess& guess_;
  const CurvatureSpacing curvature_spacing_;
  const double shortest_;
  std::vector<PlanNode> nodes_;
  std::size_t interval_;  // of the chain, where the last node lies
  double begin_;          // mm: the last joint
  double beside_ = 0;     // mm: its jump_step
};

}  // namespace

std::vector<PlanNode> place_nodes(const PlanSpan& span, const SpeedGuess& guess, double from,
                                  double to, std::size_t cut, std::span<const ProvenNode> given) {
  NodePlacement placement(span, guess, from);
  placement.begin_with(given);
  for (std::size_t n = span.first + 1; n < span.last; ++n)
    if (span.s(n) > placement.reached() && (n == cut || is_joint(span, n)))
      placement.go_to(n, span.s(n));
  placement.go_to(span.last, to);
  return placement.take();
}

void refine(const PlanSpan& span, std::vector<PlanNode>& nodes, const std::vector<bool>& marked) {
  std::vector<PlanNode> finer;
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    finer.push_back(nodes[p]);
    if (!marked[p] || p + 1 == nodes.size()) continue;
    const double s = 0.5 * (nodes[p].s + nodes[p + 1].s);
    std::size_t i = nodes[p].interval;
    while (i + 1 < span.last && span.s(i + 1) <= s) ++i;
    finer.push_back({i, s, false});
  }
  nodes = std::move(finer);
}

}  // namespace softcnc::ipo
