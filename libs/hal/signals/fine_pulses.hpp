// SPDX-License-Identifier: MIT
// From two positions of an axis to the pulses between them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "motion/pulses/counts.hpp"

namespace softcnc::hal {

/// The axis moves evenly from position to position, and a pulse comes at the instant at which it is
/// half a BLU beyond the last one: evenly spread in between, and at the same pace from one position
/// to the next. What does not make a whole pulse stays, so that the pulses so far are always
/// the counts of the position.
class FinePulses {
 public:
  /// Makes pulses of `blu` mm whose counts begin at `position`, mm.
  FinePulses(double blu, double position) noexcept
      : blu_(blu), counts_of_(blu), position_(position), counts_(counts_of_(position)) {}

  /// Visits the pulses up to `position`, mm, as visit(part of the time of the move, direction).
  /// Realtime.
  template <typename Visit>
  void move(double position, Visit&& visit) noexcept {
    const std::int64_t counts = counts_of_(position);
    const int direction = counts < counts_ ? -1 : 1;
    const double distance = (position - position_) / blu_;  // BLU
    const double from = position_ / blu_;
    for (; counts_ != counts; counts_ += direction) {
      const double beyond = static_cast<double>(counts_) + 0.5 * direction - from;
      visit(distance * direction > 0 ? std::clamp(beyond / distance, 0.0, 1.0) : 1.0, direction);
    }
    position_ = position;
  }

  std::int64_t counts() const noexcept { return counts_; }

 private:
  double blu_;
  Counts counts_of_;
  double position_;
  std::int64_t counts_;
};

}  // namespace softcnc::hal
