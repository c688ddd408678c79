// SPDX-License-Identifier: MIT
#include "runtime/operator/jog_move.hpp"

#include <algorithm>
#include <cmath>

#include "hal/files/number.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::runtime {
namespace {

const Axis& axis_of(const Machine& machine, int axis) {
  return machine.axes[static_cast<std::size_t>(axis)];
}

/// The part of the distance after which the first axis is at the end of its travel.
double part_to_end(const Jog& jog, const AxisVector& from, const Machine& machine) {
  double part = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kAxes; ++i) {
    if (jog.distance[i] == 0) continue;
    const double end = jog.distance[i] > 0 ? axis_of(machine, i).max : axis_of(machine, i).min;
    part = std::min(part, std::max((end - from[i]) / jog.distance[i], 0.0));
  }
  return part;
}

bool leaves_travel(double from, double to, const Axis& axis) {
  return (to > axis.max && to > from) || (to < axis.min && to < from);
}

constexpr double kShown = 1e4;  // parts of a mm

Diagnostic beyond(int axis, double to, const Machine& machine) {
  const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
  return {.code = Code::SC4001,
          .message = std::string("a jog to ") + letter +
                     hal::number_text(std::round(to * kShown) / kShown) + " leaves the travel " +
                     letter + hal::number_text(axis_of(machine, axis).min) + " to " + letter +
                     hal::number_text(axis_of(machine, axis).max)};
}

}  // namespace

Result<AxisVector> jog_end(const Jog& jog, const AxisVector& from, const Machine& machine) {
  const auto fail = [](const char* why) {
    return tl::make_unexpected(Diagnostic{.code = Code::SC5080, .message = why});
  };
  if (!jog.distance.allFinite() || jog.distance.isZero(0)) return fail("a jog needs a distance");
  if (!(jog.feed > 0) || !std::isfinite(jog.feed)) return fail("a jog needs a feed above 0");
  for (int i = 0; i < kAxes; ++i)
    if (jog.distance[i] != 0 && !axis_of(machine, i).present)
      return fail("a jog of an axis that the machine does not have");
  const AxisVector to =
      from + (jog.continuous ? part_to_end(jog, from, machine) : 1.0) * jog.distance;
  for (int i = 0; i < kAxes; ++i)
    if (!jog.continuous && leaves_travel(from[i], to[i], axis_of(machine, i)))
      return tl::make_unexpected(beyond(i, to[i], machine));
  return to;
}

Machine without_travel(Machine machine) {
  for (Axis& axis : machine.axes) {
    axis.min = -kFarthest;
    axis.max = kFarthest;
  }
  return machine;
}

}  // namespace softcnc::runtime
