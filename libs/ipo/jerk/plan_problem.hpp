// SPDX-License-Identifier: MIT
// From a span and the nodes on it to the problem of its fastest speeds.
#pragma once

#include <vector>

#include "ipo/jerk/plan_jumps.hpp"
#include "ipo/jerk/plan_nodes.hpp"
#include "ipo/solver/speed_problem.hpp"

namespace softcnc::ipo {

/// Both ends of a plan, and whether it goes on from another one.
struct PlanEnds {
  SpeedSquare start, end;
  bool continues = false;
};

/// The caps of a span and its rows by axis, at nodes. `shares`: by node.
class PlanProblem {
 public:
  PlanProblem(const PlanSpan& span, const std::vector<PlanNode>& nodes, const PlanEnds& ends,
              const std::vector<NodeShare>& shares);

  const SpeedProblem& problem() const noexcept { return problem_; }
  const std::vector<BendJump>& jumps() const noexcept { return jumps_; }
  /// What no speed between the nodes p and p + 1 may exceed, whatever their shares; mm^2/s^2.
  double cap_between(std::size_t p) const noexcept;

  /// What holds back at a node: the limit that is used most.
  Limit limit(std::size_t p, const SpeedSquare& at) const noexcept;

 private:
  void add_node(std::size_t p);
  void add_rows(std::size_t p, const PathPoint& point, const Inside& inside);
  double first_part(std::size_t p) const noexcept;
  Inside inside_around(std::size_t p) const noexcept;
  Cap cap(std::size_t p) const noexcept;
  bool slopes(std::size_t i, double from, double to) const noexcept;
  Cap sloped_cap(std::size_t p, double from, double to) const noexcept;
  Cap cap_inside(std::size_t i, double s) const noexcept;

  const PlanSpan& span_;
  const std::vector<PlanNode>& nodes_;
  const PlanEnds ends_;
  const std::vector<NodeShare>& shares_;
  std::vector<BendJump> jumps_;
  std::vector<JumpLoad> loads_;  // by node
  SpeedProblem problem_;
  std::vector<Cap> caps_;  // by node, all of them; none at the ends
  double faster_ = 0;      // mm from the start, where it just is, that the machine speeds up
  double stop_ = 0;        // mm that it would take to stop
};

/// What speeds a motion up goes on for so many mm, until a jerk of -j has ended it.
double way_to_fastest(const Motion& motion, double j) noexcept;

/// No motion at `v` mm/s takes longer than this to stop on a straight line of these directions, mm.
double stopping_distance(double v, const Constraints& constraints,
                         const Directions& directions) noexcept;

}  // namespace softcnc::ipo
