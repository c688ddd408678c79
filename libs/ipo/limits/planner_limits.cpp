// SPDX-License-Identifier: MIT
#include "ipo/limits/planner_limits.hpp"

namespace softcnc::ipo {

PlannerLimits limits_of(const Machine& machine) noexcept {
  PlannerLimits limits;
  limits.period = machine.control.period;
  limits.fine_period = softcnc::fine_period(machine.control);
  limits.chord_tolerance = machine.control.chord_tolerance;
  if (machine.limits.tangential > 0) limits.tangential = machine.limits.tangential;
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    limits.acceleration[i] = axis.present ? axis.acceleration : kUnlimited;
    limits.by_drive[static_cast<std::size_t>(i)] = axis.present && axis.drive_limits;
    limits.jerk[i] = axis.present && axis.jerk > 0 ? axis.jerk : kUnlimited;
  }
  limits.jerk = limits.jerk.cwiseMin(2 * limits.acceleration / limits.fine_period);
  const bool by_paper =  // which has acceleration limits only
      is_by_pulses(machine.control.interpolation) &&
      machine.control.pulse_clock == PulseClock::paper;
  if (by_paper || !limits_jerk(machine)) limits.jerk.setConstant(kUnlimited);
  return limits;
}

bool limits_jerk(const Machine& machine) noexcept {
  const double period = fine_period(machine.control);
  return std::any_of(machine.axes.begin(), machine.axes.end(), [&](const Axis& axis) {
    return axis.present && axis.jerk > 0 && axis.jerk * period < 2 * axis.acceleration;
  });
}

}  // namespace softcnc::ipo
