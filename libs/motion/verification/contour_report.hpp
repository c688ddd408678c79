// SPDX-License-Identifier: MIT
// The figures of contour errors.
#pragma once

#include <cmath>
#include <cstdint>

namespace softcnc {

/// Contour errors of one kind of moves, over every instant of the position loop.
struct ContourFigures {
  double max = 0;      // mm
  double time = 0;     // s: when that was
  int line = 0;        // of the nearest point of the path then
  double speed = 0;    // mm/s, planned then
  double radius = 0;   // mm: of the path then between the nearest and the commanded point, in the
                       // mean; 0: it is straight
  double fastest = 0;  // mm/s: the highest speed planned
  double sum_of_squares = 0;  // mm^2
  std::int64_t instants = 0;

  double rms() const noexcept {  // mm
    return instants > 0 ? std::sqrt(sum_of_squares / static_cast<double>(instants)) : 0;
  }
};

struct ContourReport {
  /// The contour error for which the lags are given.
  static constexpr double kGoal = 0.01;  // mm

  ContourFigures cutting, rapids;
  /// How far the tool may lag behind its command, mm, so that the contour error is about kGoal in
  /// the tightest curve, and at the sharpest corner; 0: there is none.
  double curve_lag = 0, corner_lag = 0;
};

}  // namespace softcnc
