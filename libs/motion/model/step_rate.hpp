// SPDX-License-Identifier: MIT
// How closely steps may follow each other where instants are whole ns: never closer than required.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "motion/core/units.hpp"
#include "motion/model/machine.hpp"

namespace softcnc {

/// Returns the shortest whole time, ns, that is not shorter than `seconds`, except for what
/// rounding of the double may have added.
inline std::int64_t least_ns(double seconds) noexcept {
  constexpr double kRoundOff = 1e-6;  // ns
  return static_cast<std::int64_t>(std::ceil(ns_from_s(seconds) - kRoundOff));
}

/// Returns the shortest whole time, ns, from step to step. Its rate is at most the largest one, and
/// a step has its length and its space.
inline std::int64_t step_interval(const StepPort& port) noexcept {
  const auto by_rate = static_cast<std::int64_t>(std::ceil(ns_from_s(1.0) / port.max_rate));
  return std::max(by_rate, least_ns(port.step_length) + least_ns(port.step_space));
}

/// Returns the largest rate, Hz, of steps in whole ns.
inline double step_rate(const StepPort& port) noexcept {
  return ns_from_s(1.0) / static_cast<double>(step_interval(port));
}

}  // namespace softcnc
