// SPDX-License-Identifier: MIT
// Where a plan has its nodes: fine where speeds or the direction of the path change fast, and at
// every joint.
#pragma once

#include <span>
#include <vector>

#include "ipo/jerk/plan_span.hpp"
#include "ipo/jerk/speed_guess.hpp"

namespace softcnc::ipo {

/// A node of the spline of a plan.
struct PlanNode {
  std::size_t interval;  // to its right; the last one has that to its left
  double s;              // mm of the chain
  bool joint;            // what lies left of it belongs to the interval before
};

/// What a node may use: parts of the jerk and of the cap.
struct NodeShare {
  double jerk = 1, cap = 1;
  bool holds_cap = false;  // the speed itself, beside the coefficient of its spline
};

/// A plan that needs more cannot be found in bounded memory; nor is there one, as a rule.
inline constexpr std::size_t kMostNodes = 100'000;

/// A node at which a plan has kept everything, and how fast it was there.
struct ProvenNode {
  double s = 0;  // mm of the chain
  bool joint = false;
  NodeShare share;
  double q = 0;
};

/// From `from` to `to`, mm of the chain, both nodes themselves; so are the chain's node `cut` and
/// every node of the chain at which a derivative of the path jumps or a move ends. More than
/// kMostNodes of them are not finished. They begin with those that are given.
std::vector<PlanNode> place_nodes(const PlanSpan& span, const SpeedGuess& guess, double from,
                                  double to, std::size_t cut, std::span<const ProvenNode> given);

/// Halves the intervals to the right of the marked nodes.
void refine(const PlanSpan& span, std::vector<PlanNode>& nodes, const std::vector<bool>& marked);

}  // namespace softcnc::ipo
