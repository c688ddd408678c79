// SPDX-License-Identifier: MIT
#include "ipo/limits/constraint_list.hpp"

#include <algorithm>

namespace softcnc::ipo {
namespace {

/// The least of what the constraints of a list allow.
template <typename List, typename Allowed>
double least_of(const List& list, Allowed allowed) noexcept {
  double least = kUnlimited;
  for (const auto& constraint : list) least = std::min(least, allowed(*constraint));
  return least;
}

/// A constraint that someone else keeps.
class Borrowed final : public Constraint {
 public:
  explicit Borrowed(const Constraint& constraint) : constraint_(constraint) {}
  Limit limit(const Move& move) const noexcept override { return constraint_.limit(move); }
  double velocity_limit(const PathPoint& point, const Move& move) const noexcept override {
    return constraint_.velocity_limit(point, move);
  }
  bool is_even(const PathPoint& a, const PathPoint& b, const Move& move) const noexcept override {
    return constraint_.is_even(a, b, move);
  }

 private:
  const Constraint& constraint_;
};

}  // namespace

/// The list: whoever adds a reason to be slow adds a line. A constraint that the machine does not
/// have is null. Corners are the one reason that no point of the path shows:
/// path/corner_limits.cpp.
ConstraintList::ConstraintList(const Machine& machine, const Overrides& overrides,
                               const FurtherConstraints& further)
    : limits_(limits_of(machine)), contour_(contour_limit(machine)) {
  const auto add = [](List& list, std::unique_ptr<Constraint> constraint) {
    if (constraint) list.push_back(std::move(constraint));
  };
  add(velocities_, make_feed_limit(machine, overrides));
  add(velocities_, make_axis_velocity(machine));
  add(velocities_, make_pulse_rate(machine));
  add(velocities_, make_chord_error(machine));
  add(velocities_, make_contour_error(contour_));
  add(velocities_, make_roughness_limit(machine));
  add(velocities_, make_normal_acceleration(machine));
  for (const Constraint* constraint : further)
    add(velocities_, std::make_unique<Borrowed>(*constraint));
  add(accelerations_, make_tangential_acceleration(limits_));
  add(accelerations_, make_axis_acceleration(limits_));
  add(jerks_, make_axis_jerk(limits_));
  sort_limits();
  centripetal_.setConstant(kUnlimited);
  for (const List* list : {&accelerations_, &velocities_})
    for (const auto& constraint : *list)
      centripetal_ = centripetal_.cwiseMin(constraint->centripetal_limits());
}

void ConstraintList::set_overrides(const Machine& machine, const Overrides& overrides) {
  velocities_.front() = make_feed_limit(machine, overrides);
  sort_limits();
}

void ConstraintList::sort_limits() {
  for (auto* list : {&step_limits_, &point_limits_, &strict_limits_}) list->clear();
  for (const auto& constraint : velocities_) {
    (constraint->holds_over_steps() ? step_limits_ : point_limits_).push_back(constraint.get());
    if (constraint->is_strict()) strict_limits_.push_back(constraint.get());
  }
}

Inequalities ConstraintList::accelerations(const PathPoint& point) const noexcept {
  Inequalities all;
  for (const auto& constraint : accelerations_)
    constraint->add_acceleration_inequalities(point, all);
  return all;
}

Inequalities ConstraintList::jerks(const PathPoint& point) const noexcept {
  Inequalities all;
  for (const auto& constraint : jerks_) constraint->add_jerk_inequalities(point, all);
  return all;
}

double ConstraintList::largest_q(const PathPoint& point) const noexcept {
  return least_of(accelerations_, [&](const Constraint& one) { return one.largest_q(point); });
}

double ConstraintList::largest_u(const PathPoint& point) const noexcept {
  return least_of(accelerations_, [&](const Constraint& one) { return one.largest_u(point); });
}

double ConstraintList::straight_u(const AxisVector& direction) const noexcept {
  return least_of(accelerations_, [&](const Constraint& one) { return one.straight_u(direction); });
}

double ConstraintList::least_u(const Directions& directions) const noexcept {
  return least_of(accelerations_, [&](const Constraint& one) { return one.least_u(directions); });
}

double ConstraintList::most_u(const Directions& directions) const noexcept {
  return least_of(accelerations_, [&](const Constraint& one) { return one.most_u(directions); });
}

Limit ConstraintList::binding_acceleration(const Passing& place, double u,
                                           double share) const noexcept {
  for (const auto& constraint : accelerations_)
    if (const auto limit = constraint->binding(place, u, share)) return *limit;
  return Limit::acceleration;
}

}  // namespace softcnc::ipo
