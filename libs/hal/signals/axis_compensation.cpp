// SPDX-License-Identifier: MIT
#include "hal/signals/axis_compensation.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::hal {
namespace {

/// What is left of an addition, mm, is added at once where it is less.
constexpr double kLast = 1e-9;

}  // namespace

AxisCompensation::AxisCompensation(const Axis& axis, const Screw& screw)
    : pitch_(pitch_compensation(screw.pitch_table)),
      backlash_(screw.backlash),
      velocity_(axis.velocity),
      acceleration_(axis.acceleration) {}

double AxisCompensation::begin(double position) noexcept {
  path_ = position;
  path_speed_ = ramp_speed_ = 0;
  turn_at(position, false);
  added_ = wanted();
  return position + added_;
}

void AxisCompensation::turn_at(double position, bool negative) noexcept {
  negative_ = negative;
  furthest_ = position;
}

void AxisCompensation::watch_direction(double position) noexcept {
  const double back = negative_ ? position - furthest_ : furthest_ - position;
  if (back > kTurned)
    turn_at(position, !negative_);
  else if (back < 0)
    furthest_ = position;
}

double AxisCompensation::move(double position, double time) noexcept {
  const double speed = (position - path_) / time;
  const double acceleration = (speed - path_speed_) / time;
  watch_direction(position);
  const double left = wanted() - added_;  // still at the last position
  const double pitch = pitch_(position) - pitch_(path_);
  const double before = added_;
  path_ = position;
  path_speed_ = speed;
  added_ += pitch + ramp(left, acceleration, time);
  keep_velocity(before, time);
  ramp_speed_ = (added_ - before - pitch) / time;
  if (std::abs(wanted() - added_) < kLast) added_ = wanted();
  return path_ + added_;
}

/// Returns what a ramp adds in `time` of what is `left`, mm. It can always stop by the least share
/// of the acceleration: x t + x^2 / (2 a) = left, for the speed x of this step.
double AxisCompensation::ramp(double left, double acceleration, double time) const noexcept {
  const double least = kLeastShare * acceleration_;
  const double gain = std::max(acceleration_ - std::abs(acceleration), least) * time;
  const double direction = left < 0 ? -1 : 1;
  const double stoppable =
      least * time * (std::sqrt(1 + 2 * std::abs(left) / (least * time * time)) - 1);
  return direction * std::min(direction * ramp_speed_ + gain, stoppable) * time;
}

/// Takes back of what was added in the last move, over `time`, what makes it faster than the axis.
void AxisCompensation::keep_velocity(double before, double time) noexcept {
  const double most = std::max(velocity_, std::abs(path_speed_)) * time;
  const double moved = path_speed_ * time + added_ - before;
  if (std::abs(moved) > most) added_ = before + std::copysign(most, moved) - path_speed_ * time;
}

}  // namespace softcnc::hal
