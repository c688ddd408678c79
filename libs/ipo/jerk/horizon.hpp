// SPDX-License-Identifier: MIT
#pragma once

#include "ipo/limits/machine_limits.hpp"

namespace softcnc::ipo {

/// How much of the path ahead one plan with jerk limits covers, if it has not ended before.
struct Horizon {
  double stops = 10;  // stopping distances, and
  double time = 0.5;  // s that it lasts while its velocity limit stays, if it can be found

  /// All of the program in one plan, where kMostNodes are enough.
  static constexpr Horizon whole() noexcept { return {kUnlimited, kUnlimited}; }
};

}  // namespace softcnc::ipo
