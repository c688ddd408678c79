// SPDX-License-Identifier: MIT
// Curves chopped into short lines, as CAM systems write them.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "motion/model/block.hpp"

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

/// The figure of docs/corners.md, lap after lap: half waves y = R sin(x / R) from crest to trough
/// and half circles of R back up, and the same mirrored; its curvature has no jump. `count` lines
/// of `chord` mm, rounded to 1e-4.
inline std::vector<AxisVector> chopped_laps(double radius, double chord, int count) {
  constexpr int kParts = 400;  // of a section, as straight as is needed to walk along them
  const auto at = [&](int section, double w) {
    AxisVector p(w, std::cos(w), 0);
    if (section % 2 == 1) p = {std::numbers::pi + std::sin(w), -std::cos(w), 0};
    if (section % 4 >= 2) p[0] = std::numbers::pi - p[0];
    return AxisVector(radius * p);
  };
  const auto rounded = [](const AxisVector& p) {
    return AxisVector((p * 1e4).array().round() / 1e4);
  };
  std::vector<AxisVector> points{rounded(at(0, 0))};
  AxisVector before = at(0, 0);
  double rest = chord;
  for (int section = 0; std::ssize(points) <= count; ++section)
    for (int i = 1; i <= kParts && std::ssize(points) <= count; ++i) {
      const AxisVector here = at(section, std::numbers::pi * i / kParts);
      for (double way = (here - before).norm(); way >= rest; way = (here - before).norm()) {
        before += rest / way * (here - before);
        points.push_back(rounded(before));
        rest = chord;
      }
      rest -= (here - before).norm();
      before = here;
    }
  points.resize(static_cast<std::size_t>(count) + 1);
  return points;
}

}  // namespace softcnc::test
