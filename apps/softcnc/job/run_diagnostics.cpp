// SPDX-License-Identifier: MIT
#include "job/run_diagnostics.hpp"

#include <fmt/format.h>

#include <cmath>

namespace softcnc::app {

bool is_of_axis(Alarm alarm) noexcept {
  return alarm == Alarm::following_error || alarm == Alarm::counter_overflow ||
         alarm == Alarm::lost_pulses;
}

Diagnostic alarm_diagnostic(const runtime::Outcome& outcome) {
  const int axis = outcome.feedback.alarm_axis;
  if (outcome.feedback.alarm == Alarm::lost_pulses)
    return {.code = Code::SC5020,
            .pos = {outcome.last.line, 0, 1},
            .message = fmt::format(
                "lost pulses of {}: its counter has missed one on the way to {:.4f} mm",
                kAxisLetters[static_cast<std::size_t>(axis)], outcome.last.position[axis])};
  const double lag = outcome.last.position[axis] - outcome.feedback.position[axis];
  const bool overflow = outcome.feedback.alarm == Alarm::counter_overflow;
  return {.code = overflow ? Code::SC5002 : Code::SC5001,
          .pos = {outcome.last.line, 0, 1},
          .message = fmt::format("{} of {}: it is {:.3f} mm behind its command",
                                 name(outcome.feedback.alarm),
                                 kAxisLetters[static_cast<std::size_t>(axis)], std::abs(lag))};
}

Diagnostic missed_periods(const runtime::Punctuality& punctuality, const std::string& program) {
  const std::int64_t overruns = punctuality.overruns();
  return {
      .code = punctuality.rights.all() ? Code::SC5040 : Code::SC5041,
      .message = fmt::format("{} of {} periods {} missed; the latest came {:.1f} us late", overruns,
                             punctuality.lateness.wakeups(), overruns == 1 ? "was" : "were",
                             static_cast<double>(punctuality.lateness.largest()) / 1e3),
      .file = program};
}

}  // namespace softcnc::app
