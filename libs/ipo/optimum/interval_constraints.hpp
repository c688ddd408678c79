// SPDX-License-Identifier: MIT
// What the limits of acceleration allow in one interval: rows on q at its left end and u, the path
// acceleration. They are the same for both passes.
#pragma once

#include <array>
#include <cstddef>

#include "ipo/path/corner_load.hpp"
#include "ipo/path/grid.hpp"

namespace softcnc::ipo {

class IntervalRows {
 public:
  /// `share`: of the axis accelerations that the curve itself may use; `kinks` take theirs of it.
  IntervalRows(const Interval& interval, const Constraints& constraints, double share,
               const KinkUse& kinks = {}) noexcept;

  /// Of a straight interval the largest |u| where q is no more than this.
  double straight_u(double q) const noexcept;
  /// Of a straight interval the largest q that is reached from this one over `length` mm with the u
  /// allowed there.
  double straight_rise(double q, double length) const noexcept;

  // The others are for curved ones.

  /// The largest q <= q_cap at the left end from which some u leads to q_next or less.
  double largest_q(double q_cap, double q_next) const noexcept;
  /// The largest u at this q.
  double largest_u(double q) const noexcept;

 private:
  struct Bound {  // u <= p + m q, or u >= p + m q
    double p, m;
    double at(double q) const noexcept { return p + m * q; }
  };
  /// |u| <= at_rest - slope v on an axis that turns at kinks, and always as much as `least`.
  struct Falling {
    double at_rest, slope, least;
  };
  struct Edges {
    Bound upper, lower;
    double highest, lowest;  // u at this q
  };
  /// The lower bound is -p + m q.
  void add(double c0, double c1, double bound) noexcept;
  void leave_to(const KinkUse& kinks, const Interval& interval, const Constraints& constraints,
                double share) noexcept;
  Edges edges(double q, const Bound& upper) const noexcept;

  std::array<Bound, 2 * kAxes + 1> upper_;
  std::size_t count_ = 0;
  double q_bound_ = kUnlimited;
  double length_, stopping_;  // u = stopping q leads to rest at the right end
  double straight_u_ = kUnlimited;
  std::array<Falling, kAxes> falling_;  // of a straight interval
  std::size_t falling_count_ = 0;
};

}  // namespace softcnc::ipo
