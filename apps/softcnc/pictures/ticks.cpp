// SPDX-License-Identifier: MIT
#include "pictures/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace softcnc::app {
namespace {

constexpr double kRounding = 1e-9;  // of a step

Ticks ticks_of(double low, double high, double step, int exponent) {
  Ticks ticks;
  ticks.step = step;
  ticks.first = static_cast<std::int64_t>(std::ceil(low / step - kRounding));
  const auto last = static_cast<std::int64_t>(std::floor(high / step + kRounding));
  ticks.count = static_cast<int>(std::max<std::int64_t>(last - ticks.first + 1, 0));
  ticks.decimals = std::max(-exponent, 0);
  return ticks;
}

/// Exact for the powers that a double holds.
double power_of_ten(int exponent) {
  return exponent < 0 ? 1 / std::pow(10.0, -exponent) : std::pow(10.0, exponent);
}

}  // namespace

std::string Ticks::label(int i) const { return fmt::format("{:.{}f}", at(i), decimals); }

Ticks round_ticks(double low, double high, int most) {
  assert(low < high && most >= 2);
  int exponent = static_cast<int>(std::floor(std::log10((high - low) / most))) - 1;
  for (;; ++exponent)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double step =
          exponent < 0 ? digit / power_of_ten(-exponent) : digit * power_of_ten(exponent);
      if ((high - low) / step > most) continue;
      const Ticks ticks = ticks_of(low, high, step, exponent);
      if (ticks.count <= most) return ticks;
    }
}

TimeUnit time_unit(double duration) noexcept {
  if (duration <= 300) return {1, "s"};
  if (duration <= 5 * 3600) return {60, "min"};
  return {3600, "h"};
}

}  // namespace softcnc::app
