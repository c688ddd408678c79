// SPDX-License-Identifier: MIT
// Simulated home switches: each closed from one place of its axis on.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// The switches stay where they are, whatever coordinates the commands count in: where these begin
/// again, only the numbers of the places change. At first they are those of the machine.
class HomeSwitches {
 public:
  explicit HomeSwitches(const Machine& machine);

  /// The axes have come through these places, mm, the last one of which is that of the feedback.
  void read(std::span<const AxisVector> places, Feedback& feedback) noexcept;
  /// Returns what leads from the coordinates of the commands to those of the machine file, mm.
  const AxisVector& offset() const noexcept { return offset_; }
  /// The next place is where the axes stand already, in other coordinates.
  void begin_again() noexcept { begins_again_ = true; }

 private:
  struct Switch {
    int axis;
    double place;      // mm, coordinates of the machine
    double direction;  // towards it: -1 or 1
    bool closed = false;
  };

  std::vector<Switch> switches_;
  std::optional<AxisVector> last_;          // mm, coordinates of the commands,
  AxisVector offset_ = AxisVector::Zero();  // mm: from them to those of the machine
  bool begins_again_ = false;
};

}  // namespace softcnc::hal
