// SPDX-License-Identifier: MIT
// What the limits of acceleration allow in one interval: rows on q at its left end and u, the path
// acceleration. They are the same for both passes.
#pragma once

#include <array>
#include <cstddef>

#include "ipo/grid.hpp"

namespace softcnc::ipo {

class IntervalRows {
 public:
  /// `share`: of the axis accelerations that the curve itself may use.
  IntervalRows(const Interval& interval, const Constraints& constraints, double share) noexcept;

  /// Of a straight interval the largest |u|, whatever q; the others are for curved ones.
  double straight_u() const noexcept { return straight_u_; }
  /// The largest q <= q_cap at the left end from which some u leads to q_next or less.
  double largest_q(double q_cap, double q_next) const noexcept;
  /// The largest u at this q.
  double largest_u(double q) const noexcept;

 private:
  struct Bound {  // u <= p + m q, or u >= p + m q
    double p, m;
    double at(double q) const noexcept { return p + m * q; }
  };
  struct Edges {
    Bound upper, lower;
    double highest, lowest;  // u at this q
  };
  /// The lower bound is -p + m q.
  void add(double c0, double c1, double bound) noexcept;
  Edges edges(double q, const Bound& upper) const noexcept;

  std::array<Bound, 2 * kAxes + 1> upper_;
  std::size_t count_ = 0;
  double q_bound_ = kUnlimited;
  double length_, stopping_;  // u = stopping q leads to rest at the right end
  double straight_u_ = kUnlimited;
};

}  // namespace softcnc::ipo
