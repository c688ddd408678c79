// SPDX-License-Identifier: MIT
// The fastest speeds over one interval under velocity limits and axis accelerations.
//
// The unknown is q = v^2 at the nodes, linear between them, so the path acceleration u = q'/2 is
// constant on each piece. The constraints |x'' q + x' u| <= A hold at both ends of every interval.
// A backward pass finds the controllable set [0, k] of each node, where k is the largest q from
// which everything ahead can still be kept; a forward pass takes k: the optimum of the grid in O(N)
// (time-optimal path parametrisation by reachability analysis, TOPP-RA).
#pragma once

#include <vector>

#include "ipo/acceleration_limited/interval_constraints.hpp"
#include "ipo/path/grid.hpp"

namespace softcnc::ipo {

/// A piece of constant path acceleration.
struct SpeedPiece {
  double s0 = 0, s1 = 0;  // mm from the start of the move
  double q0 = 0, q1 = 0;  // v^2 at its ends, mm^2/s^2
  Limit limit = Limit::feed;

  bool operator==(const SpeedPiece&) const = default;
};

/// One interval as the two passes see it: its velocity limits and the controllable sets of its
/// nodes.
struct ControllableInterval {
  VelocityLimit left, right;  // limits of its nodes
  VelocityLimit inside;       // of a straight interval between its nodes
  double left_q = 0;          // end of the controllable set at its left node
  double right_q = 0;         // and at its right node
};

/// Returns the end of the controllable set at the left node, given the one at the right node.
double backward_step(const Interval& interval, const IntervalConstraints& constraints,
                     const ControllableInterval& controllable) noexcept;

/// Runs the interval from q at its left node as fast as the controllable sets allow, appends its
/// pieces and returns q at the right node.
double forward_step(const Interval& interval, const IntervalConstraints& constraints,
                    const ControllableInterval& controllable, double q,
                    std::vector<SpeedPiece>& out);

}  // namespace softcnc::ipo
