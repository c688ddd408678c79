// SPDX-License-Identifier: MIT
// The list of constraints. Whoever adds a reason to be slow adds a row.
#include "ipo/limits/constraint.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

namespace {

/// Sum over the axes that take part of |x| A.
double all_axes(const AxisVector& x, const AxisVector& acceleration) noexcept {
  double sum = 0;
  for (int i = 0; i < kAxes; ++i)
    if (x[i] != 0) sum += std::abs(x[i]) * acceleration[i];
  return sum;
}

}  // namespace

Constraints::Constraints(const Machine& machine, double feed_override)
    : period_(machine.control.period),
      fine_period_(softcnc::fine_period(machine.control)),
      chord_tolerance_(machine.control.chord_tolerance) {
  velocity_limits_.push_back(make_feed_limit(machine, feed_override));
  velocity_limits_.push_back(make_axis_velocity(machine));
  // The three-point method of paper 000 limits the chord error itself, at run time; pulses follow
  // the path between the rows.
  const Method method = machine.control.interpolation;
  if (is_by_pulses(method))
    velocity_limits_.push_back(make_pulse_rate(machine));
  else if (method != Method::curvature3p)
    velocity_limits_.push_back(make_chord_error(machine));
  velocity_limits_.push_back(make_roughness_limit(machine));
  if (machine.limits.normal > 0) velocity_limits_.push_back(make_normal_acceleration(machine));
  if (machine.limits.tangential > 0) tangential_ = machine.limits.tangential;
  sort_limits();
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    acceleration_[i] = axis.present ? axis.acceleration : kUnlimited;
    jerk_[i] = axis.present && axis.jerk > 0 ? axis.jerk : kUnlimited;
  }
  const bool by_paper =  // which knows acceleration alone
      is_by_pulses(method) && machine.control.pulse_clock == PulseClock::paper;
  centripetal_ =
      machine.limits.normal > 0 ? acceleration_.cwiseMin(machine.limits.normal) : acceleration_;
  jerk_ = jerk_.cwiseMin(2 * acceleration_ / fine_period_);
  if (by_paper || !ipo::limits_jerk(machine)) jerk_.setConstant(kUnlimited);
}

bool limits_jerk(const Machine& machine) noexcept {
  const double period = fine_period(machine.control);
  return std::any_of(machine.axes.begin(), machine.axes.end(), [&](const Axis& axis) {
    return axis.present && axis.jerk > 0 && axis.jerk * period < 2 * axis.acceleration;
  });
}

void Constraints::set_feed_override(const Machine& machine, double feed_override) {
  velocity_limits_.front() = make_feed_limit(machine, feed_override);
  sort_limits();
}

void Constraints::sort_limits() {
  for (auto* list : {&step_limits_, &point_limits_, &strict_limits_}) list->clear();
  for (const auto& constraint : velocity_limits_) {
    (constraint->holds_over_steps() ? step_limits_ : point_limits_).push_back(constraint.get());
    if (constraint->holds_everywhere()) strict_limits_.push_back(constraint.get());
  }
}

double Constraints::centripetal_q(const PathPoint& point) const noexcept {
  const double square = point.ddq.squaredNorm();
  return square > 0 ? all_axes(point.ddq, acceleration_) / square : kUnlimited;
}

double Constraints::tangential_u(const PathPoint& point) const noexcept {
  return std::min(all_axes(point.dq, acceleration_), tangential_);
}

Limit Constraints::binding_acceleration(double u, double share) const noexcept {
  constexpr double kBinds = 0.99;
  return std::abs(u) >= kBinds * share * tangential_ ? Limit::tangential : Limit::acceleration;
}

}  // namespace softcnc::ipo
