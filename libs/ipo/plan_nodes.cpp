// SPDX-License-Identifier: MIT
#include "ipo/plan_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

constexpr double kTurn = 0.06;          // rad between two nodes
constexpr double kCapChange = 0.04;     // of a roughness, between two nodes
constexpr double kGrading = 0.15;       // how fast that spacing may change along the way
constexpr double kShortestTime = 0.35;  // periods: what turns faster is not resolved
constexpr double kSame = 1e-9;          // relative: derivatives that do not jump

bool same(const AxisVector& a, const AxisVector& b) noexcept {
  return (a - b).norm() <= kSame * (a.norm() + b.norm());
}

bool is_joint(const PlanSpan& span, std::size_t node) noexcept {
  const Interval &before = span.interval(node - 1), &after = span.interval(node);
  return before.ends_move || !same(before.right.dq, after.left.dq) ||
         !same(before.right.ddq, after.left.ddq) || !same(before.right.dddq, after.left.dddq);
}

/// The cap of a roughness has steep flanks where the way is level.
double cap_spacing(const Interval& in) noexcept {
  const Cap &left = in.left_cap, &right = in.right_cap;
  const double change = std::abs(right.q - left.q);
  if (left.limit != Limit::roughness && right.limit != Limit::roughness) return kUnlimited;
  return change > 0 ? kCapChange * std::min(left.q, right.q) * in.length() / change : kUnlimited;
}

/// The spacing that the bends of the path and its caps ask for, at the nodes of the chain.
class BendSpacing {
 public:
  explicit BendSpacing(const PlanSpan& span) : span_(span), h_(span.last - span.first + 1, 0.0) {
    std::fill(h_.begin(), h_.end(), kUnlimited);
    for (std::size_t i = span.first; i < span.last; ++i) {
      const Interval& in = span.interval(i);
      const double h =
          std::min(kTurn / std::max(in.left.ddq.norm(), in.right.ddq.norm()), cap_spacing(in));
      at(i) = std::min(at(i), h);
      at(i + 1) = std::min(at(i + 1), h);
    }
    for (std::size_t i = span.first; i < span.last; ++i)
      at(i + 1) = std::min(at(i + 1), at(i) + kGrading * span.interval(i).length());
    for (std::size_t i = span.last; i-- > span.first;)
      at(i) = std::min(at(i), at(i + 1) + kGrading * span.interval(i).length());
  }

  double operator()(std::size_t i, double s) const noexcept {
    const double left = h_[i - span_.first], right = h_[i + 1 - span_.first];
    return std::min(left + kGrading * (s - span_.s(i)), right + kGrading * (span_.s(i + 1) - s));
  }

 private:
  double& at(std::size_t node) noexcept { return h_[node - span_.first]; }

  const PlanSpan& span_;
  std::vector<double> h_;
};

}  // namespace

std::vector<PlanNode> place_nodes(const PlanSpan& span, const SpeedGuess& guess, double from,
                                  double to, std::size_t cut) {
  const BendSpacing bends(span);
  const double shortest = kShortestTime * span.constraints.period();
  const auto spacing = [&](std::size_t i, double s) {
    return std::min(guess.spacing(s), std::max(bends(i, s), shortest * guess.speed(s)));
  };
  std::vector<PlanNode> nodes{{span.first, from, false}};
  std::size_t i = span.first;
  for (std::size_t joint = span.first + 1; joint <= span.last; ++joint) {
    if (joint < span.last && joint != cut && !is_joint(span, joint)) continue;
    const double end = joint == span.last ? to : span.s(joint);
    double s = nodes.back().s;
    while (nodes.size() <= kMostNodes) {
      const double h = spacing(i, s);
      const double left = end - s;
      if (left <= 1.25 * h) break;
      s += left < 2.5 * h ? 0.5 * left : h;
      while (i + 1 < joint && span.s(i + 1) <= s) ++i;
      nodes.push_back({i, s, false});
    }
    i = std::min(joint, span.last - 1);
    nodes.push_back({i, end, joint < span.last});
  }
  return nodes;
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
