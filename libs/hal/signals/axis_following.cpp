// SPDX-License-Identifier: MIT
#include "hal/signals/axis_following.hpp"

#include <algorithm>
#include <cmath>

#include "motion/model/position_loop.hpp"
#include "motion/model/servo_figures.hpp"

namespace softcnc::hal {

AxisFollowing::AxisFollowing(const Axis& axis, Follow follow, double loop_period)
    : follow_(follow),
      motor_(axis.motor),
      drive_(axis.drive),
      mm_per_rad_(mm_per_rad(axis)),
      velocity_(axis.velocity),
      loop_period_(loop_period),
      lead_(follow == Follow::lead ? lead_time(axis, loop_period) : 0) {}

void AxisFollowing::begin(double position) noexcept {
  position_ = command_ = position;
  speed_ = measured_speed_ = integral_ = 0;
}

double AxisFollowing::move(double position, double time) noexcept {
  const double speed = (position - position_) / time;
  const double acceleration = (speed - speed_) / time;
  const double most = std::max(velocity_, std::abs(speed)) * time;
  const double wanted = position + ahead(speed, acceleration, time);
  command_ = std::clamp(wanted, command_ - most, command_ + most);
  position_ = position;
  speed_ = speed;
  return command_;
}

/// Returns how far the command is ahead, mm, at the end of a move of `time` s with this mean speed.
double AxisFollowing::ahead(double speed, double acceleration, double time) noexcept {
  switch (follow_) {
    case Follow::off:
      return 0;
    case Follow::lead:
      return lead_ * (speed + acceleration * time / 2);
    case Follow::model:
      return following_error(speed, acceleration, time);
  }
  return 0;
}

/// The counter that is read now is the velocity command until it is read again: the speed is that
/// in the middle of this time.
double AxisFollowing::following_error(double speed, double acceleration, double time) noexcept {
  const double decay = std::exp(-time / drive_.fv_time_constant);
  if (speed == 0) {  // friction holds the axis, and the amplifier what it has integrated
    measured_speed_ *= decay;
    return 0;
  }
  const double w = (speed + acceleration * (time + loop_period_) / 2) / mm_per_rad_;
  const double torque = motor_.inertia * acceleration / mm_per_rad_ + motor_.viscous_friction * w +
                        std::copysign(motor_.coulomb_friction, w);
  const double voltage =
      motor_.resistance * torque / motor_.torque_constant + motor_.emf_constant * w;
  const double before = measured_speed_;
  measured_speed_ = w + (before - w) * decay;
  const double measured = (before + measured_speed_) / 2, half = drive_.velocity_reset * time / 2;
  const double command =
      (voltage / drive_.velocity_gain + measured * (1 + half) - drive_.velocity_reset * integral_) /
      (1 + half);
  integral_ += (command - measured) * time;
  return command * mm_per_rad_ / drive_.kv;
}

}  // namespace softcnc::hal
