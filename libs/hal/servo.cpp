// SPDX-License-Identifier: MIT
// The equations of a servo axis and their exact discretisation.
#include "hal/servo.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

namespace softcnc::hal {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;  // rad

std::size_t mode_index(bool clamped, bool stuck) noexcept {
  return (clamped ? 2U : 0U) + (stuck ? 1U : 0U);
}

}  // namespace

ServoAxis::ServoAxis(const Axis& axis, double servo_period)
    : drive_(axis.drive),
      motor_(axis.motor),
      counts_(axis.blu),
      mm_per_rad_(axis.screw_lead / kTurn),
      counts_per_rad_(axis.counts_per_rev / kTurn),
      blu_per_count_(axis.screw_lead / axis.counts_per_rev / axis.blu),
      rad_s_per_blu_(axis.drive.kv * axis.blu / mm_per_rad_),
      counter_limit_(std::int64_t{1} << (axis.drive.counter_bits - 1)),
      following_error_limit_(static_cast<std::int64_t>(axis.drive.following_error / axis.blu)),
      substeps_(static_cast<int>(std::ceil(servo_period / kSubstep - 1e-9))),
      substep_(servo_period / substeps_) {
  for (const bool clamped : {false, true})
    for (const bool stuck : {false, true})
      transitions_[mode_index(clamped, stuck)] = transition(axis, {clamped, stuck});
}

/// L i' = u - R i - Ke w;  J w' = Kt i - B w + friction;  tau f' = w - f;  z' = r - f;  angle' = w;
/// u = Kp (r - f + z / Ti), or the clamped voltage, which then takes the place of r as input.
ServoAxis::Transition ServoAxis::transition(const Axis& axis, const Mode& mode) const {
  constexpr int kAngle = kStates, kInput = kOutputs, kFriction = kOutputs + 1;
  constexpr int kSize = kOutputs + kInputs;
  const Motor& m = axis.motor;
  const Drive& d = axis.drive;
  Eigen::Matrix<double, kSize, kSize> a = Eigen::Matrix<double, kSize, kSize>::Zero();
  a(armature_current, armature_current) = -m.resistance / m.inductance;
  a(armature_current, speed) = -m.emf_constant / m.inductance;
  a(armature_current, kInput) = (mode.clamped ? 1.0 : d.velocity_gain) / m.inductance;
  if (!mode.clamped) {
    a(armature_current, measured_speed) = -d.velocity_gain / m.inductance;
    a(armature_current, integral) = d.velocity_gain * d.velocity_reset / m.inductance;
    a(integral, kInput) = 1.0;
    a(integral, measured_speed) = -1.0;
  }
  if (!mode.stuck) {
    a(speed, armature_current) = m.torque_constant / m.inertia;
    a(speed, speed) = -m.viscous_friction / m.inertia;
    a(speed, kFriction) = 1.0 / m.inertia;
    a(kAngle, speed) = 1.0;
  }
  a(measured_speed, speed) = 1.0 / d.fv_time_constant;
  a(measured_speed, measured_speed) = -1.0 / d.fv_time_constant;
  const Eigen::Matrix<double, kSize, kSize> over_substep = (a * substep_).exp();

  Transition result{};
  for (int column = 0; column < kStates + kInputs; ++column)
    for (int row = 0; row < kOutputs; ++row)
      result[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] =
          over_substep(row, column < kStates ? column : column + 1);
  return result;
}

void ServoAxis::reset(double position) noexcept {
  state_ = {};
  angle_ = position / mm_per_rad_;
  commanded_ = counts_(position);
  alarm_ = Alarm::none;
  read_counter(commanded_);
}

void ServoAxis::advance(double command) noexcept {
  const std::int64_t from = commanded_;
  const std::int64_t pulses = counts_(command) - from;
  for (int i = 0; i < substeps_; ++i) {
    read_counter(from + pulses * i / substeps_);
    step();
  }
  commanded_ = from + pulses;
  read_counter(commanded_);
}

std::int64_t ServoAxis::encoder_counts() const noexcept {
  const double edges = std::floor(angle_ * counts_per_rad_ + 0.5);
  return static_cast<std::int64_t>(std::floor(edges * blu_per_count_ + 0.5));
}

void ServoAxis::read_counter(std::int64_t command_counts) noexcept {
  const std::int64_t difference = command_counts - encoder_counts();
  counter_ = std::clamp(difference, -counter_limit_, counter_limit_ - 1);
  if (alarm_ != Alarm::none) return;
  if (counter_ != difference)
    alarm_ = Alarm::counter_overflow;
  else if (std::abs(difference) > following_error_limit_)
    alarm_ = Alarm::following_error;
}

void ServoAxis::step() noexcept {
  const double command = static_cast<double>(counter_) * rad_s_per_blu_;
  const double wanted = drive_.velocity_gain * (command - state_[measured_speed] +
                                                drive_.velocity_reset * state_[integral]);
  const double emf = motor_.emf_constant * state_[speed];
  const double reach = motor_.resistance * drive_.current_limit;
  const double within_current = std::min(std::max(wanted, emf - reach), emf + reach);
  const double voltage = std::clamp(within_current, -drive_.supply_voltage, drive_.supply_voltage);
  const bool clamped = voltage != wanted;

  const double torque = motor_.torque_constant * state_[armature_current];
  const bool at_rest = state_[speed] == 0.0;
  const bool stuck = at_rest && std::abs(torque) <= motor_.coulomb_friction;
  const double friction =
      stuck ? 0.0 : -std::copysign(motor_.coulomb_friction, at_rest ? torque : state_[speed]);

  const Transition& over = transitions_[mode_index(clamped, stuck)];
  const std::array<double, kStates + kInputs> x{
      state_[0], state_[1], state_[2], state_[3], clamped ? voltage : command, friction};
  std::array<double, kOutputs> y{};
  for (std::size_t column = 0; column < x.size(); ++column)
    for (std::size_t row = 0; row < y.size(); ++row) y[row] += over[column][row] * x[column];

  const double before = state_[speed];
  std::copy_n(y.begin(), static_cast<int>(kStates), state_.begin());
  const bool reversed = motor_.coulomb_friction > 0 && before * state_[speed] < 0;
  if (reversed) {  // came to rest on the way, at a nearly constant deceleration
    angle_ += 0.5 * before * substep_ * before / (before - state_[speed]);
    state_[speed] = 0;
  } else {
    angle_ += y[kStates];
  }
}

}  // namespace softcnc::hal
