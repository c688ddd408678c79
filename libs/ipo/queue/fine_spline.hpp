// SPDX-License-Identifier: MIT
// Fine points between the setpoints of a method that has no plan between them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

/// A spline through setpoints as they come: polynomials of degree 5 from each to the next, with one
/// velocity and one acceleration where they meet. Both are those of the parabola through the
/// setpoint before, the setpoint, and where the next one is expected to be: it passes the setpoints
/// wherever that is. At rest they are 0.
class FineSpline {
 public:
  /// `parts`: fine points in a period.
  explicit FineSpline(std::size_t parts);

  /// The next setpoint, and where the one after it is expected; `out` gets the fine points that
  /// lead to it, as many as there are parts. Realtime.
  void add(const Setpoint& setpoint, const FinePoint& expected, std::span<FinePoint> out) noexcept;

 private:
  /// Place, and what it changes by in a period and by how much that does.
  struct Knot {
    FinePoint place, slope, bend;
  };
  Knot knot(const Setpoint& setpoint, const FinePoint& expected) const noexcept;

  std::vector<std::array<double, 6>> weights_;  // of both knots, by point
  Knot last_;
  bool started_ = false;
};

}  // namespace softcnc::ipo
