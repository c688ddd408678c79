// SPDX-License-Identifier: MIT
#include "ipo/queue/pulse_walk.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace softcnc::ipo {
namespace {

int longest_axis(const GridPoint& from, const GridPoint& to) noexcept {
  int lead = 0;
  const auto distance = [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    return std::abs(to[i] - from[i]);
  };
  for (int axis = 1; axis < kAxes; ++axis)
    if (distance(axis) > distance(lead)) lead = axis;
  return lead;
}

ClockDropper dropper_of(const Control& control) noexcept {
  return ClockDropper(pulse_method(control.interpolation),
                      control.constant_feed == ConstantFeed::on);
}

template <std::size_t... axis>
std::array<Counts, kAxes> counts_by_axis(const AxisVector& blu, std::index_sequence<axis...>) {
  return {Counts(blu[static_cast<int>(axis)])...};
}

}  // namespace

std::int64_t count_clocks(const Path& path, const AxisVector& blu, const Control& control) {
  Staircase staircase(path, blu, pulse_method(control.interpolation));
  ClockDropper dropper = dropper_of(control);
  std::array<Step, 256> steps;
  std::int64_t clocks = 0;
  while (const std::size_t n = staircase.fill(steps))
    std::for_each_n(steps.begin(), n, [&](Step step) { clocks += dropper.clocks(step); });
  return clocks;
}

PulseWalk::PulseWalk(Path path, const AxisVector& blu, const Control& control,
                     const GridPoint& from)
    : path_(std::move(path)),
      staircase_(path_, blu, pulse_method(control.interpolation)),
      counts_(counts_by_axis(blu, std::make_index_sequence<kAxes>())),
      length_(length(path_)),
      places_(places(blu)),
      at_(from) {
  if (has_equal_clocks(control)) {
    const std::int64_t clocks = count_clocks(path_, blu, control);
    even_ = Even{dropper_of(control), length_ / static_cast<double>(clocks)};
  }
  for (std::size_t i = 0; i < gap_.size(); ++i) gap_[i] = staircase_.from()[i] - from[i];
  find_ahead();
}

PulseWalk::Places PulseWalk::places(const AxisVector& blu) const {
  if (staircase_.arc_length()) return OnCurve{};
  if (const Arc* arc = std::get_if<Arc>(&path_)) return places_on(*arc, blu);
  const int lead = longest_axis(staircase_.from(), staircase_.to());
  const auto i = static_cast<std::size_t>(lead);
  return OnLine{lead,
                length_ / static_cast<double>(std::abs(staircase_.to()[i] - staircase_.from()[i]))};
}

PulseWalk::Places PulseWalk::places_on(const Arc& arc, const AxisVector& blu) const {
  const PlaneAxes axes = plane_axes(arc.plane());
  const auto arm = [&](int axis) {
    return static_cast<double>(staircase_.from()[static_cast<std::size_t>(axis)]) -
           arc.center()[axis] / blu[axis];
  };
  const AxisVector out = arc.from() - arc.center();
  return Circle{axes,
                {arm(axes.first), arm(axes.second)},
                arc.radius() / blu[axes.first],
                arc.ccw() ? 1.0 : -1.0,
                std::atan2(out[axes.second], out[axes.first]),
                arc.length() / std::abs(arc.sweep())};
}

double PulseWalk::OnLine::place(Step step) noexcept {
  if (step[lead] == 0) return s;
  s += part;
  return s - 0.5 * part;
}

double PulseWalk::Even::place(Step step) noexcept {
  const double here = s + 0.5 * part;
  s += part * dropper.clocks(step);
  return here;
}

/// The leading axis is the one that is nearer to the centre: the position is that of the circle at
/// its coordinate, not that of the staircase. Towards 45 degrees, where the other axis takes over,
/// it becomes the position of the circle next to the staircase, so that no position is skipped.
double PulseWalk::Circle::place(Step step) noexcept {
  const double along = step[axes.first], across = step[axes.second];
  const double x = arm[0] + 0.5 * along, y = arm[1] + 0.5 * across;
  arm = {arm[0] + along, arm[1] + across};
  const bool first_leads = std::abs(x) < std::abs(y);
  const double lead = first_leads ? x : y, late = first_leads ? y : x;
  const double other = std::copysign(std::sqrt(std::max(radius * radius - lead * lead, 0.0)), late);
  const double slope = late == 0 ? 0 : lead / late;
  const double mixed = other + slope * slope * (late - other);
  const double here = first_leads ? std::atan2(mixed, x) : std::atan2(y, mixed);
  const double turned = std::remainder(direction * (here - angle), 2 * std::numbers::pi);
  angle = here;
  s += turned * mm_per_rad;
  return s;
}

double PulseWalk::place(Step step) noexcept {
  if (auto* line = std::get_if<OnLine>(&places_)) return line->place(step);
  if (auto* circle = std::get_if<Circle>(&places_)) return circle->place(step);
  auto& curve = std::get<OnCurve>(places_);
  const double before = std::exchange(curve.s, *staircase_.arc_length());
  return 0.5 * (before + curve.s);
}

/// A curve reports only where its last move is.
bool PulseWalk::read() noexcept {
  const bool one = std::holds_alternative<OnCurve>(places_);
  next_ = 0;
  read_ = staircase_.fill(std::span(steps_).first(one ? 1 : steps_.size()));
  return read_ > 0;
}

/// Rounding may have put the end of the previous move onto another grid point.
bool PulseWalk::close_gap() noexcept {
  Step step;
  for (std::size_t i = 0; i < gap_.size(); ++i) {
    const std::int64_t direction = (gap_[i] > 0) - (gap_[i] < 0);
    gap_[i] -= direction;
    step = step | Step(static_cast<int>(i), direction);
  }
  ahead_.step = step;
  return step.is_pulse();
}

void PulseWalk::find_ahead() noexcept {
  if (close_gap()) return;
  while (next_ < read_ || read()) {
    ahead_.step = steps_[next_++];
    ahead_.s = std::clamp(place(ahead_.step), ahead_.s, length_);
    ahead_.due = even_ ? std::clamp(even_->place(ahead_.step), ahead_.due, length_) : ahead_.s;
    if (ahead_.step.is_pulse()) return;
  }
  has_ahead_ = false;
}

void PulseWalk::pass() noexcept {
  advance(at_, ahead_.step);
  s_ = ahead_.s;
  find_ahead();
}

AxisVector PulseWalk::position() const noexcept {
  AxisVector position;
  for (int i = 0; i < kAxes; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    position[i] = counts_[axis].position(at_[axis]);
  }
  return position;
}

}  // namespace softcnc::ipo
