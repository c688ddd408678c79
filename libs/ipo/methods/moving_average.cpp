// SPDX-License-Identifier: MIT
#include "ipo/methods/moving_average.hpp"

#include <algorithm>

namespace softcnc::ipo {

void MovingAverage::start(const RoughPoint& point) noexcept {
  std::fill(points_.begin(), points_.end(), point);
  mean_ = point;
  equal_ = points_.size();
}

RoughPoint MovingAverage::push(const RoughPoint& point) noexcept {
  const std::size_t newest = (oldest_ == 0 ? points_.size() : oldest_) - 1;
  equal_ = point == points_[newest] ? std::min(equal_ + 1, points_.size()) : 1;
  mean_ += (point - points_[oldest_]) / static_cast<double>(points_.size());
  points_[oldest_] = point;
  oldest_ = oldest_ + 1 == points_.size() ? 0 : oldest_ + 1;
  if (rests()) mean_ = point;
  return mean_;
}

}  // namespace softcnc::ipo
