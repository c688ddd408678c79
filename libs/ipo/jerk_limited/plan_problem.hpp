// SPDX-License-Identifier: MIT
// Makes the optimisation problem of the fastest speeds from a span and the nodes on it.
#pragma once

#include <vector>

#include "ipo/jerk_limited/plan_jumps.hpp"
#include "ipo/jerk_limited/plan_nodes.hpp"
#include "ipo/solver/speed_problem.hpp"

namespace softcnc::ipo {

/// Both ends of a plan, and whether it continues another one.
struct PlanEnds {
  SpeedSquare start, end;
  bool continues = false;
};

/// The velocity limits of a span and its constraints by axis, at nodes. `shares`: by node.
class PlanProblem {
 public:
  PlanProblem(const PlanSpan& span, const std::vector<PlanNode>& nodes, const PlanEnds& ends,
              const std::vector<NodeShare>& shares);

  const SpeedProblem& problem() const noexcept { return problem_; }
  const std::vector<CurvatureJump>& jumps() const noexcept { return jumps_; }
  /// Returns what no q between the nodes p and p + 1 may exceed, whatever their shares; mm^2/s^2.
  double limit_between(std::size_t p) const noexcept;

  /// Returns what limits the speed at a node: the limit that is used most.
  Limit limit(std::size_t p, const SpeedSquare& at) const noexcept;

 private:
  void add_node(std::size_t p);
  void add_constraints(std::size_t p, const PathPoint& point, const Inside& inside);
  double first_part(std::size_t p) const noexcept;
  Inside inside_around(std::size_t p) const noexcept;
  VelocityLimit velocity_limit(std::size_t p) const noexcept;
  bool slopes(std::size_t i, double from, double to) const noexcept;
  VelocityLimit sloped_limit(std::size_t p, double from, double to) const noexcept;
  VelocityLimit limit_inside(std::size_t i, double s) const noexcept;

  const PlanSpan& span_;
  const std::vector<PlanNode>& nodes_;
  const PlanEnds ends_;
  const std::vector<NodeShare>& shares_;
  std::vector<CurvatureJump> jumps_;
  std::vector<NodeLoad> loads_;  // by node
  SpeedProblem problem_;
  std::vector<VelocityLimit> limits_;  // by node, in full; none at the ends
  double faster_ = 0;  // mm from the start during which the machine still accelerates
  double stop_ = 0;    // mm: the stopping distance
};

/// Returns for how many mm a motion keeps accelerating until a jerk of -j has ended that.
double distance_to_fastest(const Motion& motion, double j) noexcept;

/// Returns a distance, mm, within which any motion at `v` mm/s can stop on a straight line of these
/// directions.
double stopping_distance(double v, const ConstraintList& constraints,
                         const Directions& directions) noexcept;

}  // namespace softcnc::ipo
