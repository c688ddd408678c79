// SPDX-License-Identifier: MIT
// The distance of a staircase of reference pulses from its curve (paper 003, section 5).
#pragma once

#include <cstdint>
#include <span>

#include "motion/model/machine.hpp"
#include "motion/model/path_stretch.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc {

/// Measures every position that the clocks of a staircase visit, including the start, by its
/// distance from the curve: the error of Table 3 of paper 003.
class StaircaseError {
 public:
  explicit StaircaseError(const Machine& machine) noexcept;

  /// Starts at the position where the staircase begins.
  void start(const Setpoint& first, std::span<const PathStretch> stretches) noexcept;

  /// Measures the positions that the pulses of `now` visit after those of `before`. `stretches` are
  /// the paths from the one of `before` to the one of `now`, in order.
  void period(const Setpoint& before, const Setpoint& now,
              std::span<const PathStretch> stretches) noexcept;

  double largest() const noexcept { return largest_; }  // mm
  /// Returns the largest error in the last period, mm; 0 where it has no pulses.
  double largest_of_period() const noexcept { return of_period_; }
  /// Over all clocks, mm; 0 before the first one.
  double mean() const noexcept { return places_ > 0 ? sum_ / static_cast<double>(places_) : 0; }

 private:
  void add(const AxisVector& place, double s, std::span<const PathStretch> stretches) noexcept;

  AxisVector blu_;  // mm
  double largest_ = 0, of_period_ = 0, sum_ = 0;
  std::int64_t places_ = 0;
};

}  // namespace softcnc
