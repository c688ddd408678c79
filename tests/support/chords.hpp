// SPDX-License-Identifier: MIT
// Curves chopped into short lines, as CAM systems write them.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "motion/block.hpp"

namespace softcnc::test {

/// Half circles and sine waves in turn along x, joined at corners; `radius` mm is the smallest of
/// either. Lines of `chord` mm, their ends rounded to `grid` mm.
class Chopped {
 public:
  Chopped(double radius, double chord, double grid) : radius_(radius), chord_(chord), grid_(grid) {}

  /// `count` lines.
  std::vector<AxisVector> points(int count) {
    std::vector<AxisVector> points{on_grid({0, 0, 0})};
    double x = 0;
    for (bool circle = true; std::ssize(points) <= count; circle = !circle)
      x = circle ? add_half_circle(points, x) : add_sine(points, x);
    points.resize(static_cast<std::size_t>(count) + 1);
    return points;
  }

 private:
  double add_half_circle(std::vector<AxisVector>& points, double x) const {
    const double length = std::numbers::pi * radius_;
    const int lines = static_cast<int>(length / chord_);
    for (int i = 1; i <= lines; ++i) {
      const double angle = std::numbers::pi * i / lines;
      points.push_back(
          on_grid({x + radius_ * (1 - std::cos(angle)), radius_ * std::sin(angle), 0}));
    }
    return x + 2 * radius_;
  }

  /// y = -A sin(k x): its smallest radius is 1 / (A k^2).
  double add_sine(std::vector<AxisVector>& points, double x) const {
    const double amplitude = radius_, k = 1 / radius_;
    const double period = 2 * std::numbers::pi / k;
    double along = 0;
    while (along < period) {
      const double slope = amplitude * k * std::cos(k * along);
      along = std::min(period, along + chord_ / std::hypot(1.0, slope));
      points.push_back(on_grid({x + along, -amplitude * std::sin(k * along), 0}));
    }
    return x + period;
  }

  AxisVector on_grid(const AxisVector& point) const {
    return grid_ > 0 ? AxisVector((point / grid_).array().round() * grid_) : point;
  }

  double radius_, chord_, grid_;
};

}  // namespace softcnc::test
