// SPDX-License-Identifier: MIT
// Round numbers along an axis, and what they are called.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace softcnc::app {

/// Numbers that are multiples of a step of 1, 2 or 5 times a power of ten.
struct Ticks {
  std::int64_t first = 0;  // the smallest of them, in steps
  int count = 0;
  double step = 1;
  int decimals = 0;  // that a label needs

  double at(int i) const noexcept { return static_cast<double>(first + i) * step; }
  std::string label(int i) const;
};

/// Returns the ticks from `low` to `high`, both included, by the smallest step that gives at most
/// `most` of them. Requires low < high and most >= 2; both are finite.
Ticks round_ticks(double low, double high, int most);

/// The unit in which a duration is shown.
struct TimeUnit {
  double seconds = 1;
  std::string_view name = "s";
};
/// Returns seconds up to 5 min, minutes up to 5 h, hours from there on.
TimeUnit time_unit(double duration) noexcept;

}  // namespace softcnc::app
