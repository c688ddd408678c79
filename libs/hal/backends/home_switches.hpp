// SPDX-License-Identifier: MIT
// Simulated home switches: each closed from one place of its axis on.
#pragma once

#include <span>
#include <vector>

#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// The switches stay where they are, whatever coordinates the commands count in: where these begin
/// again, only the numbers of the places change.
class HomeSwitches {
 public:
  explicit HomeSwitches(const Machine& machine);

  /// Returns whether an axis has one.
  static bool any(const Machine& machine) noexcept;

  /// The axes stand at `place`, mm, in the coordinates that now count. Before the first call they
  /// are those of the machine.
  void begin(const AxisVector& place) noexcept;
  /// The axes have come through these places, mm, the last one of which is that of the feedback.
  void read(std::span<const AxisVector> places, Feedback& feedback) noexcept;

 private:
  struct Switch {
    int axis;
    double place;      // mm, coordinates of the machine
    double direction;  // towards it: -1 or 1
    bool closed = false;
  };

  std::vector<Switch> switches_;
  AxisVector last_ = AxisVector::Zero();    // mm, coordinates of the commands,
  AxisVector offset_ = AxisVector::Zero();  // mm: from them to those of the machine
  bool begun_ = false;
};

}  // namespace softcnc::hal
