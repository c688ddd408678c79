// SPDX-License-Identifier: MIT
#include "motion/model/setpoint.hpp"

#include <array>

namespace softcnc {

std::string_view name(Limit limit) noexcept {
  constexpr std::array<std::string_view, kLimits> names{
      "feed", "rapid",      "chord",      "corner", "roughness", "axis_velocity", "acceleration",
      "jerk", "pulse_rate", "tangential", "normal", "override",  "hold",          "stop"};
  return names[static_cast<std::size_t>(limit)];
}

std::string_view name(Alarm alarm) noexcept {
  constexpr std::array<std::string_view, 9> names{
      "none", "following error", "counter overflow", "lost pulses", "overrun",
      "port", "emergency stop",  "limit switch",     "driver fault"};
  return names[static_cast<std::size_t>(alarm)];
}

}  // namespace softcnc
