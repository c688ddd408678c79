// SPDX-License-Identifier: MIT
#include "ipo/schedule.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// Kept free of the acceleration limits on curves: what the grid's tolerance may add to them.
constexpr double kCurveMargin = 5e-4;
constexpr double kRelative = 1e-12;  // rounding of q

bool at_cap(double k, const Cap& cap) { return k >= cap.q * (1 - kRelative); }

/// The limits of one curved interval on (q at its left end, u).
class IntervalRows {
 public:
  IntervalRows(const Interval& interval, const Constraints& constraints, double share) noexcept;

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

  std::array<Bound, 2 * kAxes> upper_;
  std::size_t count_ = 0;
  double q_bound_ = kUnlimited;
  double length_, stopping_;  // u = stopping q leads to rest at the right end
};

IntervalRows::IntervalRows(const Interval& interval, const Constraints& constraints,
                           double share) noexcept
    : length_(interval.length()), stopping_(-1 / (2 * length_)) {
  const double free = share * (1.0 - kCurveMargin);
  const PathPoint &left = interval.left, &right = interval.right;
  for (int i = 0; i < kAxes; ++i) {
    const double bound = constraints.acceleration_limits()[i];
    if (bound == kUnlimited) continue;
    add(left.ddq[i], left.dq[i], bound * free);
    add(right.ddq[i], right.dq[i] + 2 * length_ * right.ddq[i], bound * free);
  }
}

/// A strip |c0 q + c1 u| <= bound, solved for u.
void IntervalRows::add(double c0, double c1, double bound) noexcept {
  // Where the axis hardly answers to u, the strip bounds q alone.
  if (std::abs(c1) < 1e-9 * std::max(1.0, std::abs(c0) * length_)) {
    if (c0 != 0) q_bound_ = std::min(q_bound_, bound / std::abs(c0));
    return;
  }
  upper_[count_++] = {bound / std::abs(c1), -c0 / c1};
}

/// The tightest bounds on u at this q; q at the right end is never negative.
IntervalRows::Edges IntervalRows::edges(double q, const Bound& upper) const noexcept {
  Edges best{upper, {0, stopping_}, upper.at(q), stopping_ * q};
  for (std::size_t i = 0; i < count_; ++i) {
    const auto& [p, m] = upper_[i];
    if (p + m * q < best.highest) best.upper = upper_[i], best.highest = p + m * q;
    if (m * q - p > best.lowest) best.lower = {-p, m}, best.lowest = m * q - p;
  }
  return best;
}

double IntervalRows::largest_q(double q_cap, double q_next) const noexcept {
  const Bound arrive{q_next / (2 * length_), stopping_};
  double q = std::min(q_cap, q_bound_);
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

double IntervalRows::largest_u(double q) const noexcept {
  const Edges best = edges(q, {kUnlimited, 0});
  return std::max(best.highest, best.lowest);
}

/// Largest |u| of a straight interval.
double straight_acceleration(const Interval& interval, const Constraints& constraints,
                             double share) {
  double u = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (interval.left.dq[i] != 0)
      u = std::min(u, constraints.acceleration_limits()[i] / std::abs(interval.left.dq[i]));
  return u * share;
}

/// A stretch over which K is a straight line.
struct KLine {
  double s0, s1;
  double k0, k1;
  Limit limit;  // of who runs along it
};

void append(std::vector<SpeedPiece>& out, const SpeedPiece& piece) {
  if (piece.s1 > piece.s0) out.push_back(piece);
}

/// From q at s0 along the slope 2u until the line of K is met; then along it. Returns q at s1.
double follow(const KLine& line, double q, double u, std::vector<SpeedPiece>& out) {
  const double h = line.s1 - line.s0;
  q = std::min(q, line.k0);
  const double free = std::max(q + 2 * u * h, 0.0);
  if (free < line.k1) {
    append(out, {line.s0, line.s1, q, free, Limit::acceleration});
    return free;
  }
  const double slope = (line.k1 - line.k0) / h;
  double meet = line.s0;
  if (q < line.k0 * (1 - kRelative))
    meet = std::clamp(line.s0 + (line.k0 - q) / (2 * u - slope), line.s0, line.s1);
  const double q_meet = meet == line.s0 ? q : line.k0 + slope * (meet - line.s0);
  append(out, {line.s0, meet, q, q_meet, Limit::acceleration});
  append(out, {meet, line.s1, q_meet, line.k1, line.limit});
  return line.k1;
}

/// What holds back who runs along K of a curved interval: the lower of its caps, if both ends are
/// at theirs; a corner holds back only itself, the way to and from it is acceleration.
Limit limit_along_k(const Reach& reach) {
  if (!at_cap(reach.left_k, reach.left) || !at_cap(reach.right_k, reach.right))
    return Limit::acceleration;
  const Cap& lower = reach.left.q <= reach.right.q ? reach.left : reach.right;
  const bool corner = lower.limit == Limit::corner && reach.left.q != reach.right.q;
  return corner ? Limit::acceleration : lower.limit;
}

double run_straight(const Interval& interval, const Reach& reach, double u, double q,
                    std::vector<SpeedPiece>& out) {
  const double top = reach.inside.q;
  const double free = q + 2 * u * interval.length();
  if (free < std::min(top, reach.right_k)) {
    append(out, {interval.s0, interval.s1, q, free, Limit::acceleration});
    return free;
  }
  const double braking = reach.right_k + 2 * u * interval.length();
  const double knee = braking <= top ? interval.s0
                                     : std::clamp(interval.s1 - (top - reach.right_k) / (2 * u),
                                                  interval.s0, interval.s1);
  if (knee > interval.s0) q = follow({interval.s0, knee, top, top, reach.inside.limit}, q, u, out);
  if (knee == interval.s1) return q;
  return follow({knee, interval.s1, std::min(top, braking), reach.right_k, Limit::acceleration}, q,
                u, out);
}

}  // namespace

double reach_back(const Interval& interval, const Constraints& constraints,
                  const Reach& reach) noexcept {
  if (!interval.straight())
    return IntervalRows(interval, constraints, reach.share).largest_q(reach.left.q, reach.right_k);
  const double u = straight_acceleration(interval, constraints, reach.share);
  return std::min(reach.left.q, reach.right_k + 2 * u * interval.length());
}

double run_forward(const Interval& interval, const Constraints& constraints, const Reach& reach,
                   double q, std::vector<SpeedPiece>& out) {
  if (interval.straight())
    return run_straight(interval, reach, straight_acceleration(interval, constraints, reach.share),
                        q, out);
  const IntervalRows rows(interval, constraints, reach.share);
  const double u = rows.largest_u(q);
  const double h = interval.length();
  // The line of K can be followed where K itself could; from below it, one slope is always left.
  const double along_k = q == reach.left_k ? u : rows.largest_u(reach.left_k);
  const double ahead = reach.left_k + 2 * along_k * h;
  if (ahead >= reach.right_k * (1 - kRelative))
    return follow({interval.s0, interval.s1, reach.left_k, reach.right_k, limit_along_k(reach)}, q,
                  u, out);
  const double end = std::clamp(q + 2 * u * h, 0.0, reach.right_k);
  append(out, {interval.s0, interval.s1, q, end, Limit::acceleration});
  return end;
}

}  // namespace softcnc::ipo
