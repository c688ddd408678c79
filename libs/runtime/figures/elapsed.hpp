// SPDX-License-Identifier: MIT
// When, between two rows, a move has begun.
#pragma once

#include <algorithm>

#include "motion/model/setpoint.hpp"

namespace softcnc::runtime {

/// Returns how long ago a move began that has come so far, s: exact from rest at a constant
/// acceleration or a constant jerk, and at a constant speed.
inline double elapsed(double distance, const Setpoint& now) noexcept {
  if (!(now.v > 0)) return 0;
  const double gained = distance * std::max(0.0, now.a) / (now.v * now.v);  // 1/2, 2/3, 0
  const double factor = gained > 0.5 ? 2 + 6 * (gained - 0.5) : 1 + 2 * gained;
  return std::min(factor, 3.0) * distance / now.v;
}

}  // namespace softcnc::runtime
