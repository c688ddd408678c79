// SPDX-License-Identifier: MIT
// Machines with the same limits on all axes.
#pragma once

#include "motion/model/machine.hpp"

namespace softcnc::test {

/// The feed is not limited.
inline Machine machine_with(double velocity, double acceleration, double jerk) {
  Machine machine;
  machine.limits.feed = 0;
  for (Axis& axis : machine.axes) {
    axis.velocity = velocity;
    axis.acceleration = acceleration;
    axis.jerk = jerk;
  }
  return machine;
}

/// The velocities are the usual ones.
inline Machine usual_machine(double acceleration, double jerk, double period = 1e-3) {
  Machine machine;
  machine.control.period = period;
  for (Axis& axis : machine.axes) {
    axis.acceleration = acceleration;
    axis.jerk = jerk;
  }
  return machine;
}

}  // namespace softcnc::test
