// SPDX-License-Identifier: MIT
// What the interpolator hands to a backend each period, and what comes back.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "motion/axes.hpp"
#include "motion/pulse.hpp"

namespace softcnc {

/// What holds the feed down; its name() is the trace column and the report's key.
enum class Limit : std::uint8_t {
  feed,
  rapid,
  chord,
  corner,
  roughness,
  axis_velocity,
  acceleration,
  jerk,
  pulse_rate,
  tangential,
  normal,
  override_,
  hold,
  stop,
};
inline constexpr int kLimits = 14;

std::string_view name(Limit limit) noexcept;

/// A clock of a staircase, and when it comes: a part of the period that the setpoint ends.
struct TimedStep {
  double part = 0;
  Step step;
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
  /// By a method of reference pulses: those that lead here from the last setpoint, in order. They
  /// stand until the next setpoint is made.
  std::span<const TimedStep> pulses{};
};

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
};

}  // namespace softcnc
