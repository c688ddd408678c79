// SPDX-License-Identifier: MIT
// What a curve may cost: the speeds at which it will be run, before it is planned.
#pragma once

#include <vector>

#include "ipo/limits/planner_limits.hpp"

namespace softcnc::ipo {

/// The limits of the machine that bear on the shape of a curve.
struct ShapeLimits {
  AxisVector velocity = AxisVector::Constant(kUnlimited);  // mm/s
  AxisVector acceleration;                                 // mm/s^2
  AxisVector jerk;                                         // mm/s^3
  AxisVector least = AxisVector::Constant(-kUnlimited);    // mm: of the travel
  AxisVector most = AxisVector::Constant(kUnlimited);
  double feed = kUnlimited;             // mm/s
  double period = 0;                    // s
  double chord_tolerance = kUnlimited;  // mm
};

ShapeLimits shape_limits(const Machine& machine);

/// Whether the jerk limits of the axes that move are much alike. `shares` are the largest
/// components of directions.
bool are_alike(const ShapeLimits& limits, const AxisVector& shares) noexcept;

/// Lowers jerk limits far above that of the axis which needs most of its own: a curve that bends in
/// the direction of a quick axis alone is slow for all.
void even_out_jerk(ShapeLimits& limits, const AxisVector& shares) noexcept;

/// A place of the curve: derivatives by its parameter, which is near its length.
struct ShapePlace {
  double t;  // mm
  AxisVector dq, ddq;
  double feed;  // mm/s
};

/// Returns the speeds, mm/s, which curvature permits, with slopes as gentle as those of a machine
/// with jerk limits; the curvature is the mean of `smoothed` places.
std::vector<double> estimate_speeds(const std::vector<ShapePlace>& places,
                                    const ShapeLimits& limits, std::size_t smoothed);

}  // namespace softcnc::ipo
