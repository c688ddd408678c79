// SPDX-License-Identifier: MIT
// The list of all constraints of a machine.
#pragma once

#include <memory>
#include <vector>

#include "ipo/limits/constraint.hpp"
#include "ipo/limits/contour_limit.hpp"
#include "ipo/limits/overrides.hpp"

namespace softcnc::ipo {

/// Velocity limits beyond those of the machine; they must outlive what uses them.
using FurtherConstraints = std::vector<const Constraint*>;

class ConstraintList {
 public:
  /// The overrides multiply the programmed feed (1: as programmed) and rapids, never a machine
  /// limit.
  ConstraintList(const Machine& machine, const Overrides& overrides,
                 const FurtherConstraints& further = {});

  /// Takes effect for everything that is evaluated from now on.
  void set_overrides(const Machine& machine, const Overrides& overrides);

  const PlannerLimits& limits() const noexcept { return limits_; }
  bool limits_jerk() const noexcept { return !jerks_.empty(); }

  /// What the contour tolerance asks for beyond velocity limits at points; null if there is none.
  const ContourLimit* contour() const noexcept { return contour_ ? &*contour_ : nullptr; }

  /// The constraints that act as velocity limits; the first is that of the feed.
  const std::vector<std::unique_ptr<Constraint>>& velocity_limits() const noexcept {
    return velocities_;
  }
  /// Those of them that hold over steps, those that hold at points only, and those that are strict.
  const std::vector<const Constraint*>& step_limits() const noexcept { return step_limits_; }
  const std::vector<const Constraint*>& point_limits() const noexcept { return point_limits_; }
  const std::vector<const Constraint*>& strict_limits() const noexcept { return strict_limits_; }

  /// The largest acceleration x'' q that each axis may have in a curve, mm/s^2.
  const AxisVector& centripetal_limits() const noexcept { return centripetal_; }

  /// The inequalities of acceleration and of jerk at a point.
  Inequalities accelerations(const PathPoint& point) const noexcept;
  Inequalities jerks(const PathPoint& point) const noexcept;

  // What the inequalities of acceleration imply: see Constraint. ----------------------------------

  double largest_q(const PathPoint& point) const noexcept;
  double largest_u(const PathPoint& point) const noexcept;
  double straight_u(const AxisVector& direction) const noexcept;
  double least_u(const Directions& directions) const noexcept;
  double most_u(const Directions& directions) const noexcept;
  /// Returns the name of the acceleration limit that binds at a place, where the path acceleration
  /// is u and `share` of the limits may be used.
  Limit binding_acceleration(const Passing& place, double u, double share) const noexcept;

 private:
  using List = std::vector<std::unique_ptr<Constraint>>;

  void sort_limits();

  PlannerLimits limits_;
  std::optional<ContourLimit> contour_;
  List velocities_, accelerations_, jerks_;
  std::vector<const Constraint*> step_limits_, point_limits_, strict_limits_;
  AxisVector centripetal_;
};

std::unique_ptr<Constraint> make_feed_limit(const Machine& machine, const Overrides& overrides);

/// Returns the speed of a rapid, mm/s, at which an axis has its velocity limit where it begins.
double fastest_rapid(const Move& move, const Machine& machine) noexcept;
std::unique_ptr<Constraint> make_axis_velocity(const Machine& machine);
std::unique_ptr<Constraint> make_chord_error(const Machine& machine);
std::unique_ptr<Constraint> make_contour_error(const std::optional<ContourLimit>& limit);
std::unique_ptr<Constraint> make_roughness_limit(const Machine& machine);
std::unique_ptr<Constraint> make_normal_acceleration(const Machine& machine);
std::unique_ptr<Constraint> make_pulse_rate(const Machine& machine);
std::unique_ptr<Constraint> make_tangential_acceleration(const PlannerLimits& limits);
std::unique_ptr<Constraint> make_axis_acceleration(const PlannerLimits& limits);
std::unique_ptr<Constraint> make_axis_jerk(const PlannerLimits& limits);

}  // namespace softcnc::ipo
