// SPDX-License-Identifier: MIT
// What a screw with backlash and pitch errors makes of the position of its motor.
#pragma once

#include <algorithm>

#include "hal/signals/pitch_errors.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// A table behind a nut with play. The screw pushes the nut in positive direction at once; in
/// negative direction it first turns through the backlash, while friction holds the table. The nut
/// is then off by the error of the pitch where it stands.
class LeadScrew {
 public:
  explicit LeadScrew(const Screw& screw) : backlash_(screw.backlash), errors_(screw.pitch_table) {}

  /// The screw stands at `motor`, mm, and has come there in positive direction. Realtime.
  void begin(double motor) noexcept { nut_ = motor; }
  /// The screw turns to `motor`, mm, without turning back on the way. Realtime.
  void turn(double motor) noexcept { nut_ = std::clamp(nut_, motor, motor + backlash_); }

  /// Returns the position of the table, mm.
  double table() const noexcept { return nut_ + errors_(nut_); }

 private:
  double backlash_;  // mm
  PitchErrors errors_;
  double nut_ = 0;  // mm, without pitch errors
};

}  // namespace softcnc::hal
