// SPDX-License-Identifier: MIT
// What writer and readers of lists of edges agree on.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hal/files/axis_name.hpp"
#include "hal/signals/step_edges.hpp"

namespace softcnc::hal {

inline constexpr std::string_view kBinaryHead = "edges 1\n";

/// In a byte of a time: another one follows.
inline constexpr unsigned kMore = 0x80;

/// The number of a line: 4 axis + 2 for its direction.
constexpr unsigned line_of(const SignalEdge& edge) noexcept {
  return 4U * edge.axis + (edge.wire == Wire::direction ? 2U : 0U);
}
constexpr SignalEdge edge_of(unsigned line, std::int64_t time, bool high) noexcept {
  return {time, static_cast<std::uint8_t>(line / 4), line & 2U ? Wire::direction : Wire::step,
          high};
}
/// The bound of the numbers of lines, of which every second one is a line.
inline constexpr unsigned kLineNumbers = 4 * kAxes;

/// Returns the name of a line: x_step, x_direction.
inline std::string line_name(unsigned line) {
  return axis_name(static_cast<int>(line / 4)) + (line & 2U ? "_direction" : "_step");
}

}  // namespace softcnc::hal
