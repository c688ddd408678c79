// SPDX-License-Identifier: MIT
// The nodes of a plan: dense where speeds or the direction of the path change fast, and at every
// joint.
#pragma once

#include <span>
#include <vector>

#include "ipo/jerk_limited/plan_span.hpp"
#include "ipo/jerk_limited/speed_guess.hpp"

namespace softcnc::ipo {

/// A node of the spline of a plan.
struct PlanNode {
  std::size_t interval;  // to its right; for the last node, to its left
  double s;              // mm of the chain
  bool joint;            // what lies left of it belongs to the interval before
};

/// What a node may use: parts of the jerk and of the velocity limit.
struct NodeShare {
  double jerk = 1, velocity = 1;
  bool holds_velocity = false;  // bounds the speed itself, beside its spline coefficient
};

/// A node at which a plan has kept all limits, and its speed there.
struct ProvenNode {
  double s = 0;  // mm of the chain
  bool joint = false;
  NodeShare share;
  double q = 0;
};

/// Places nodes from `from` to `to`, mm of the chain, both nodes themselves; so are the chain's
/// node `cut` and every node of the chain at which a derivative of the path jumps or a move ends.
/// Gives up at more than tuning::nodes::kMost. The nodes begin with those that are given.
std::vector<PlanNode> place_nodes(const PlanSpan& span, const SpeedGuess& guess, double from,
                                  double to, std::size_t cut, std::span<const ProvenNode> given);

/// Halves the intervals to the right of the marked nodes.
void refine(const PlanSpan& span, std::vector<PlanNode>& nodes, const std::vector<bool>& marked);

}  // namespace softcnc::ipo
