// SPDX-License-Identifier: MIT
// What the interpolator hands to a backend each period, and what comes back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "motion/core/axes.hpp"
#include "motion/model/limit.hpp"
#include "motion/model/outputs.hpp"
#include "motion/pulses/pulse.hpp"

namespace softcnc {

/// A clock of a staircase, and when it comes: as a part of the period that the setpoint ends.
struct TimedStep {
  double part = 0;
  Step step;
};

/// Where the machine is to be at an instant between two setpoints.
struct FinePoint {
  double s = 0;                              // mm of path from the start of the program
  AxisVector position = AxisVector::Zero();  // mm
};

struct Setpoint {
  std::int64_t period = 0;  // counts from 0; t = period * control.period
  int line = 0;             // physical line on which the block begins
  int block = 0;            // 1-based number of the block
  double s = 0;             // mm of path from the start of the program
  double v = 0;             // mm/s, planned
  double a = 0;             // mm/s^2 along the path, planned
  double advance = 0;       // mm: the planned speed integrated since the last setpoint
  double feed = 0;          // mm/s, as programmed, with its override; 0 in rapids and between moves
  Limit limit = Limit::stop;
  AxisVector position = AxisVector::Zero();  // mm, commanded
  Outputs outputs{};                         // that are on, from here on
  /// For a method of reference pulses: those that lead here from the last setpoint, in order. They
  /// are valid until the next setpoint is made.
  std::span<const TimedStep> pulses{};
  /// Where the machine is at evenly spaced instants of the period that ends here, the last one its
  /// end: the plan itself, or a spline for methods that advance by their own rule. Empty before the
  /// first period, and where they are not needed. They are valid as long as the pulses.
  std::span<const FinePoint> fine{};
  /// How many of them, the first ones, lie before the rest that has come since the last setpoint.
  std::size_t before_rest = 0;
};

/// Calls visit(point) for `parts` evenly spaced instants of the period that ends in a setpoint and
/// began at `before`; the last one is the setpoint. Where the setpoint has no fine points, the
/// motion in between is uniform. There may be more fine points, by a whole factor.
template <typename Visit>
void for_instants(const Setpoint& setpoint, const FinePoint& before, int parts, Visit&& visit) {
  const auto count = static_cast<std::size_t>(parts);
  const std::size_t stride = setpoint.fine.size() / count;
  for (std::size_t k = 1; k < count; ++k) {
    const double part = static_cast<double>(k) / parts;
    visit(stride > 0 ? setpoint.fine[k * stride - 1]
                     : FinePoint{before.s + part * (setpoint.s - before.s),
                                 before.position + part * (setpoint.position - before.position)});
  }
  visit(FinePoint{setpoint.s, setpoint.position});
}

enum class Alarm : std::uint8_t {
  none,
  following_error,
  counter_overflow,
  lost_pulses,
  overrun,
  port,
  emergency_stop,
  limit_switch,
  driver_fault,
};

std::string_view name(Alarm alarm) noexcept;

struct Feedback {
  AxisVector position = AxisVector::Zero();  // mm, actual
  Alarm alarm = Alarm::none;
  int alarm_axis = -1;
  std::array<bool, kAxes> home{};  // whether the home switch of an axis is closed,
  /// and where the axis was in this period when that changed last, mm; else its position. As fine
  /// as the backend reads its switches.
  AxisVector switched = position;
  bool probe = false;             // whether the probe touches,
  AxisVector touched = position;  // mm: and the same for it
  bool door = false;              // whether it is open
};

}  // namespace softcnc
