// SPDX-License-Identifier: MIT
// The list of constraints. Whoever adds a reason to be slow adds a row.
#include "ipo/constraint.hpp"

namespace softcnc::ipo {

Constraints::Constraints(const Machine& machine, double feed_override)
    : period_(machine.control.period), chord_tolerance_(machine.control.chord_tolerance) {
  caps_.push_back(make_feed_limit(machine, feed_override));
  caps_.push_back(make_axis_velocity(machine));
  // The three-point method of paper 000 limits the chord error itself, at run time.
  if (machine.control.interpolation != Method::curvature3p)
    caps_.push_back(make_chord_error(machine));
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    acceleration_[i] = axis.present ? axis.acceleration : kUnlimited;
  }
}

Strips Constraints::acceleration(const PathPoint& point) const noexcept {
  return {point.ddq, point.dq, acceleration_};
}

}  // namespace softcnc::ipo
