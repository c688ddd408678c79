// SPDX-License-Identifier: MIT
#include "runtime/session/axis_alarm.hpp"

#include <fmt/format.h>

#include <cmath>

namespace softcnc::runtime {

bool is_of_axis(Alarm alarm) noexcept {
  return alarm == Alarm::following_error || alarm == Alarm::counter_overflow ||
         alarm == Alarm::lost_pulses;
}

Diagnostic alarm_diagnostic(const Setpoint& last, const Feedback& feedback) {
  const int axis = feedback.alarm_axis;
  if (feedback.alarm == Alarm::lost_pulses)
    return {.code = Code::SC5020,
            .pos = {last.line, 0, 1},
            .message =
                fmt::format("lost pulses of {}: its counter has missed one on the way to {:.4f} mm",
                            kAxisLetters[static_cast<std::size_t>(axis)], last.position[axis])};
  const double lag = last.position[axis] - feedback.position[axis];
  const bool overflow = feedback.alarm == Alarm::counter_overflow;
  return {
      .code = overflow ? Code::SC5002 : Code::SC5001,
      .pos = {last.line, 0, 1},
      .message = fmt::format("{} of {}: it is {:.3f} mm behind its command", name(feedback.alarm),
                             kAxisLetters[static_cast<std::size_t>(axis)], std::abs(lag))};
}

}  // namespace softcnc::runtime
