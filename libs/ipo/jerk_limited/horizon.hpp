// SPDX-License-Identifier: MIT
// How much of the path one plan with jerk limits covers.
#pragma once

#include "ipo/limits/planner_limits.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

/// How much of the path ahead one plan with jerk limits covers, if it has not ended before.
struct Horizon {
  double stops = tuning::horizon::kStops;  // stopping distances, and
  double time =
      tuning::horizon::kTime;  // s that it lasts while its velocity limit stays, if it can be found

  /// All of the program in one plan, where tuning::nodes::kMost are enough.
  static constexpr Horizon whole() noexcept { return {kUnlimited, kUnlimited}; }
};

}  // namespace softcnc::ipo
