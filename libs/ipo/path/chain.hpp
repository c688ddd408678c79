// SPDX-License-Identifier: MIT
// Moves laid end to end: intervals, and between them nodes with what is allowed there.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ipo/path/corner_load.hpp"
#include "ipo/path/grid.hpp"
#include "ipo/path/rest_ramps.hpp"

namespace softcnc::ipo {

/// The tangent turns where its direction jumps by more than this (rad), and the machine rests
/// there; below it the path is tangent but for the rounding of the program, and the machine passes
/// with a bounded jump of velocity.
inline constexpr double kTangentTolerance = 0.01;

/// Derivatives inside an interval, on which they are as good as linear; s in mm of its move.
PathPoint point_inside(const Interval& interval, double s) noexcept;

/// A place between two intervals.
struct Node {
  Cap own;                               // of its two intervals and of the joint itself
  double turn = 0;                       // rad; 0 where the path is tangent
  AxisVector kink = AxisVector::Zero();  // |jump of x'| by axis
  AxisVector bend = AxisVector::Zero();  // jump of x'' by axis
  double s = 0;                          // mm from the first node ever
  Cap cap;                               // own, and what neighbours ask for: derive_caps()
  double k = 0;                          // the largest q from which all ahead can be kept
  bool brakes_to_corner = false;         // who runs along K brakes from here to a forced rest

  bool turns() const noexcept { return turn > 0; }
  bool passes_kink() const noexcept { return turns() && own.q > 0; }
  /// Whether a corner, or a stop at the end of every block, forces a rest.
  bool forces_rest() const noexcept { return own.q == 0 && own.limit == Limit::corner; }
  bool passes_bend() const noexcept { return !bend.isZero(0) && own.q > 0; }
};

/// What an interval is allowed between its nodes: derive_caps().
struct Inside {
  Cap cap;           // of a straight interval
  double share = 1;  // of the axis accelerations that the curve itself may use
  AxisVector jerk_share = AxisVector::Ones();  // what kinks leave of the axis jerks
  bool feels_jump = false;                     // of a third difference, by some joint
  KinkUse kinks = {};                          // of a straight interval without limits of jerk
};

/// Interval i lies between nodes i and i + 1.
struct Chain {
  std::vector<Interval> intervals;
  std::vector<Inside> inside;
  std::vector<Node> nodes;
  double slower_from = kUnlimited;  // mm: where the slower caps of intervals begin to count

  /// Of two intervals and their joint, or slower where that counts.
  Cap own_cap(std::size_t node) const noexcept;
  Cap left_cap(std::size_t interval) const noexcept;

  /// Appends a move; `rest`: why the machine rests where it begins, if it does. Intervals are split
  /// towards a joint until what is asked for across it need not slow long stretches.
  void append(const Move& move, const Constraints& constraints, RestBefore rest);

  /// Splits interval i at `s` mm of its move. Caps are to be derived anew.
  void split(std::size_t i, double s);

  /// Forgets the first `count` intervals.
  void drop_front(std::size_t count);

  /// The last node at or before `node` behind which nothing that lies at it or ahead is felt.
  std::size_t felt_from(std::size_t node, double period) const noexcept;

  /// Calls visit(i) for the intervals left and right of a node that one step, however fast, can
  /// touch together with it, nearest first on each side; on a side no further once visit returns
  /// false.
  template <typename Visit>
  void for_intervals_in_step(std::size_t node, double period, Visit&& visit) const {
    double time = 0;
    for (std::size_t i = node; i-- > 0 && time < period && visit(i);)
      time += intervals[i].shortest_time();
    time = 0;
    for (std::size_t i = node; i < intervals.size() && time < period && visit(i); ++i)
      time += intervals[i].shortest_time();
  }

  /// Those of the intervals [first, last).
  Directions directions(std::size_t first, std::size_t last) const noexcept;
  /// Those that a machine can take within `time` s of passing a node, before it or behind it.
  Directions directions_around(std::size_t node, double time) const noexcept;

 private:
  void make_room(double more);
  void add(std::span<const Interval> ahead, const Constraints& constraints, RestBefore rest);
  double bend(const Interval& before, const Interval& interval, const Constraints& constraints);
  void push(const Interval& interval);
  void split_at_cruise(const Constraints& constraints);
  void split_move_at(double s);

  std::vector<Interval> grid_;  // of a part of the move that is appended; kept for its room
};

/// Finds Node::cap and Inside: spreads what each interval asks of the steps that touch it, and what
/// joints ask of the speed, the acceleration and the jerk around them.
/// Left of node `first` they stand already.
void derive_caps(Chain& chain, const Constraints& constraints, std::size_t first = 0);

/// Largest part of an axis acceleration that jumps of velocity may use within one period.
inline constexpr double kKinkShare = 0.25;
/// The same between straight lines alone, where what they leave is known at every speed.
inline constexpr double kStraightKinkShare = 0.9;
/// So many steps are felt in a third difference.
inline constexpr double kJerkSteps = 3;
/// Largest part of an axis jerk that jumps of velocity may use within three steps.
inline constexpr double kKinkJerkShare = 0.7;

/// Part of the chord tolerance that curves leave to corners and kinks within the same step.
inline constexpr double kTurnShare = 0.5;

/// Whether one step can touch the node together with a curve or with another stop where the path
/// turns.
bool shares_its_step(const Chain& chain, std::size_t node, double period) noexcept;

}  // namespace softcnc::ipo
