// SPDX-License-Identifier: MIT
// The fastest speeds over one interval under caps and axis accelerations.
//
// Unknown: q = v^2 at the nodes, linear between them, so the path acceleration u = q'/2 is constant
// on each piece. The rows |x'' q + x' u| <= A hold at both ends of every interval. One pass
// backward finds K, the largest q from which everything ahead can still be kept; one pass forward
// takes it: the optimum of the grid in O(N) (time-optimal path parametrisation by reachability
// analysis).
#pragma once

#include <vector>

#include "ipo/optimum/interval_constraints.hpp"
#include "ipo/path/grid.hpp"

namespace softcnc::ipo {

/// A stretch of constant path acceleration.
struct SpeedPiece {
  double s0 = 0, s1 = 0;  // mm from the start of the move
  double q0 = 0, q1 = 0;  // v^2 at its ends, mm^2/s^2
  Limit limit = Limit::feed;

  bool operator==(const SpeedPiece&) const = default;
};

/// One interval as the two passes see it.
struct Reach {
  Cap left, right;     // caps of its nodes
  Cap inside;          // of a straight interval between its nodes
  double left_k = 0;   // K at its left node: reach_back's result
  double right_k = 0;  // K at its right node
};

/// K at the left node, given K at the right node.
double reach_back(const Interval& interval, const IntervalRows& rows, const Reach& reach) noexcept;

/// Runs the interval from q at its left node as fast as K allows, appends its pieces and returns q
/// at the right node.
double run_forward(const Interval& interval, const IntervalRows& rows, const Reach& reach, double q,
                   std::vector<SpeedPiece>& out);

}  // namespace softcnc::ipo
