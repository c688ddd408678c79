// SPDX-License-Identifier: MIT
#include "runtime/identification/axis_figures.hpp"

#include "motion/model/servo_figures.hpp"

namespace softcnc::runtime {

AxisFigures figures_of(const Axis& axis) noexcept {
  const Motor& motor = axis.motor;
  return {axis.drive.kv,
          mm_per_rad(axis) * motor.torque_constant / (motor.resistance * motor.inertia),
          mm_per_rad(axis) * motor.coulomb_friction / motor.inertia, 0};
}

Axis with_figures(Axis axis, const AxisFigures& figures) noexcept {
  Motor& motor = axis.motor;
  axis.drive.kv = figures.kv;
  motor.resistance =
      mm_per_rad(axis) * motor.torque_constant / (figures.torque_over_inertia * motor.inertia);
  motor.coulomb_friction = figures.friction_over_inertia * motor.inertia / mm_per_rad(axis);
  return axis;
}

}  // namespace softcnc::runtime
