// SPDX-License-Identifier: MIT
// The highest speed that a machine can have along a path.
#pragma once

#include <cmath>

#include "motion/model/machine.hpp"

namespace softcnc {

/// Returns the speed along the path, mm/s, that no move exceeds: that of all axes together, each at
/// its velocity limit.
inline double fastest_move(const Machine& machine) noexcept {
  double squares = 0;
  for (const Axis& axis : machine.axes)
    if (axis.present) squares += axis.velocity * axis.velocity;
  return std::sqrt(squares);
}

}  // namespace softcnc
