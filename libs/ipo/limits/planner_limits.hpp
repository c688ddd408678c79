// SPDX-License-Identifier: MIT
// The limits of a machine as the planner uses them: data, unlimited where the machine has no limit.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/core/axes.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

struct PlannerLimits {
  AxisVector acceleration;  // mm/s^2
  AxisVector jerk;          // mm/s^3; all unlimited, or none above what its axis can need
  std::array<bool, kAxes> by_drive{};  // whether its drive limits the acceleration of an axis
  double tangential = kUnlimited;      // mm/s^2: of the speed along the path
  double period = 0;                   // s: from sample to sample; chords are limited by it
  double fine_period = 0;      // s: from one fine point to the next; jumps are limited by it
  double chord_tolerance = 0;  // mm

  bool limits_jerk() const noexcept { return jerk.minCoeff() < kUnlimited; }
};

PlannerLimits limits_of(const Machine& machine) noexcept;

/// Whether any axis has a jerk limit that its acceleration limit does not imply: an acceleration
/// that changes from limit to limit within a fine period T shows as a jerk of 2 A / T.
bool limits_jerk(const Machine& machine) noexcept;

/// Returns the largest derivative along the path that keeps every axis: the minimum of limit / |x'|
/// over the axes.
inline double along(const AxisVector& limits, const AxisVector& direction) noexcept {
  double most = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (direction[i] != 0) most = std::min(most, limits[i] / std::abs(direction[i]));
  return most;
}

}  // namespace softcnc::ipo
