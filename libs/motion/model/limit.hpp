// SPDX-License-Identifier: MIT
// What can limit the speed of the machine, and what each limit is called.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace softcnc {

enum class Limit : std::uint8_t {
  feed,
  rapid,
  chord,
  contour,
  corner,
  roughness,
  axis_velocity,
  acceleration,
  drive,
  jerk,
  pulse_rate,
  tangential,
  normal,
  custom,
  override_,
  hold,
  stop,
};

/// The names of the limits, in the order of the enumeration: what the column `limit` of a trace
/// holds, and the keys of `time_by_limit_s` in a report. docs/feed.md has a row for each.
inline constexpr auto kLimitNames = std::to_array<std::string_view>({
    "feed",
    "rapid",
    "chord",
    "contour",
    "corner",
    "roughness",
    "axis_velocity",
    "acceleration",
    "drive",
    "jerk",
    "pulse_rate",
    "tangential",
    "normal",
    "custom",
    "override",
    "hold",
    "stop",
});
inline constexpr int kLimits = static_cast<int>(kLimitNames.size());
static_assert(kLimits == static_cast<int>(Limit::stop) + 1);

constexpr std::string_view name(Limit limit) noexcept {
  return kLimitNames[static_cast<std::size_t>(limit)];
}

}  // namespace softcnc
