// SPDX-License-Identifier: MIT
// The command with which a servo axis goes where it should be.
#pragma once

#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// Turns positions where an axis should be into commands for its drive, as control.follow says.
///
/// `lead` adds the speed times one time, lead_time(). `model` inverts the axis of the machine file:
/// from speed and acceleration of the position follow the current, J w' + B w and friction over Kt;
/// the voltage, R i + Ke w; the velocity command, by the PI amplifier and the lag of its F/V
/// converter; and the following error, that over Kv, by which the command is ahead. At rest the
/// command is the position. Speed and acceleration are differences of the positions so far, so that
/// nothing has to be known in advance. No command is faster than the axis.
class AxisFollowing {
 public:
  /// `loop_period`, s: how often the drive reads its counter.
  AxisFollowing(const Axis& axis, Follow follow, double loop_period);

  /// Begins at rest at `position`, mm, which is also the command. Realtime.
  void begin(double position) noexcept;

  /// Moves to `position`, mm, within `time` s. Returns the command there, mm. Realtime.
  double move(double position, double time) noexcept;

 private:
  double ahead(double speed, double acceleration, double time) noexcept;
  double following_error(double speed, double acceleration, double time) noexcept;

  Follow follow_;
  Motor motor_;
  Drive drive_;
  double mm_per_rad_, velocity_, loop_period_, lead_;
  double position_ = 0, speed_ = 0;  // mm, mm/s: of the last move
  double command_ = 0;               // mm
  double measured_speed_ = 0;        // rad/s: behind the F/V converter
  double integral_ = 0;              // rad: of the amplifier
};

}  // namespace softcnc::hal
