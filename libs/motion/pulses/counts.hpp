// SPDX-License-Identifier: MIT
// From millimetres to counts: the one rule by which positions become pulses.
#pragma once

#include <cmath>
#include <cstdint>

namespace softcnc {

/// Positions in whole basic length units (BLU): the position rounded to 1e-9 mm, then to the
/// nearest count, halves away from zero. Exact where the BLU is a whole number of 1e-9 mm.
class Counts {
 public:
  /// blu in mm, > 0.
  explicit Counts(double blu) noexcept : blu_(snap(blu * kPerMm)) {}

  /// Realtime. |position| < 1e6 mm.
  std::int64_t operator()(double position) const noexcept {
    return std::llround(std::round(position * kPerMm) / blu_);
  }

  /// Returns the position of a number of counts, mm.
  double position(std::int64_t counts) const noexcept {
    return static_cast<double>(counts) * blu_ / kPerMm;
  }

 private:
  static constexpr double kPerMm = 1e9;
  static double snap(double blu) noexcept {
    const double whole = std::round(blu);
    return std::abs(blu - whole) < 1e-6 ? whole : blu;
  }

  double blu_;  // in 1e-9 mm
};

}  // namespace softcnc
