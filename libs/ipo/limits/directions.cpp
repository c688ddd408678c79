// SPDX-License-Identifier: MIT
#include "ipo/limits/directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/geometry/extent.hpp"

namespace softcnc::ipo {

/// |x'| exceeds the line between its ends by at most an eighth of the change of x'' times the
/// length.
void Directions::add(const PathPoint& left, const PathPoint& right, double length) noexcept {
  const AxisVector swing = length / 8 * (right.ddq - left.ddq).cwiseAbs();
  const AxisVector ends = left.dq.cwiseAbs().cwiseMax(right.dq.cwiseAbs());
  part_ = part_.cwiseMax((ends + swing).cwiseMin(1.0));
}

void Directions::add(const Path& path) {
  const Extent box = bounds(path);
  for (int i = 0; i < kAxes; ++i)
    if (box.max[i] > box.min[i]) part_[i] = 1;
}

double Directions::least(const AxisVector& limits) const noexcept {
  const double largest = part_.maxCoeff();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kAxes; ++i)
    if (part_[i] > 0) least = std::min(least, limits[i] / (part_[i] / largest));
  return least;
}

/// What has no limit is not an axis of the machine, and moves only by rounding.
double Directions::most(const AxisVector& limits) const noexcept {
  double sum = 0, square = 0;
  for (int i = 0; i < kAxes; ++i) {
    if (!(part_[i] > 0) || !std::isfinite(limits[i])) continue;
    sum += part_[i] * limits[i];
    square += limits[i] * limits[i];
  }
  return std::min(sum, std::sqrt(square));
}

}  // namespace softcnc::ipo
