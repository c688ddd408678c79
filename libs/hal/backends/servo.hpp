// SPDX-License-Identifier: MIT
// One axis of the simulated mill: up/down counter, velocity loop, DC motor, screw.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"
#include "motion/pulses/counts.hpp"

namespace softcnc::hal {

/// A command pulse: when it comes, as a part of a servo period, and in which direction it counts.
struct CommandPulse {
  double part = 0;
  int direction = 0;
};

/// The servo axis of paper 003: command pulses and encoder pulses meet in an up/down counter; what
/// it holds is the velocity command; an F/V converter measures the speed from the encoder's
/// frequency; a PI amplifier drives a permanent-magnet DC motor.
///
/// The linear part (armature current, speed, F/V lag, integral, angle) is carried over a fixed
/// substep exactly, by a matrix exponential made once. The counter is read at the start of a servo
/// period, and what it holds is the velocity command until the next one. Limits and friction are
/// held over a substep:
/// - the amplifier's voltage is clamped to the supply, and to what drives the limiting current at
/// the
///   present speed; while clamped, the voltage stands still and so does the integral part;
/// - Coulomb friction is a constant torque against the motion. When the speed passes zero the axis
///   stops, and stays at rest until the motor's torque exceeds the friction.
/// The ripple of single pulses after the F/V converter is not modelled.
class ServoAxis {
 public:
  static constexpr double kSubstep = 0.25e-3;  // s, at most

  ServoAxis(const Axis& axis, double servo_period);

  /// Puts the drive at rest at `position`, which is also commanded. Realtime.
  void reset(double position) noexcept;

  /// Runs one servo period in which these command pulses come, in order of time. If the drive says
  /// so, every n-th pulse is lost before the counter, which is an alarm. Realtime.
  void advance(std::span<const CommandPulse> pulses) noexcept;

  double position() const noexcept { return angle_ * mm_per_rad_; }         // mm
  double velocity() const noexcept { return state_[speed] * mm_per_rad_; }  // mm/s
  double current() const noexcept { return state_[armature_current]; }      // A
  std::int64_t counter() const noexcept { return counter_; }                // BLU

  /// The first alarm since reset().
  Alarm alarm() const noexcept { return alarm_; }

 private:
  enum State { armature_current, speed, measured_speed, integral, kStates };
  static constexpr int kAngle = kStates;        // the angle turned, an output only
  static constexpr int kOutputs = kStates + 2;  // padded to whole pairs, for the vector units
  static constexpr int kInputs = 2;  // velocity command or motor voltage; friction torque

  /// Column by column: what each state and input adds to the outputs over one substep.
  using Transition = std::array<std::array<double, kOutputs>, kStates + kInputs>;

  /// What the amplifier does: as the linear equations say, or at a limit.
  struct Amplifier {
    bool clamped;
    double input;  // velocity command (rad/s), or the voltage at the limit (V)
  };
  struct Friction {
    bool stuck;
    double torque;  // Nm, with its sign
  };

  static std::size_t mode(bool clamped, bool stuck) noexcept {
    return (clamped ? 2U : 0U) + (stuck ? 1U : 0U);
  }
  Transition transition(bool clamped, bool stuck) const;

  std::int64_t encoder_counts() const noexcept;
  void take(const CommandPulse& pulse) noexcept;
  void read_counter() noexcept;
  Amplifier amplifier() const noexcept;
  Friction friction() const noexcept;
  void step() noexcept;

  Drive drive_;
  Motor motor_;
  Counts counts_;
  double mm_per_rad_, counts_per_rad_, blu_per_count_, rad_s_per_blu_;
  std::int64_t counter_limit_, following_error_limit_;  // BLU
  int substeps_;
  double substep_;  // s
  std::array<Transition, 4> transitions_;

  std::array<double, kStates> state_{};
  double angle_ = 0;                          // rad
  std::int64_t pulses_ = 0;                   // sent to the counter so far
  std::int64_t commanded_ = 0, counter_ = 0;  // BLU: by the pulses that have arrived
  Alarm alarm_ = Alarm::none;
};

}  // namespace softcnc::hal
