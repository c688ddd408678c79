// SPDX-License-Identifier: MIT
// Where a machine is to be at one instant, and where it is.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

namespace softcnc::api {

/// The axes X, Y and Z, in this order.
inline constexpr int kAxes = 3;

/// One number per axis: mm, mm/s or mm/s^2.
using AxisVector = Eigen::Matrix<double, kAxes, 1>;

struct Setpoint {
  std::int64_t period = 0;  // counts from 0
  double t = 0;             // s from the start of the program
  int line = 0;             // of the program, from 1; 0: of no line
  int block = 0;            // from 1
  double s = 0;             // mm of path from the start of the program
  double v = 0;             // mm/s along the path
  double a = 0;             // mm/s^2 along the path
  double feed = 0;          // mm/s, as programmed, with its override; 0 in rapids and at rest
  std::string_view limit;   // what limits the speed: "feed", "chord", "acceleration", ...
  AxisVector position = AxisVector::Zero();  // mm, commanded
};

/// What a backend returns after one period.
struct Feedback {
  AxisVector position = AxisVector::Zero();  // mm, actual
  bool alarm = false;                        // nothing moves any more
  std::array<bool, kAxes> home{};            // whether the home switch of an axis is closed
};

}  // namespace softcnc::api
