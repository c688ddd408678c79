// SPDX-License-Identifier: MIT
// What holds the feed back: every reason is a Constraint, and this is their list.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "ipo/limits/directions.hpp"
#include "motion/model/block.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

inline constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// The largest path derivative that keeps every axis: min over the axes of limit / |x'|.
inline double along(const AxisVector& limits, const AxisVector& direction) noexcept {
  double most = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (direction[i] != 0) most = std::min(most, limits[i] / std::abs(direction[i]));
  return most;
}

/// A point of a path, and the q = v^2 that is planned there.
struct Passing {
  const PathPoint& point;
  double q;
};

/// One reason to be slow, asked once per node of the grid and one-sided where derivatives jump.
class Constraint {
 public:
  Constraint() = default;
  Constraint(const Constraint&) = delete;
  Constraint& operator=(const Constraint&) = delete;
  virtual ~Constraint() = default;

  /// Its name in the trace.
  virtual Limit limit(const Move& move) const noexcept = 0;

  /// Upper bound on q = v^2 at this point, mm^2/s^2.
  virtual double velocity_limit(const PathPoint&, const Move&) const noexcept { return kUnlimited; }

  /// True if the cap holds for every period's step that touches the point: the step, not only the
  /// point, then keeps it.
  virtual bool holds_over_steps() const noexcept { return false; }

  /// True if the cap holds between the nodes of the grid too, not but for what the grid tolerates.
  virtual bool holds_everywhere() const noexcept { return false; }

  /// False if more may happen to the cap between two points of a move than their middle tells.
  virtual bool is_even(const PathPoint&, const PathPoint&, const Move&) const noexcept {
    return true;
  }

  /// False if a q on the line between two points exceeds the cap between them, where x' is longer
  /// than on the line between theirs by up to `sag` on each axis, by more than `tolerance` of it.
  virtual bool holds_between(const Passing&, const Passing&, const AxisVector& /*sag*/,
                             double /*tolerance*/) const noexcept {
    return true;
  }
};

/// The caps of one machine; accelerations and jerks, the constraints with rows, stand beside them.
class Constraints {
 public:
  /// `feed_override` multiplies the programmed feed (1: as programmed), never a machine limit.
  Constraints(const Machine& machine, double feed_override);

  /// Counts for what is asked from now on.
  void set_feed_override(const Machine& machine, double feed_override);
  /// The one of `caps` that the feed override multiplies.
  const Constraint& feed() const noexcept { return *velocity_limits_.front(); }

  const std::vector<std::unique_ptr<Constraint>>& velocity_limits() const noexcept {
    return velocity_limits_;
  }

  /// Those that hold over steps, and those that hold at points alone.
  const std::vector<const Constraint*>& step_limits() const noexcept { return step_limits_; }
  const std::vector<const Constraint*>& point_limits() const noexcept { return point_limits_; }

  /// Those that hold everywhere.
  const std::vector<const Constraint*>& strict_limits() const noexcept { return strict_limits_; }

  /// No q is larger than what all axes together can turn: n . x'' q <= sum |n| A.
  double centripetal_q(const PathPoint& point) const noexcept;
  /// No u is larger than what all axes together can push: u = x' . a <= sum |x'| A.
  double tangential_u(const PathPoint& point) const noexcept;
  /// The largest |u| along a straight line.
  double straight_u(const AxisVector& direction) const noexcept {
    return std::min(along(acceleration_, direction), tangential_);
  }
  /// What |u| may be along a line, whichever of these directions it takes.
  double least_u(const Directions& directions) const noexcept {
    return std::min(directions.least(acceleration_), tangential_);
  }
  /// No |u| is larger on a way of these directions.
  double most_u(const Directions& directions) const noexcept {
    return std::min(directions.most(acceleration_), tangential_);
  }

  const AxisVector& acceleration_limits() const noexcept { return acceleration_; }
  /// Of the speed along the path, mm/s^2.
  double tangential_limit() const noexcept { return tangential_; }
  /// What x'' q may be on an axis, mm/s^2.
  const AxisVector& centripetal_limits() const noexcept { return centripetal_; }
  /// What to call an acceleration limit that binds, where the path acceleration is u and `share` of
  /// the limits may be used.
  Limit binding_acceleration(double u, double share) const noexcept;
  /// mm/s^3; all unlimited, or none above what its axis needs at most.
  const AxisVector& jerk_limits() const noexcept { return jerk_; }
  bool limits_jerk() const noexcept { return jerk_.minCoeff() < kUnlimited; }
  /// s: from row to row, and from one fine point to the next. What the rows see of a joint is
  /// judged by the latter, chords by the former.
  double period() const noexcept { return period_; }
  double fine_period() const noexcept { return fine_period_; }
  double chord_tolerance() const noexcept { return chord_tolerance_; }

 private:
  void sort_limits();

  std::vector<std::unique_ptr<Constraint>> velocity_limits_;
  std::vector<const Constraint*> step_limits_, point_limits_, strict_limits_;
  AxisVector acceleration_, jerk_, centripetal_;
  double tangential_ = kUnlimited;
  double period_, fine_period_, chord_tolerance_;
};

/// Whether any axis has a limit of its jerk that its acceleration does not keep anyway: one that
/// changes from limit to limit within a fine period T shows as a jerk of 2 A / T.
bool limits_jerk(const Machine& machine) noexcept;

std::unique_ptr<Constraint> make_feed_limit(const Machine& machine, double feed_override);
std::unique_ptr<Constraint> make_axis_velocity(const Machine& machine);
std::unique_ptr<Constraint> make_chord_error(const Machine& machine);
std::unique_ptr<Constraint> make_roughness_limit(const Machine& machine);
std::unique_ptr<Constraint> make_normal_acceleration(const Machine& machine);
std::unique_ptr<Constraint> make_pulse_rate(const Machine& machine);

/// The longest step, in mm, whose chord stays within `tolerance` mm of an arc of curvature `kappa`
/// (1/mm): 2 sqrt(2 rho eps - eps^2), paper 000 eq. (5) in its exact circle form; where rho <= eps
/// it is 2 eps, since a path of length L is never further than L/2 from its chord.
double chord_step(double kappa, double tolerance) noexcept;

}  // namespace softcnc::ipo
