// SPDX-License-Identifier: MIT
// The jumps of x'' that a plan passes: what they take from the jerk at its nodes, and of the motion
// that comes of it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ipo/jerk/plan_nodes.hpp"
#include "ipo/path/curvature_jump_load.hpp"
#include "ipo/path/ramp.hpp"
#include "ipo/solver/speed_spline.hpp"

namespace softcnc::ipo {

/// At a joint of a plan, or just behind its start.
struct BendJump {
  double s = 0;                          // mm of the chain
  double fastest = 0;                    // mm/s, there
  double most_u = 0;                     // mm/s^2, along the path around it
  AxisVector bend = AxisVector::Zero();  // of x'', 1/mm
  std::optional<std::size_t> node;       // of the plan
};

/// Those that are felt somewhere in a plan over these nodes, in the order of the way.
std::vector<BendJump> find_jumps(const PlanSpan& span, const std::vector<PlanNode>& nodes);

/// By node, per q of the joint, 1/(mm s). A motion is taken to be as fast as it can be, and so to
/// be near a joint longer than it is.
std::vector<JumpLoad> jump_loads(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                                 const std::vector<BendJump>& jumps);

/// The jumps of a motion, by its time.
class PassedJumps {
 public:
  /// None.
  PassedJumps() = default;
  /// Of ramps from node to node, from a start with this speed.
  PassedJumps(const PlanSpan& span, const std::vector<BendJump>& jumps, double start_s,
              const SpeedSquare& start, const std::vector<Ramp>& ramps);

  /// mm/s^3; `t` s from the start, where the last one asked for was or later.
  JumpLoad at(double t) noexcept;

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
