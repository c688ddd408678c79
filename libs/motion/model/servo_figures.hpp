// SPDX-License-Identifier: MIT
// Figures of a servo axis that follow from those of the machine file.
#pragma once

#include <numbers>

#include "motion/model/machine.hpp"

namespace softcnc {

/// Returns the travel of an axis per angle of its motor, mm/rad.
inline double mm_per_rad(const Axis& axis) noexcept {
  return axis.screw_lead / (2 * std::numbers::pi);
}

/// Returns the time constant of the velocity loop, s: that by which the speed follows a step of its
/// command as long as the integral part of the amplifier is empty,
/// J R / (Kt (Ke + Kp)), with the inductance and the lag of the F/V converter left out.
inline double velocity_lag(const Axis& axis) noexcept {
  const Motor& motor = axis.motor;
  return motor.inertia * motor.resistance /
         (motor.torque_constant * (motor.emf_constant + axis.drive.velocity_gain));
}

}  // namespace softcnc
