// SPDX-License-Identifier: MIT
#include "messages/duration_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace softcnc::app {

std::string duration_text(double seconds) {
  if (seconds < 59.995) return fmt::format("{:.2f} s", seconds);
  if (const double tenths = std::round(seconds * 10); tenths < 36000) {
    const double minutes = std::floor(tenths / 600);
    return fmt::format("{:.0f} m {:04.1f} s", minutes, (tenths - 600 * minutes) / 10);
  }
  const auto whole = static_cast<long long>(std::llround(seconds));
  return fmt::format("{} h {:02} m {:02} s", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace softcnc::app
