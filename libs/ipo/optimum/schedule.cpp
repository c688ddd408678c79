// SPDX-License-Identifier: MIT
#include "ipo/optimum/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

constexpr double kRelative = 1e-12;  // rounding of q

bool at_cap(double k, const Cap& cap) { return k >= cap.q * (1 - kRelative); }

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

/// The largest |u| of a straight interval at every speed of who goes from q to `right_k` as fast as
/// may be.
double straight_u(const Interval& interval, const IntervalRows& rows, const Reach& reach,
                  double q) {
  const double h = interval.length();
  return rows.straight_u(std::min({reach.inside.q, rows.straight_rise(q, h),
                                   rows.straight_rise(0.5 * (q + reach.right_k), 0.5 * h)}));
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

double reach_back(const Interval& interval, const IntervalRows& rows, const Reach& reach) noexcept {
  if (!interval.straight()) return rows.largest_q(reach.left.q, reach.right_k);
  const double h = interval.length();
  const double u = rows.straight_u(rows.straight_rise(reach.right_k, h));
  return std::min(reach.left.q, reach.right_k + 2 * u * h);
}

double run_forward(const Interval& interval, const IntervalRows& rows, const Reach& reach, double q,
                   std::vector<SpeedPiece>& out) {
  if (interval.straight())
    return run_straight(interval, reach, straight_u(interval, rows, reach, q), q, out);
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
