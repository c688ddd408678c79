// SPDX-License-Identifier: MIT
// Moves end to end: intervals, and between them nodes with what is allowed there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ipo/path/corner_naming.hpp"
#include "ipo/path/grid.hpp"
#include "ipo/path/tangent_jump_load.hpp"

namespace softcnc::ipo {

/// Returns the derivatives inside an interval, interpolated linearly; `s` is in mm of its move.
PathPoint point_inside(const Interval& interval, double s) noexcept;

/// A node between two intervals, and what is allowed there.
struct Node {
  VelocityLimit own;                               // of its two intervals and of the joint
  double turn = 0;                                 // rad; 0 where the path is tangent
  AxisVector tangent_jump = AxisVector::Zero();    // |jump of x'| by axis
  AxisVector curvature_jump = AxisVector::Zero();  // jump of x'' by axis
  double s = 0;                                    // mm from the first node ever
  VelocityLimit velocity_limit;  // own, and what neighbours require: derive_velocity_limits()
  double controllable_q = 0;     // upper end of the controllable set [0, q]
  double contour_velocity = kUnlimited;  // mm/s: what the contour tolerance allows
  bool brakes_to_corner = false;         // at controllable_q the machine brakes to a forced rest

  bool turns() const noexcept { return turn > 0; }
  bool passes_tangent_jump() const noexcept { return turns() && own.q > 0; }
  /// Whether a corner, or an exact stop at the end of the block, forces a rest here.
  bool forces_rest() const noexcept { return own.q == 0 && own.limit == Limit::corner; }
  bool passes_curvature_jump() const noexcept { return !curvature_jump.isZero(0) && own.q > 0; }
};

/// What an interval is allowed between its nodes; derive_velocity_limits() finds it.
struct Inside {
  VelocityLimit velocity_limit;  // of a straight interval
  double share = 1;              // of the axis accelerations that the curve itself may use
  AxisVector jerk_share = AxisVector::Ones();  // what tangent jumps leave of the axis jerks
  bool feels_jump = false;                     // in a third difference, of some joint
  TangentJumpUse tangent_jumps = {};           // of a straight interval without jerk limits
};

/// Interval i lies between nodes i and i + 1.
struct Chain {
  std::vector<Interval> intervals;
  std::vector<Inside> inside;
  std::vector<Node> nodes;
  double slower_from = kUnlimited;  // mm: where the slower limits of intervals take effect

  /// The velocity limit of two intervals and their joint, or the slower one where that takes
  /// effect.
  VelocityLimit own_limit(std::size_t node) const noexcept;
  VelocityLimit left_limit(std::size_t interval) const noexcept;

  /// Appends a move. `rest` says why the machine rests where it begins, if it does. Intervals are
  /// split towards a joint until the velocity limit that it imposes across the joint does not slow
  /// down long stretches.
  void append(const Move& move, const ConstraintList& constraints, RestBefore rest);

  /// Splits interval i at `s` mm of its move. The velocity limits must be derived again afterwards.
  void split(std::size_t i, double s);

  /// Splits the intervals from `first` on: the one after i others at cuts[i], mm of its move, in
  /// ascending order. The velocity limits must be derived again afterwards.
  void split_from(std::size_t first, const std::vector<std::vector<double>>& cuts);

  /// Lowers the velocity limit at a node, on both sides of it.
  void lower(std::size_t node, const VelocityLimit& bound) noexcept;

  /// Drops the first `count` intervals.
  void drop_front(std::size_t count);

  /// Returns the last node at or before `node` after which nothing that lies at it or ahead of it
  /// has any influence.
  std::size_t felt_from(std::size_t node, double period) const noexcept;

  /// Calls visit(i) for the intervals on either side of a node that a single step, however fast,
  /// can touch together with it, nearest first. On each side it ends when visit returns false.
  template <typename Visit>
  void for_intervals_in_step(std::size_t node, double period, Visit&& visit) const {
    double time = 0;
    for (std::size_t i = node; i-- > 0 && time < period && visit(i);)
      time += intervals[i].shortest_time();
    time = 0;
    for (std::size_t i = node; i < intervals.size() && time < period && visit(i); ++i)
      time += intervals[i].shortest_time();
  }

  /// The directions of the intervals [first, last).
  Directions directions(std::size_t first, std::size_t last) const noexcept;
  /// The directions that the machine can take within `time` s before or after passing a node.
  Directions directions_around(std::size_t node, double time) const noexcept;

 private:
  void reserve_for(double more);
  void add(std::span<const Interval> ahead, const ConstraintList& constraints, RestBefore rest);
  double note_curvature_jump(const Interval& before, const Interval& interval,
                             const ConstraintList& constraints);
  void push(const Interval& interval);
  void split_at_cruise(const ConstraintList& constraints);
  void split_move_at(double s);

  std::vector<Interval> grid_;  // of a part of the move being appended; kept for its capacity
};

/// Finds Node::velocity_limit and Inside: spreads what each interval requires of the steps that
/// touch it, and what joints require of the speed, the acceleration and the jerk around them. Nodes
/// left of `first` already have their limits.
void derive_velocity_limits(Chain& chain, const ConstraintList& constraints, std::size_t first = 0);

/// Whether a single step can touch the node together with a curve or with another corner at which
/// the machine stops.
bool shares_its_step(const Chain& chain, std::size_t node, double period) noexcept;

}  // namespace softcnc::ipo
