// SPDX-License-Identifier: MIT
#include "hal/backends/home_switches.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::hal {

HomeSwitches::HomeSwitches(const Machine& machine) {
  for (int axis = 0; axis < kAxes; ++axis) {
    const Axis& of = machine.axes[static_cast<std::size_t>(axis)];
    if (of.present && of.home.search != 0)
      switches_.push_back({axis, of.home.place, std::copysign(1.0, of.home.search)});
  }
}

bool HomeSwitches::any(const Machine& machine) noexcept {
  return std::any_of(machine.axes.begin(), machine.axes.end(),
                     [](const Axis& axis) { return axis.present && axis.home.search != 0; });
}

void HomeSwitches::begin(const AxisVector& place) noexcept {
  if (begun_) offset_ += last_ - place;
  begun_ = true;
  last_ = place;
  Feedback ignored;
  read(std::span(&place, 1), ignored);
}

void HomeSwitches::read(std::span<const AxisVector> places, Feedback& feedback) noexcept {
  if (places.empty()) return;
  feedback.switched = last_ = places.back();
  for (Switch& one : switches_) {
    for (const AxisVector& place : places) {
      const double beyond = (place[one.axis] + offset_[one.axis] - one.place) * one.direction;
      if (one.closed == (beyond >= 0)) continue;
      one.closed = !one.closed;
      feedback.switched[one.axis] = place[one.axis];
    }
    feedback.home[static_cast<std::size_t>(one.axis)] = one.closed;
  }
}

}  // namespace softcnc::hal
