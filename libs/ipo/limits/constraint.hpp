// SPDX-License-Identifier: MIT
// A reason to be slow. Every one is a Constraint in a file of its own; constraint_list.cpp lists
// them.
//
// A constraint acts in one of three ways: as a velocity limit, an upper bound on q = v^2 at a
// point; as inequalities of acceleration; or as inequalities of jerk (Inequality).
#pragma once

#include <optional>

#include "ipo/limits/directions.hpp"
#include "ipo/limits/inequality.hpp"
#include "ipo/limits/planner_limits.hpp"
#include "motion/model/block.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

/// A point of a path, and the q = v^2 that is planned there.
struct Passing {
  const PathPoint& point;
  double q;
};

/// One reason to be slow, evaluated once per node of the grid and one-sided where derivatives jump.
class Constraint {
 public:
  Constraint() = default;
  Constraint(const Constraint&) = delete;
  Constraint& operator=(const Constraint&) = delete;
  virtual ~Constraint() = default;

  /// Returns its name in the trace.
  virtual Limit limit(const Move& move) const noexcept = 0;

  // As a velocity limit ---------------------------------------------------------------------------

  /// Returns the upper bound on q = v^2 at this point, mm^2/s^2.
  virtual double velocity_limit(const PathPoint&, const Move&) const noexcept { return kUnlimited; }

  /// True if the limit holds for every period's step that touches the point: the step, not only the
  /// point, then keeps it.
  virtual bool holds_over_steps() const noexcept { return false; }

  /// True if the limit is strict: it holds between the nodes of the grid, too, without the grid's
  /// tolerance.
  virtual bool is_strict() const noexcept { return false; }

  /// Returns false if the limit may vary between two points of a move in a way that their middle
  /// does not show.
  virtual bool is_even(const PathPoint&, const PathPoint&, const Move&) const noexcept {
    return true;
  }

  /// Returns false if a q on the line between two points exceeds the limit between them, where x'
  /// is longer than on the line between theirs by up to `sag` on each axis, by more than
  /// `tolerance` of it.
  virtual bool holds_between(const Passing&, const Passing&, const AxisVector& /*sag*/,
                             double /*tolerance*/) const noexcept {
    return true;
  }

  /// Returns the largest acceleration x'' q that each axis may have in a curve, mm/s^2.
  virtual AxisVector centripetal_limits() const noexcept {
    return AxisVector::Constant(kUnlimited);
  }

  // As inequalities of acceleration ---------------------------------------------------------------

  virtual void add_acceleration_inequalities(const PathPoint&, Inequalities&) const noexcept {}

  /// Returns a bound on q that the inequalities imply: no q is larger, whatever the path
  /// acceleration u.
  virtual double largest_q(const PathPoint&) const noexcept { return kUnlimited; }
  /// Returns a bound on |u| that the inequalities imply: no |u| is larger, whatever q is.
  virtual double largest_u(const PathPoint&) const noexcept { return kUnlimited; }
  /// Returns the largest |u| along a straight line.
  virtual double straight_u(const AxisVector& /*direction*/) const noexcept { return kUnlimited; }
  /// Returns the |u| that is always allowed on straight lines of these directions.
  virtual double least_u(const Directions&) const noexcept { return kUnlimited; }
  /// Returns a |u| that nothing exceeds on a path of these directions.
  virtual double most_u(const Directions&) const noexcept { return kUnlimited; }
  /// Returns its name if it, and not the acceleration of an axis, limits a path acceleration u at
  /// this place, where `share` of the limits may be used.
  virtual std::optional<Limit> binding(const Passing&, double /*u*/,
                                       double /*share*/) const noexcept {
    return {};
  }

  // As inequalities of jerk -----------------------------------------------------------------------

  virtual void add_jerk_inequalities(const PathPoint&, Inequalities&) const noexcept {}
};

}  // namespace softcnc::ipo
