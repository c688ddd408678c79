// SPDX-License-Identifier: MIT
// The equations of a servo axis and their exact discretisation.
#include "hal/backends/servo.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "motion/core/units.hpp"
#include "motion/model/servo_figures.hpp"

namespace softcnc::hal {
namespace {

constexpr double kSameInstant = 1e-9;  // of a servo period: rounding

}  // namespace

ServoAxis::ServoAxis(const Axis& axis, double servo_period)
    : drive_(axis.drive),
      motor_(axis.motor),
      counts_(axis.blu),
      mm_per_rad_(mm_per_rad(axis)),
      counts_per_rad_(axis.counts_per_rev / kTurn),
      blu_per_count_(axis.screw_lead / axis.counts_per_rev / axis.blu),
      rad_s_per_blu_(axis.drive.kv * axis.blu / mm_per_rad_),
      counter_limit_(std::int64_t{1} << (axis.drive.counter_bits - 1)),
      following_error_limit_(counts_(axis.drive.following_error)),
      substeps_(static_cast<int>(std::ceil(servo_period / kSubstep - 1e-9))),
      substep_(servo_period / substeps_) {
  for (const bool clamped : {false, true})
    for (const bool stuck : {false, true})
      transitions_[mode(clamped, stuck)] = transition(clamped, stuck);
}

/// L i' = u - R i - Ke w;  J w' = Kt i - B w + friction;  tau f' = w - f;  z' = r - f;  angle' = w;
/// u = Kp (r - f + z / Ti), or the clamped voltage, which then takes the place of r as input.
ServoAxis::Transition ServoAxis::transition(bool clamped, bool stuck) const {
  constexpr int kInput = kAngle + 1, kFriction = kAngle + 2, kSize = kAngle + 3;
  using Matrix = Eigen::Matrix<double, kSize, kSize>;
  Matrix a = Matrix::Zero();
  a(armature_current, armature_current) = -motor_.resistance / motor_.inductance;
  a(armature_current, speed) = -motor_.emf_constant / motor_.inductance;
  a(armature_current, kInput) = (clamped ? 1.0 : drive_.velocity_gain) / motor_.inductance;
  if (!clamped) {
    a(armature_current, measured_speed) = -drive_.velocity_gain / motor_.inductance;
    a(armature_current, integral) =
        drive_.velocity_gain * drive_.velocity_reset / motor_.inductance;
    a(integral, kInput) = 1.0;
    a(integral, measured_speed) = -1.0;
  }
  if (!stuck) {
    a(speed, armature_current) = motor_.torque_constant / motor_.inertia;
    a(speed, speed) = -motor_.viscous_friction / motor_.inertia;
    a(speed, kFriction) = 1.0 / motor_.inertia;
    a(kAngle, speed) = 1.0;
  }
  a(measured_speed, speed) = 1.0 / drive_.fv_time_constant;
  a(measured_speed, measured_speed) = -1.0 / drive_.fv_time_constant;

  const Matrix over_substep = (a * substep_).exp();
  Transition result{};
  for (int column = 0; column < kStates + kInputs; ++column)
    for (int row = 0; row <= kAngle; ++row)
      result[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] =
          over_substep(row, column < kStates ? column : column + 1);
  return result;
}

void ServoAxis::reset(double position) noexcept {
  state_ = {};
  angle_ = position / mm_per_rad_;
  commanded_ = counts_(position);
  pulses_ = 0;
  alarm_ = Alarm::none;
  read_counter();
}

void ServoAxis::advance(std::span<const CommandPulse> pulses) noexcept {
  auto next = pulses.begin();
  for (; next != pulses.end() && next->part <= kSameInstant; ++next) take(*next);
  read_counter();
  for (int i = 0; i < substeps_; ++i) step();
  for (; next != pulses.end(); ++next) take(*next);
  read_counter();
}

void ServoAxis::take(const CommandPulse& pulse) noexcept {
  ++pulses_;
  if (drive_.lost_pulse > 0 && pulses_ % drive_.lost_pulse == 0) {
    if (alarm_ == Alarm::none) alarm_ = Alarm::lost_pulses;
    return;
  }
  commanded_ += pulse.direction;
}

std::int64_t ServoAxis::encoder_counts() const noexcept {
  const double edges = std::floor(angle_ * counts_per_rad_ + 0.5);
  return static_cast<std::int64_t>(std::floor(edges * blu_per_count_ + 0.5));
}

void ServoAxis::read_counter() noexcept {
  const std::int64_t difference = commanded_ - encoder_counts();
  counter_ = std::clamp(difference, -counter_limit_, counter_limit_ - 1);
  if (alarm_ != Alarm::none) return;
  if (counter_ != difference)
    alarm_ = Alarm::counter_overflow;
  else if (std::abs(difference) > following_error_limit_)
    alarm_ = Alarm::following_error;
}

/// PI of the speed error, within supply and current limit.
ServoAxis::Amplifier ServoAxis::amplifier() const noexcept {
  const double command = static_cast<double>(counter_) * rad_s_per_blu_;
  const double wanted = drive_.velocity_gain * (command - state_[measured_speed] +
                                                drive_.velocity_reset * state_[integral]);
  const double emf = motor_.emf_constant * state_[speed];
  const double reach = motor_.resistance * drive_.current_limit;
  const double within_current = std::clamp(wanted, emf - reach, emf + reach);
  const double voltage = std::clamp(within_current, -drive_.supply_voltage, drive_.supply_voltage);
  const bool clamped = voltage != wanted;
  return {clamped, clamped ? voltage : command};
}

/// Against the motion; at rest against the motor, and stuck as long as that is the weaker.
ServoAxis::Friction ServoAxis::friction() const noexcept {
  if (state_[speed] != 0.0) return {false, -std::copysign(motor_.coulomb_friction, state_[speed])};
  const double torque = motor_.torque_constant * state_[armature_current];
  if (std::abs(torque) < motor_.coulomb_friction) return {true, 0.0};
  return {false, -std::copysign(motor_.coulomb_friction, torque)};
}

void ServoAxis::step() noexcept {
  const Amplifier drive = amplifier();
  const Friction brake = friction();
  const Transition& over = transitions_[mode(drive.clamped, brake.stuck)];
  const std::array<double, kStates + kInputs> x{state_[0], state_[1],   state_[2],
                                                state_[3], drive.input, brake.torque};
  std::array<double, kOutputs> y{};
  for (std::size_t column = 0; column < x.size(); ++column)
    for (std::size_t row = 0; row < y.size(); ++row) y[row] += over[column][row] * x[column];

  const double before = state_[speed];
  std::copy_n(y.begin(), static_cast<int>(kStates), state_.begin());
  if (motor_.coulomb_friction > 0 && before * state_[speed] < 0) {
    // Came to rest on the way, at a nearly constant deceleration.
    angle_ += 0.5 * before * substep_ * before / (before - state_[speed]);
    state_[speed] = 0;
  } else {
    angle_ += y[kAngle];
  }
}

}  // namespace softcnc::hal
