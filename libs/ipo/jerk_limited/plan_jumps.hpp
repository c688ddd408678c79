// SPDX-License-Identifier: MIT
// The jumps of x'' that a plan passes: what they take from the jerk at its nodes, and from the jerk
// of the resulting motion.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ipo/jerk_limited/plan_nodes.hpp"
#include "ipo/path/curvature_jump_load.hpp"
#include "ipo/path/ramp.hpp"
#include "ipo/solver/speed_spline.hpp"

namespace softcnc::ipo {

/// A curvature jump at a joint of a plan, or just before its start.
struct CurvatureJump {
  double s = 0;                         // mm of the chain
  double fastest = 0;                   // mm/s, there
  double most_u = 0;                    // mm/s^2, along the path around it
  double most_j = 0;                    // mm/s^3, likewise
  AxisVector ddq = AxisVector::Zero();  // jump of x'', 1/mm
  std::optional<std::size_t> node;      // of the plan
};

/// Returns those that matter somewhere in a plan over these nodes, in the order of the path.
std::vector<CurvatureJump> find_jumps(const PlanSpan& span, const std::vector<PlanNode>& nodes);

/// What jumps take from the jerk at a node of a plan: per q, 1/(mm s), where the machine may be
/// about as fast at the joint as at the node, and as a whole, mm/s^3, where it is far slower there.
struct NodeLoad {
  CurvatureJumpLoad per_q;
  AxisVector whole = AxisVector::Zero();
};

/// Returns the load by node. A motion is taken to be as fast as it can be, and so to be near a
/// joint longer than it is.
std::vector<NodeLoad> curvature_jump_loads(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                                           const std::vector<CurvatureJump>& jumps);

/// The curvature jumps of a motion, by its time.
class PassedJumps {
 public:
  /// No jumps.
  PassedJumps() = default;
  /// The jumps of ramps from node to node, from a start with this speed.
  PassedJumps(const PlanSpan& span, const std::vector<CurvatureJump>& jumps, double start_s,
              const SpeedSquare& start, const std::vector<Ramp>& ramps);

  /// Returns the load, mm/s^3, at `t` s from the start; `t` must not fall from call to call.
  CurvatureJumpLoad at(double t) noexcept;

 private:
  struct Passed {
    double t;
    AxisVector jump;  // of the acceleration, in one period: mm/s^3
  };
  std::vector<Passed> passed_;
  double period_ = 0;
  std::size_t first_ = 0;
};

}  // namespace softcnc::ipo
