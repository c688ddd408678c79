// SPDX-License-Identifier: MIT
#include "motion/verification/staircase_error.hpp"

#include <algorithm>
#include <cmath>

#include "motion/geometry/deviation.hpp"

namespace softcnc {
namespace {

double distance(const PathStretch& stretch, const AxisVector& place, double s) noexcept {
  const Portion whole{stretch.path, 0, length(*stretch.path)};
  const double foot = nearest(whole, place, s - stretch.s_start);
  return (position(*stretch.path, foot) - place).norm();
}

}  // namespace

StaircaseError::StaircaseError(const Machine& machine) noexcept {
  for (int axis = 0; axis < kAxes; ++axis)
    blu_[axis] = machine.axes[static_cast<std::size_t>(axis)].blu;
}

void StaircaseError::start(const Setpoint& first, std::span<const PathStretch> stretches) noexcept {
  if (!stretches.empty()) add(first.position, first.s, stretches);
}

void StaircaseError::period(const Setpoint& before, const Setpoint& now,
                            std::span<const PathStretch> stretches) noexcept {
  of_period_ = 0;
  if (stretches.empty()) return;
  AxisVector place = before.position;
  for (const TimedStep& clock : now.pulses) {
    for (int axis = 0; axis < kAxes; ++axis) place[axis] += clock.step[axis] * blu_[axis];
    add(place, std::lerp(before.s, now.s, clock.part), stretches);
  }
}

/// At a joint the position may be nearer to the path before it or after it.
void StaircaseError::add(const AxisVector& place, double s,
                         std::span<const PathStretch> stretches) noexcept {
  const PathStretch* here = &stretch_at(stretches, s);
  double off = distance(*here, place, s);
  if (here != &stretches.front()) off = std::min(off, distance(here[-1], place, s));
  if (here != &stretches.back()) off = std::min(off, distance(here[1], place, s));
  of_period_ = std::max(of_period_, off);
  largest_ = std::max(largest_, off);
  sum_ += off;
  ++places_;
}

}  // namespace softcnc
