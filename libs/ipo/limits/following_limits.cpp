// SPDX-License-Identifier: MIT
#include "ipo/limits/following_limits.hpp"

#include <algorithm>

#include "motion/model/servo_figures.hpp"

namespace softcnc::ipo {
namespace {

constexpr double kMostMargin = 0.25;  // of the velocity of an axis
constexpr double kLeastDrive = 0.01;  // of its acceleration: a motor too weak is not worth more
constexpr double kMotorShare = 0.95;  // of torque and voltage that the path may ask for
// Of A Kv, where the machine has no jerk limit: more makes ramps shorter and the velocity lower. A
// rapid of 100 mm takes least with 2 to 4; a circle at the velocity limit takes 2 % longer with 2
// than with 1, and 6 % with 4.
constexpr double kJerk = 2;

/// Returns the acceleration that current and voltage of a motor allow at the velocity of its axis,
/// mm/s^2, against its friction.
double motor_acceleration(const Axis& axis) noexcept {
  const Motor& motor = axis.motor;
  const double w = axis.velocity / mm_per_rad(axis);
  const double current =
      std::min(axis.drive.current_limit,
               (axis.drive.supply_voltage - motor.emf_constant * w) / motor.resistance);
  const double torque = kMotorShare * motor.torque_constant * current - motor.coulomb_friction -
                        motor.viscous_friction * w;
  return torque / motor.inertia * mm_per_rad(axis);
}

/// Returns by how much commands may be faster than the path, mm/s.
double margin(const Axis& axis) noexcept {
  const double lead = 1 / axis.drive.kv, reach = axis.jerk * lead;
  const double most = reach < axis.acceleration
                          ? reach * lead / 2
                          : axis.acceleration * (lead - axis.acceleration / (2 * axis.jerk));
  return most + reach * velocity_lag(axis);
}

void leave_margin(Axis& axis) noexcept {
  const double allowed = std::max(motor_acceleration(axis), kLeastDrive * axis.acceleration);
  axis.drive_limits = allowed < axis.acceleration;
  axis.acceleration = std::min(axis.acceleration, allowed);
  if (axis.jerk == 0) axis.jerk = kJerk * axis.acceleration * axis.drive.kv;
  const double part = std::min(1.0, kMostMargin * axis.velocity / margin(axis));
  axis.acceleration *= part;
  axis.jerk *= part;
  axis.velocity -= margin(axis);
}

}  // namespace

Machine planned_machine(const Machine& machine) {
  Machine planned = machine;
  if (machine.control.follow == Follow::off) return planned;
  for (Axis& axis : planned.axes)
    if (axis.present) leave_margin(axis);
  return planned;
}

}  // namespace softcnc::ipo
