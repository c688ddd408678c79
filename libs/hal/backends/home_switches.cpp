// SPDX-License-Identifier: MIT
#include "hal/backends/home_switches.hpp"

#include <utility>

namespace softcnc::hal {

HomeSwitches::HomeSwitches(const Machine& machine) {
  for (int axis = 0; axis < kAxes; ++axis) {
    const Axis& of = machine.axes[static_cast<std::size_t>(axis)];
    if (has_home_switch(of)) switches_.push_back({axis, of.home.place, of.home.direction()});
  }
}

void HomeSwitches::read(std::span<const AxisVector> places, Feedback& feedback) noexcept {
  if (places.empty()) return;
  if (std::exchange(begins_again_, false) && last_) offset_ += *last_ - places.front();
  last_ = feedback.switched = places.back();
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
