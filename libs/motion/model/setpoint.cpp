// SPDX-License-Identifier: MIT
#include "motion/model/setpoint.hpp"

#include <array>

namespace softcnc {

std::string_view name(Alarm alarm) noexcept {
  constexpr std::array<std::string_view, 9> names{
      "none", "following error", "counter overflow", "lost pulses", "overrun",
      "port", "emergency stop",  "limit switch",     "driver fault"};
  return names[static_cast<std::size_t>(alarm)];
}

}  // namespace softcnc
