// SPDX-License-Identifier: MIT
#include "ipo/acceleration_limited/interval_constraints.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {

IntervalConstraints::IntervalConstraints(const Interval& interval,
                                         const ConstraintList& constraints, double share,
                                         const TangentJumpUse& jumps) noexcept
    : length_(interval.length()), stopping_(-1 / (2 * length_)) {
  const PathPoint &left = interval.left, &right = interval.right;
  if (interval.straight()) {
    straight_u_ = share * constraints.straight_u(left.dq);
    leave_to(jumps, interval, constraints, share);
    return;
  }
  const double free = share * (1.0 - tuning::optimum::kCurveMargin);
  const Inequalities at_left = constraints.accelerations(left);
  const Inequalities at_right = constraints.accelerations(right);
  for (std::size_t k = 0; k < at_left.size(); ++k) {
    const Inequality &begin = at_left[k], &end = at_right[k];
    add(begin.ddx, begin.dx, begin.bound * free);
    if (begin.axis != Inequality::kPath)
      add(end.ddx, end.dx + 2 * length_ * end.ddx, end.bound * free);
  }
}

/// A sample that sees an instant here sees tangent jumps within two periods of it, where the
/// machine may be faster by what it gains in that time.
void IntervalConstraints::leave_to(const TangentJumpUse& jumps, const Interval& interval,
                                   const ConstraintList& constraints, double share) noexcept {
  if (jumps.part.isZero(0)) return;
  for (int i = 0; i < kAxes; ++i) {
    if (jumps.part[i] == 0 || interval.left.dq[i] == 0) continue;
    const double all = share * constraints.limits().acceleration[i] / std::abs(interval.left.dq[i]);
    const double slope = all * jumps.per_speed[i];
    falling_[falling_count_++] = {all - slope * jumps.gained, slope, all * (1 - jumps.part[i])};
  }
}

double IntervalConstraints::straight_u(double q) const noexcept {
  double u = straight_u_;
  for (std::size_t i = 0; i < falling_count_; ++i)
    u = std::min(
        u, std::max(falling_[i].least, falling_[i].at_rest - falling_[i].slope * std::sqrt(q)));
  return u;
}

/// v^2 = q + 2 length (at_rest - slope v).
double IntervalConstraints::straight_rise(double q, double length) const noexcept {
  double rise = q + 2 * straight_u_ * length;
  for (std::size_t i = 0; i < falling_count_; ++i) {
    const auto& [at_rest, slope, least] = falling_[i];
    const double free = q + 2 * length * at_rest, half = length * slope;
    const double v = free > 0 ? free / (half + std::sqrt(half * half + free)) : 0;
    rise = std::min(rise, std::max(v * v, q + 2 * length * least));
  }
  return rise;
}

/// Adds a strip |c0 q + c1 u| <= bound, solved for u.
void IntervalConstraints::add(double c0, double c1, double bound) noexcept {
  // Where the axis hardly responds to u, the strip bounds q alone.
  if (std::abs(c1) < 1e-9 * std::max(1.0, std::abs(c0) * length_)) {
    if (c0 != 0) q_bound_ = std::min(q_bound_, bound / std::abs(c0));
    return;
  }
  upper_[count_++] = {bound / std::abs(c1), -c0 / c1};
}

/// Returns the tightest bounds on u at this q; q at the right end is never negative.
IntervalConstraints::Edges IntervalConstraints::edges(double q,
                                                      const LinearBound& upper) const noexcept {
  Edges best{upper, {0, stopping_}, upper.at(q), stopping_ * q};
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& [p, m] = upper_[i];
    if (p + m * q < best.highest) best.upper = upper_[i], best.highest = p + m * q;
    if (m * q - p > best.lowest) best.lower = {-p, m}, best.lowest = m * q - p;
  }
  return best;
}

double IntervalConstraints::largest_q(double q_limit, double q_next) const noexcept {
  const LinearBound arrive{q_next / (2 * length_), stopping_};
  double q = std::min(q_limit, q_bound_);
  for (int i = 0; i < 64; ++i) {  // each turn drops at least one pair of edges for good
    const Edges best = edges(q, arrive);
    const double closing = best.lower.m - best.upper.m;
    if (best.highest >= best.lowest || closing <= 0) break;
    const double crossing = std::max((best.upper.p - best.lower.p) / closing, 0.0);
    if (!(crossing < q)) break;
    q = crossing;
  }
  return q;
}

double IntervalConstraints::largest_u(double q) const noexcept {
  const Edges best = edges(q, {kUnlimited, 0});
  return std::max(best.highest, best.lowest);
}

}  // namespace softcnc::ipo
