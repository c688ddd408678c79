// SPDX-License-Identifier: MIT
// The command of an axis whose screw has backlash and pitch errors.
#pragma once

#include "hal/signals/pitch_errors.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// Adds to the position of the path what the screw loses: the pitch compensation of that position,
/// and by the direction of motion the backlash, 0 in positive and -backlash in negative direction.
/// The axis counts as having come in positive direction where it begins.
///
/// The direction is that of the path since it has last turned back by kTurned. The backlash is
/// added by a ramp: its speed changes by what the acceleration of the path leaves of the axis's, at
/// least a fifth of that, and falls by a fifth of it before the end. Path and addition together are
/// never faster than the axis; where the path leaves no speed, the addition waits, also that of
/// pitch errors.
class AxisCompensation {
 public:
  static constexpr double kTurned = 1e-5;         // mm
  static constexpr double kLeastShare = 1.0 / 5;  // of the acceleration of the axis

  AxisCompensation(const Axis& axis, const Screw& screw);

  /// Begins at rest at `position`, mm. Returns the command, mm. Realtime.
  double begin(double position) noexcept;

  /// Moves the path to `position`, mm, evenly over `time` s. Returns the command there, mm.
  /// Realtime.
  double move(double position, double time) noexcept;

  /// Makes positive the direction of the axis, which is at rest on its path: moves from now on take
  /// the backlash out again. The table, held by nothing but its friction, stays where it is.
  void release() noexcept { turn_at(path_, false); }

  /// Returns whether the command has all that direction and position ask for.
  bool is_complete() const noexcept { return added_ == wanted(); }

  /// Returns command minus path, mm.
  double added() const noexcept { return added_; }

 private:
  double wanted() const noexcept { return pitch_(path_) + (negative_ ? -backlash_ : 0.0); }
  void turn_at(double position, bool negative) noexcept;
  void watch_direction(double position) noexcept;
  double ramp(double left, double acceleration, double time) const noexcept;
  void keep_velocity(double before, double time) noexcept;

  PitchErrors pitch_;
  double backlash_, velocity_, acceleration_;
  double path_ = 0;        // mm
  double path_speed_ = 0;  // mm/s, of the last move
  double added_ = 0;       // mm: command minus path
  double ramp_speed_ = 0;  // mm/s: of the addition, apart from that of pitch errors
  bool negative_ = false;  // the direction
  double furthest_ = 0;    // mm: the path has come so far in it
};

}  // namespace softcnc::hal
