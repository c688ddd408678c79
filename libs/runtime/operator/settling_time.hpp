// SPDX-License-Identifier: MIT
// How long drives take to come to rest behind their commands.
#pragma once

#include <algorithm>

#include "motion/model/machine.hpp"

namespace softcnc::runtime {

inline double settling_time(const Axis& axis) noexcept {
  constexpr double kTimeConstants = 6;  // of the position loop: to a part in 400
  constexpr double kLongest = 2;        // s
  return std::min(kTimeConstants / axis.drive.kv, kLongest);
}

/// Returns that of the slowest axis, s.
inline double settling_time(const Machine& machine) noexcept {
  double time = 0;
  for (const Axis& axis : machine.axes)
    if (axis.present) time = std::max(time, settling_time(axis));
  return time;
}

}  // namespace softcnc::runtime
