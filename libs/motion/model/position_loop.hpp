// SPDX-License-Identifier: MIT
// The linear part of a servo axis: its position loop, as its machine file describes it.
#pragma once

#include "motion/model/machine.hpp"

namespace softcnc {

/// Returns |P(i w)|: of the position loop closed by a counter that is read every `loop_period` s
/// and held until then, over the velocity loop of the axis. `w` in rad/s.
double position_gain(const Axis& axis, double loop_period, double w);

/// Returns the lead time of an axis, s: of all times that with which the largest error over all
/// circles that its velocity and its acceleration allow is the least, with the linear part of its
/// model. A circle of the angular speed w is cut larger by its radius times
/// |P(i w)| sqrt(1 + (w t)^2) - 1, where P is the closed position loop.
double lead_time(const Axis& axis, double loop_period);

/// Returns whether the plan limits what the drives leave of the path: where there is a tolerance,
/// and commands do not make up for all of the lag.
constexpr bool limits_contour(const Control& control) noexcept {
  return control.contour_tolerance > 0 && control.follow != Follow::model;
}

}  // namespace softcnc
