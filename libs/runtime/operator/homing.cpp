// SPDX-License-Identifier: MIT
#include "runtime/operator/homing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hal/files/number.hpp"
#include "runtime/operator/settling_time.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kNothing = 1e-6;  // mm: of a range that is used up

double latch_speed(const Machine& machine, const Axis& axis) noexcept {
  return axis.home.latch > 0 ? axis.home.latch : axis.blu / machine.control.period;
}

std::string mm(double length) { return hal::number_text(std::round(length * 1e3) / 1e3) + " mm"; }

}  // namespace

Homing::Homing(const Machine& machine, double delay) : machine_(machine), delay_(delay) {}

bool Homing::is_possible(const Machine& machine) noexcept {
  return std::any_of(machine.axes.begin(), machine.axes.end(), has_home_switch);
}

AxisVector Homing::rest_place() const noexcept {
  AxisVector place = found_place();
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine_.axes[static_cast<std::size_t>(i)];
    if (has_home_switch(axis)) place[i] = axis.home.rest();
  }
  return place;
}

bool Homing::finds_all() const noexcept {
  return std::all_of(machine_.axes.begin(), machine_.axes.end(),
                     [](const Axis& axis) { return !axis.present || has_home_switch(axis); });
}

// From leg to leg ---------------------------------------------------------------------------------

std::optional<Homing::Leg> Homing::next(const AxisVector& place) {
  if (delay_ > 0 && !std::exchange(waited_, true)) return Leg{place, 0, delay_};
  count_range(place);
  place_ = place;
  while (!failure_) {
    if (group_.empty()) begin_group();
    if (group_.empty() || failure_) break;
    const bool seeks = phase_ == Phase::search || phase_ == Phase::latch;
    if (seeks && !all_found()) {
      check_range();
      if (!failure_) return towards_switches(place);
    } else if (seeks) {
      check_closed();
      if (phase_ == Phase::latch) check_edges();
      phase_ = phase_ == Phase::search ? Phase::back_off : Phase::leave;
      if (!failure_) return off_switches(place);
    } else {
      check_open();
      phase_ == Phase::back_off ? begin_latch() : take_edges();
    }
  }
  return std::nullopt;
}

void Homing::begin_group() {
  int order = std::numeric_limits<int>::max();
  for (const Axis& axis : machine_.axes)
    if (has_home_switch(axis) && axis.home.order > order_) order = std::min(order, axis.home.order);
  order_ = order;
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine_.axes[static_cast<std::size_t>(i)];
    if (has_home_switch(axis) && axis.home.order == order)
      group_.push_back({i, &axis, axis.home.direction()});
  }
  begin_search();
}

void Homing::begin_search() {
  phase_ = Phase::search;
  for (Seeker& seeker : group_) {
    seeker.speed = std::abs(seeker.of->home.search);
    seeker.range = seeker.of->max - seeker.of->min + 2 * seeker.of->home.back_off;
    if (closed_[static_cast<std::size_t>(seeker.axis)])
      fail(seeker.axis, "is closed already where the search begins");
  }
}

void Homing::begin_latch() {
  phase_ = Phase::latch;
  for (Seeker& seeker : group_) {
    seeker.first_edge = seeker.edge;
    seeker.found = false;
    seeker.speed = latch_speed(machine_, *seeker.of);
    seeker.range = 2 * seeker.of->home.back_off;
  }
}

/// Takes off what the leg has moved towards the switches.
void Homing::count_range(const AxisVector& place) {
  for (Seeker& seeker : group_)
    seeker.range -= (place[seeker.axis] - place_[seeker.axis]) * seeker.direction;
}

bool Homing::all_found() const noexcept {
  return std::all_of(group_.begin(), group_.end(), [](const Seeker& s) { return s.found; });
}

/// How long it takes until the tables of the group rest, and their switches have been read, s.
double Homing::pause() const noexcept {
  double time = 0;
  for (const Seeker& seeker : group_) time = std::max(time, settling_time(*seeker.of));
  return delay_ + time;
}

/// All that have not been found move at once, each at its own speed, until one of them can go no
/// further.
Homing::Leg Homing::towards_switches(const AxisVector& place) {
  double time = std::numeric_limits<double>::infinity();
  for (const Seeker& seeker : group_)
    if (!seeker.found) time = std::min(time, seeker.range / seeker.speed);
  Leg leg{place, 0, pause()};
  for (const Seeker& seeker : group_)
    if (!seeker.found) leg.to[seeker.axis] += seeker.direction * seeker.speed * time;
  leg.feed = (leg.to - place).norm() / time;
  return leg;
}

/// Rests there until the tables have come to rest, too.
Homing::Leg Homing::off_switches(const AxisVector& place) {
  Leg leg{place, 0, pause()};
  double time = 0;
  for (const Seeker& seeker : group_) {
    leg.to[seeker.axis] = seeker.edge - seeker.direction * seeker.of->home.back_off;
    time = std::max(time, std::abs(leg.to[seeker.axis] - place[seeker.axis]) /
                              std::abs(seeker.of->home.search));
  }
  leg.feed = (leg.to - place).norm() / time;
  return leg;
}

void Homing::take_edges() {
  for (const Seeker& seeker : group_)
    offset_[seeker.axis] =
        seeker.of->home.place - seeker.edge + table_[seeker.axis] - place_[seeker.axis];
  group_.clear();
}

// What rows say -----------------------------------------------------------------------------------

bool Homing::sees(const Feedback& feedback) {
  closed_ = feedback.home;
  table_ = feedback.position;
  if (static_cast<double>(++rows_) * machine_.control.period < delay_) return false;
  if (!std::exchange(begun_, true)) {
    for (int i = 0; i < kAxes; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      if (has_home_switch(machine_.axes[axis]) && closed_[axis])
        fail(i, "is closed already where homing begins");
    }
    return failure_.has_value();
  }
  if (phase_ != Phase::search && phase_ != Phase::latch) return false;
  bool finds = false;
  for (Seeker& seeker : group_) {
    if (seeker.found || !closed_[static_cast<std::size_t>(seeker.axis)]) continue;
    seeker.found = finds = true;
    seeker.edge = feedback.switched[seeker.axis];
  }
  return finds;
}

// What is wrong -----------------------------------------------------------------------------------

void Homing::check_range() {
  for (const Seeker& seeker : group_)
    if (!seeker.found && seeker.range < kNothing)
      fail(seeker.axis, phase_ == Phase::search
                            ? "has not closed over the whole travel"
                            : "has not closed again within " + mm(2 * seeker.of->home.back_off));
}

void Homing::check_closed() {
  for (const Seeker& seeker : group_)
    if (!closed_[static_cast<std::size_t>(seeker.axis)])
      fail(seeker.axis, "has opened again where the axis came to rest beyond it");
}

void Homing::check_edges() {
  for (const Seeker& seeker : group_) {
    const double apart = std::abs(seeker.edge - seeker.first_edge);
    const double fineness = std::abs(seeker.of->home.search) * machine_.control.period;
    if (apart > seeker.of->home.back_off / 2 + fineness)
      fail(seeker.axis, "has closed at two places, " + mm(apart) + " apart");
  }
}

void Homing::check_open() {
  for (const Seeker& seeker : group_)
    if (closed_[static_cast<std::size_t>(seeker.axis)])
      fail(seeker.axis,
           "is still closed " + mm(seeker.of->home.back_off) + " away from where it closed");
}

void Homing::fail(int axis, const std::string& what) {
  if (failure_) return;
  failure_ = Diagnostic{.code = Code::SC5090,
                        .message = std::string("the home switch of ") +
                                   kAxisLetters[static_cast<std::size_t>(axis)] + ' ' + what};
}

}  // namespace softcnc::runtime
