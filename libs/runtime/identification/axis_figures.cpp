// SPDX-License-Identifier: MIT
#include "runtime/identification/axis_figures.hpp"

#include <numbers>

namespace softcnc::runtime {
namespace {

double mm_per_rad(const Axis& axis) noexcept { return axis.screw_lead / (2 * std::numbers::pi); }

}  // namespace

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

double velocity_lag(const Axis& axis) noexcept {
  const Motor& motor = axis.motor;
  return motor.inertia * motor.resistance /
         (motor.torque_constant * (motor.emf_constant + axis.drive.velocity_gain));
}

}  // namespace softcnc::runtime
