// SPDX-License-Identifier: MIT
#include "ipo/limits/contour_limit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ipo/limits/planner_limits.hpp"
#include "ipo/tuning.hpp"
#include "motion/model/fastest_move.hpp"
#include "motion/model/position_loop.hpp"
#include "motion/model/servo_figures.hpp"

namespace softcnc::ipo {
namespace {

/// Returns the part of its radius by which an axis makes a circle of angular speed w smaller or
/// larger.
double circle_error(const Axis& axis, double loop_period, double lead, double w) {
  return std::abs(1 - position_gain(axis, loop_period, w) * std::hypot(1, w * lead));
}

double lead_of(const Axis& axis, const Control& control) {
  return control.follow == Follow::lead ? lead_time(axis, loop_period(control)) : 0;
}

}  // namespace

ContourLimit::ContourLimit(const Machine& machine)
    : tolerance_(machine.control.contour_tolerance),
      kv_(kUnlimited),
      late_(AxisVector::Zero()),
      leftover_(0),
      fastest_(fastest_move(machine)) {
  const double period = loop_period(machine.control);
  for (std::size_t i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[i];
    if (!axis.present) continue;
    const double kv = axis.drive.kv;
    const double lead = lead_of(axis, machine.control);
    late_[static_cast<Eigen::Index>(i)] = 1 / kv - lead;
    const double slow_pole = kv * (1 + kv * velocity_lag(axis));
    leftover_ = std::max({leftover_, std::abs(1 - lead * kv), std::abs(1 - lead * slow_pole)});
    circles_[i] = circles_of(axis, period, lead);
    kv_ = std::min(kv_, kv);
  }
}

ContourLimit::Circles ContourLimit::circles_of(const Axis& axis, double loop_period, double lead) {
  Circles circles;
  double most = 0;
  for (int k = 0; k <= tuning::contour::kCircles && most <= tuning::contour::kLargest; ++k) {
    const double part = static_cast<double>(k) / tuning::contour::kCircles;
    const double w = axis.drive.kv * std::pow(10, tuning::contour::kDecades * (part - 1));
    most = std::max(most, circle_error(axis, loop_period, lead, w));
    circles.push_back({w, most});
  }
  return circles;
}

/// Returns the angular speed, rad/s, up to which circles err by no more than this part of their
/// radius. Errors of slow circles go with its square; those of a bend so short that the table goes
/// through it within its lag do so as well.
double ContourLimit::angular_speed(const Circles& circles, double error) noexcept {
  const auto beyond = std::upper_bound(circles.begin(), circles.end(), error,
                                       [](double e, const Circle& c) { return e < c.error; });
  if (beyond == circles.end()) return circles.back().w * std::sqrt(error / circles.back().error);
  if (beyond == circles.begin()) return beyond->w * std::sqrt(error / beyond->error);
  const Circle &low = beyond[-1], &high = *beyond;
  const double part = (error - low.error) / (high.error - low.error);
  return std::sqrt(low.w * low.w + part * (high.w * high.w - low.w * low.w));
}

/// Of the axes that move.
double ContourLimit::angular_speed(const PathPoint& point, double error) const noexcept {
  double w = kUnlimited;
  for (int i = 0; i < kAxes; ++i) {
    const Circles& circles = circles_[static_cast<std::size_t>(i)];
    if (!circles.empty() && (point.dq[i] != 0 || point.ddq[i] != 0))
      w = std::min(w, angular_speed(circles, error));
  }
  return w;
}

/// Returns the time, s, by which axes with unequal gains leave a straight path: across it.
double ContourLimit::uneven(const AxisVector& direction) const noexcept {
  const AxisVector late = late_.cwiseProduct(direction);
  return (late - late.dot(direction) * direction).norm();
}

double ContourLimit::velocity(const PathPoint& point) const noexcept {
  const double across = uneven(point.dq), straight = tolerance_ / across;
  const double kappa = std::min(point.ddq.norm(), tuning::contour::kSharpest / tolerance_);
  if (!(kappa > 0)) return across > 0 ? straight : kUnlimited;
  const double curved = angular_speed(point, kappa * tolerance_) / kappa;
  if (!(across > 0)) return curved;
  const double b = curved / straight;  // v / straight + (v / curved)^2 <= 1
  return 2 * curved / (b + std::sqrt(b * b + 4));
}

double ContourLimit::corner_velocity(double turn, double length) const noexcept {
  PathPoint chain{};
  chain.ddq.fill(turn / length / std::sqrt(double(kAxes)));
  return std::min(std::numbers::e * kv_ * tolerance_ / (leftover_ * turn), velocity(chain));
}

double ContourLimit::settling_time(const Rest& rest) const noexcept {
  const double time = 2 * std::sqrt(rest.length / rest.acceleration);
  const double most =
      std::min(rest.acceleration / (kv_ * kv_), rest.length / -std::expm1(-kv_ * time));
  const double lag = leftover_ * most * std::min(2 * rest.turn, 1.0);
  const double settled = tuning::contour::kSettled * tolerance_;
  return lag > settled ? std::log(lag / settled) / kv_ : 0;
}

double ContourLimit::approach_velocity(double speed, double distance) const noexcept {
  const double beyond = distance - near_distance(speed);
  if (beyond > 0) return tuning::contour::kNear * speed + braking_rate() * beyond;
  const double steady = tuning::contour::kSteady * speed / kv_;
  return speed + tuning::contour::kNearRate * kv_ * std::max(distance - steady, 0.0);
}

double ContourLimit::near_distance(double speed) const noexcept {
  const double rise = (tuning::contour::kNear - 1) / tuning::contour::kNearRate;
  return (tuning::contour::kSteady + rise) * speed / kv_;
}

double ContourLimit::braking_rate() const noexcept { return tuning::contour::kFarRate * kv_; }

/// Where the slope changes.
double ContourLimit::least_approach() const noexcept {
  return tuning::contour::kNear / near_distance(1);
}

double ContourLimit::late_distance(double speed) const noexcept {
  return tuning::contour::kLate * speed / kv_;
}

std::optional<ContourLimit> contour_limit(const Machine& machine) {
  if (!limits_contour(machine.control)) return std::nullopt;
  return ContourLimit(machine);
}

}  // namespace softcnc::ipo
