// SPDX-License-Identifier: MIT
// In what two runs may differ, and by how much.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace softcnc::runtime {

/// What is compared: the total time, the paths, and what each row has.
enum class Aspect : std::uint8_t { time, path, position, speed, line, limit };
inline constexpr auto kAspectNames =
    std::to_array<std::string_view>({"time", "path", "position", "speed", "line", "limit"});
inline constexpr std::size_t kAspects = kAspectNames.size();

constexpr std::string_view name(Aspect aspect) noexcept {
  return kAspectNames[static_cast<std::size_t>(aspect)];
}
/// Whether it is compared row by row.
constexpr bool is_of_rows(Aspect aspect) noexcept { return aspect >= Aspect::position; }

/// How large a difference may be: the larger of a number and a part of the value in the first run.
/// Of lines and limits none is allowed.
struct Margin {
  double absolute = 0;  // s, mm or mm/s
  double part = 0;
  bool judged = true;  // otherwise the difference is shown, and does not count

  double allowed(double value) const noexcept { return std::max(absolute, part * std::abs(value)); }
};
using Margins = std::array<Margin, kAspects>;

/// Returns what `replay` allows between builds: 1e-9 s, 1e-6 mm, and 1e-6 of a speed or 1e-6 mm/s.
constexpr Margins replay_margins() noexcept {
  return {Margin{1e-9}, Margin{1e-6}, Margin{1e-6}, Margin{1e-6, 1e-6}, Margin{}, Margin{}};
}

}  // namespace softcnc::runtime
