// SPDX-License-Identifier: MIT
// The acceleration constraints of one interval: inequalities in q at its left end and u, the path
// acceleration. They are the same for both passes.
#pragma once

#include <array>
#include <cstddef>

#include "ipo/path/grid.hpp"
#include "ipo/path/tangent_jump_load.hpp"

namespace softcnc::ipo {

class IntervalConstraints {
 public:
  /// `share` is the part of the axis accelerations that the curve itself may use; `jumps` take
  /// their share of it.
  IntervalConstraints(const Interval& interval, const ConstraintList& constraints, double share,
                      const TangentJumpUse& jumps = {}) noexcept;

  /// Returns the largest |u| on a straight interval where q is no more than this.
  double straight_u(double q) const noexcept;
  /// Returns the largest q on a straight interval that is reached from this one over `length` mm
  /// with the u allowed there.
  double straight_rise(double q, double length) const noexcept;

  // The others are for curved intervals.

  /// Returns the largest q <= q_limit at the left end from which some u leads to q_next or less.
  double largest_q(double q_limit, double q_next) const noexcept;
  /// Returns the largest u at this q.
  double largest_u(double q) const noexcept;

 private:
  struct LinearBound {  // u <= p + m q, or u >= p + m q
    double p, m;
    double at(double q) const noexcept { return p + m * q; }
  };
  /// |u| <= at_rest - slope v on an axis that passes tangent jumps, and always as much as `least`.
  struct Falling {
    double at_rest, slope, least;
  };
  struct Edges {
    LinearBound upper, lower;
    double highest, lowest;  // u at this q
  };
  /// The lower bound is -p + m q.
  void add(double c0, double c1, double bound) noexcept;
  void leave_to(const TangentJumpUse& jumps, const Interval& interval,
                const ConstraintList& constraints, double share) noexcept;
  Edges edges(double q, const LinearBound& upper) const noexcept;

  std::array<LinearBound, 2 * Inequalities::kMost> upper_;
  std::size_t count_ = 0;
  double q_bound_ = kUnlimited;
  double length_, stopping_;  // u = stopping q leads to rest at the right end
  double straight_u_ = kUnlimited;
  std::array<Falling, kAxes> falling_;  // of a straight interval
  std::size_t falling_count_ = 0;
};

}  // namespace softcnc::ipo
