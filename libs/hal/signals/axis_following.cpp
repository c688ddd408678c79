// SPDX-License-Identifier: MIT
#include "hal/signals/axis_following.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "motion/model/servo_figures.hpp"

namespace softcnc::hal {
namespace {

/// Returns |P(i w)|: of the position loop closed by a counter that is read every `loop_period` s
/// and held until then, over the velocity loop of ServoAxis.
double gain_at(const Axis& axis, double loop_period, double w) {
  const Motor& motor = axis.motor;
  const Drive& drive = axis.drive;
  const std::complex<double> s(0, w);
  const auto plant = motor.torque_constant / ((motor.resistance + motor.inductance * s) *
                                                  (motor.inertia * s + motor.viscous_friction) +
                                              motor.torque_constant * motor.emf_constant);
  const auto forward = drive.velocity_gain * (1.0 + drive.velocity_reset / s) * plant;
  const auto velocity = forward / (1.0 + forward / (1.0 + drive.fv_time_constant * s)) *
                        std::exp(-s * loop_period / 2.0);
  return std::abs(drive.kv * velocity / (s + drive.kv * velocity));
}

/// A circle: its angular speed, its radius, and the gain of the loop there.
struct CircularMotion {
  double w, radius, gain;
};

std::vector<CircularMotion> circular_motions(const Axis& axis, double loop_period) {
  constexpr int kMotions = 400;
  constexpr double kFastest = 10;  // times Kv: errors of faster circles are smaller
  const double slowest = axis.acceleration / axis.velocity;
  const double fastest = std::max(kFastest * axis.drive.kv, 2 * slowest);
  std::vector<CircularMotion> all;
  for (int i = 0; i <= kMotions; ++i) {
    const double w = slowest * std::pow(fastest / slowest, static_cast<double>(i) / kMotions);
    all.push_back({w, axis.acceleration / (w * w), gain_at(axis, loop_period, w)});
  }
  return all;
}

double largest_error(const std::vector<CircularMotion>& motions, double lead) noexcept {
  double most = 0;
  for (const CircularMotion& turn : motions)
    most = std::max(most, turn.radius * std::abs(turn.gain * std::hypot(1, turn.w * lead) - 1));
  return most;
}

}  // namespace

double lead_time(const Axis& axis, double loop_period) {
  const std::vector<CircularMotion> all = circular_motions(axis, loop_period);
  double low = 0, high = 2 / axis.drive.kv;
  while (high - low > 1e-9 * high) {  // a largest of functions that fall and then rise
    const double third = (high - low) / 3;
    if (largest_error(all, low + third) < largest_error(all, high - third))
      high -= third;
    else
      low += third;
  }
  return (low + high) / 2;
}

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
