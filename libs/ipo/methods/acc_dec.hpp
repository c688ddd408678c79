// SPDX-License-Identifier: MIT
// The classical control: rough interpolation at constant feed, then acceleration and deceleration
// of each axis, then fine interpolation.
#pragma once

#include <cstddef>
#include <vector>

#include "ipo/methods/moving_average.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// How a method accelerates after interpolation.
struct AccDecShape {
  std::size_t averages = 0;  // one after the other; 0: the method does not
  std::size_t length = 1;    // rough points that each averages over
  int parts = 1;             // setpoints from one rough point to the next, on a straight line
  double step = 0;           // s: from one rough point to the next

  /// Returns the time, s, after which the setpoints rest where the path rests.
  double settling() const noexcept { return static_cast<double>(averages * length) * step; }
};

/// Returns the shape of the machine's method:
///   acc-dec-linear  one average over acc_dec_time(), every period: the speed of an axis becomes a
///                   ramp, and a circle of radius R at the angular speed w shrinks to
///                   R sinc(w tau / 2), where sinc(x) = sin(x) / x
///   acc-dec-bell    two such averages: the acceleration becomes a triangle, the radius
///                   R sinc^2(w tau / 2)
///   two-step        one average, every rough period, and straight lines of one setpoint per period
///                   from one rough point to the next: paper 000, figure 1
/// acc_dec_time() is rounded to whole rough points.
AccDecShape acc_dec_shape(const Machine& machine) noexcept;

/// Returns the time, s, by which a setpoint may lag behind the plan; 0 for all other methods.
double setpoint_lag(const Machine& machine) noexcept;

/// Turns rough points of the path into setpoints.
class AccDec {
 public:
  explicit AccDec(const AccDecShape& shape);

  const AccDecShape& shape() const noexcept { return shape_; }

  /// Begins at rest at a rough point, which is the first setpoint.
  void start(const RoughPoint& point) noexcept;

  /// Realtime. Returns whether the next setpoint needs a further rough point.
  bool wants_point() const noexcept { return part_ == shape_.parts; }
  /// Realtime. Takes the next rough point.
  void push(const RoughPoint& point) noexcept;

  /// Realtime. Returns the next setpoint.
  RoughPoint next() noexcept;

  /// Realtime. Returns whether all further setpoints equal the last one, if no other rough point
  /// comes.
  bool rests() const noexcept;

 private:
  AccDecShape shape_;
  std::vector<MovingAverage> averages_;
  RoughPoint from_ = RoughPoint::Zero(), to_ = RoughPoint::Zero();  // where the straight line leads
  int part_;                                                        // setpoints of it so far
};

}  // namespace softcnc::ipo
