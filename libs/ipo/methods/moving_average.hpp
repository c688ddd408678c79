// SPDX-License-Identifier: MIT
// Acceleration and deceleration after interpolation: an average over the last points.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "motion/core/axes.hpp"

namespace softcnc::ipo {

/// What is averaged: the position of each axis, mm, then the place along the program, mm, and the
/// speed along the path, mm/s.
using RoughPoint = Eigen::Matrix<double, kAxes + 2, 1>;

/// The mean of the last points. Averaging the positions of an axis averages its increments, so a
/// step of its speed becomes a ramp as long as the average.
class MovingAverage {
 public:
  /// Averages over `length` points, at least one.
  explicit MovingAverage(std::size_t length) : points_(length), equal_(length) {}

  /// Has rested at a point for ever.
  void start(const RoughPoint& point) noexcept;

  /// Realtime. Takes the next point and returns the mean. While all points are equal, the mean is
  /// exactly them.
  RoughPoint push(const RoughPoint& point) noexcept;

  /// Returns whether all points are equal.
  bool rests() const noexcept { return equal_ >= points_.size(); }

 private:
  std::vector<RoughPoint> points_;  // a ring
  std::size_t oldest_ = 0;
  std::size_t equal_;  // how many of the last points are equal
  RoughPoint mean_ = RoughPoint::Zero();
};

}  // namespace softcnc::ipo
