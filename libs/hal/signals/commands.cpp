// SPDX-License-Identifier: MIT
#include "hal/signals/commands.hpp"

#include <algorithm>
#include <cmath>

#include "hal/files/axis_name.hpp"

namespace softcnc::hal {
namespace {

/// The most fine points of a period that are reserved: those of the simulated axes.
constexpr std::size_t kReserved = 64;

}  // namespace

Commands::Commands(const Machine& machine)
    : parts_(
          static_cast<std::size_t>(parts_of_period(machine.control, fine_period(machine.control)))),
      period_(machine.control.period) {
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const bool differs = has_errors(machine.screws[i]) || machine.control.follow != Follow::off;
    if (machine.axes[i].present && differs)
      axes_.push_back(
          {axis, AxisCompensation(machine.axes[i], machine.screws[i]),
           AxisFollowing(machine.axes[i], machine.control.follow, loop_period(machine.control))});
  }
  fine_after_rest_.reserve(std::max(kReserved, parts_));
  if (differ()) fine_.reserve(std::max(kReserved, 4 * parts_));
}

const Setpoint& Commands::operator()(const Setpoint& path) noexcept {
  return send(rested_ && path.before_rest > 0 ? after_rest(path) : path);
}

const Setpoint& Commands::rest(const Setpoint& at) noexcept {
  const Setpoint& sent = send(at);
  rested_ = FinePoint{at.s, at.position};
  return sent;
}

const Setpoint& Commands::after_rest(const Setpoint& path) noexcept {
  fine_after_rest_.assign(path.fine.begin(), path.fine.end());
  const std::size_t before = std::min(path.before_rest, fine_after_rest_.size());
  std::fill_n(fine_after_rest_.begin(), before, *rested_);
  after_rest_ = path;
  after_rest_.fine = fine_after_rest_;
  return after_rest_;
}

const Setpoint& Commands::send(const Setpoint& path) noexcept {
  rested_.reset();
  if (!differ()) return path;
  sent_ = path;
  if (started_) {
    fine_.clear();
    const std::size_t parts = path.fine.empty() ? parts_ : path.fine.size();
    for_instants(path, path_, static_cast<int>(parts),
                 [this](const FinePoint& point) { fine_.push_back(point); });
    move();
  } else {
    begin();
  }
  started_ = true;
  path_ = {path.s, path.position};
  added_ = sent_.position - path_.position;
  return sent_;
}

void Commands::begin() noexcept {
  for (Chain& axis : axes_) {
    double& position = sent_.position[axis.axis];
    position = axis.compensation.begin(position);
    axis.following.begin(position);
  }
}

void Commands::move() noexcept {
  const double time = period_ / static_cast<double>(fine_.size());
  AxisVector before = path_.position + added_;
  for (FinePoint& point : fine_) {
    for (Chain& axis : axes_) {
      double& position = point.position[axis.axis];
      position = axis.following.move(axis.compensation.move(position, time), time);
      double& largest = velocity_max_[axis.axis];
      largest = std::max(largest, std::abs(position - before[axis.axis]) / time);
    }
    before = point.position;
  }
  sent_.position = fine_.back().position;
  sent_.fine = fine_;
}

const Setpoint* Commands::next_to_release() noexcept {
  if (!started_) return nullptr;
  bool complete = true;
  for (Chain& axis : axes_) {
    axis.compensation.release();
    complete = complete && axis.compensation.is_complete();
  }
  if (complete) return nullptr;
  Setpoint rest = sent_;
  rest.position = path_.position;
  rest.fine = {};
  (*this)(rest);
  return &sent_;
}

void Commands::add_column(int axis, std::vector<std::string>& columns) const {
  if (differ()) columns.push_back(axis_name(axis) + "_cmd_mm");
}

}  // namespace softcnc::hal
