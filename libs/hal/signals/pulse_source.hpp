// SPDX-License-Identifier: MIT
// The command pulses of an axis, from either source.
#pragma once

#include <algorithm>

#include "hal/signals/fine_pulses.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// By a method of reference pulses those of the staircase itself, otherwise those between the fine
/// points of the setpoints. Either way the pulses so far are the counts of the position.
class PulseSource {
 public:
  PulseSource(int axis, const Machine& machine) noexcept
      : axis_(axis),
        blu_(machine.axes[static_cast<std::size_t>(axis)].blu),
        by_method_(is_by_pulses(machine.control.interpolation)),
        fine_(blu_, 0) {}

  /// The counts begin at `position`, mm, without pulses. Realtime.
  void begin(double position) noexcept {
    fine_ = FinePulses(blu_, position);
    counts_ = fine_.counts();
  }

  /// Visits the pulses of the period, in order of time, as visit(part of the period, direction).
  /// Realtime.
  template <typename Visit>
  void move(const Setpoint& setpoint, Visit&& visit) noexcept {
    if (!by_method_) return follow(setpoint, visit);
    for (const TimedStep& timed : setpoint.pulses) {
      const int direction = timed.step[axis_];
      if (direction == 0) continue;
      counts_ += direction;
      visit(timed.part, direction);
    }
  }

  int axis() const noexcept { return axis_; }
  std::int64_t counts() const noexcept { return counts_; }
  double position() const noexcept { return position_of(counts_); }  // mm
  double position_of(std::int64_t counts) const noexcept { return Counts(blu_).position(counts); }

 private:
  template <typename Visit>
  void follow(const Setpoint& setpoint, Visit&& visit) noexcept {
    const int parts = std::max(static_cast<int>(setpoint.fine.size()), 1);
    int part = 0;
    for_instants(setpoint, {}, parts, [&](const FinePoint& point) {
      fine_.move(point.position[axis_], [&](double of_part, int direction) {
        visit((part + of_part) / parts, direction);
      });
      ++part;
    });
    counts_ = fine_.counts();
  }

  int axis_;
  double blu_;
  bool by_method_;
  FinePulses fine_;
  std::int64_t counts_ = 0;
};

}  // namespace softcnc::hal
