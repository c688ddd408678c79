// SPDX-License-Identifier: MIT
// Fine points between the setpoints of a method that has no plan between them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

/// A spline through setpoints as they arrive: polynomials of degree 5 from each to the next, with
/// one velocity and one acceleration where they meet. Both are those of the parabola through the
/// previous setpoint, the setpoint, and the expected position of the next one; the spline passes
/// through the setpoints wherever the next one is. At rest both are 0.
class FineSpline {
 public:
  /// `parts` is the number of fine points in a period.
  explicit FineSpline(std::size_t parts);

  /// Adds the next setpoint and the expected position of the one after it; `out` receives the fine
  /// points that lead to the setpoint, as many as there are parts. Realtime.
  void add(const Setpoint& setpoint, const FinePoint& expected, std::span<FinePoint> out) noexcept;

 private:
  /// A position with its first and second difference over a period.
  struct Knot {
    FinePoint place, slope, second;
  };
  Knot knot(const Setpoint& setpoint, const FinePoint& expected) const noexcept;

  std::vector<std::array<double, 6>> weights_;  // of both knots, by point
  Knot last_;
  bool started_ = false;
};

}  // namespace softcnc::ipo
