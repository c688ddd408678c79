// SPDX-License-Identifier: MIT
#include "ipo/acceleration_limited/schedule.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

bool at_limit(double q, const VelocityLimit& bound) {
  return q >= bound.q * (1 - tuning::optimum::kRelative);
}

/// A part over which the end of the controllable set is a straight line.
struct ControllableLine {
  double s0, s1;
  double q0, q1;
  Limit limit;  // of a machine that follows it
};

void append(std::vector<SpeedPiece>& out, const SpeedPiece& piece) {
  if (piece.s1 > piece.s0) out.push_back(piece);
}

/// Follows the slope 2u from q at s0 until it meets the line, then the line. Returns q at s1.
double follow(const ControllableLine& line, double q, double u, std::vector<SpeedPiece>& out) {
  const double h = line.s1 - line.s0;
  q = std::min(q, line.q0);
  const double free = std::max(q + 2 * u * h, 0.0);
  if (free < line.q1) {
    append(out, {line.s0, line.s1, q, free, Limit::acceleration});
    return free;
  }
  const double slope = (line.q1 - line.q0) / h;
  double meet = line.s0;
  if (q < line.q0 * (1 - tuning::optimum::kRelative))
    meet = std::clamp(line.s0 + (line.q0 - q) / (2 * u - slope), line.s0, line.s1);
  const double q_meet = meet == line.s0 ? q : line.q0 + slope * (meet - line.s0);
  append(out, {line.s0, meet, q, q_meet, Limit::acceleration});
  append(out, {meet, line.s1, q_meet, line.q1, line.limit});
  return line.q1;
}

/// Returns what limits a machine at the end of the controllable set of a curved interval: the lower
/// velocity limit, if both ends are at theirs. A corner limits only itself; the path to and from it
/// is limited by acceleration.
Limit limit_along_controllable(const ControllableInterval& controllable) {
  if (!at_limit(controllable.left_q, controllable.left) ||
      !at_limit(controllable.right_q, controllable.right))
    return Limit::acceleration;
  const VelocityLimit& lower =
      controllable.left.q <= controllable.right.q ? controllable.left : controllable.right;
  const bool corner = lower.limit == Limit::corner && controllable.left.q != controllable.right.q;
  return corner ? Limit::acceleration : lower.limit;
}

/// Returns the largest |u| of a straight interval at every speed of a motion from q to right_q that
/// is as fast as it can be.
double straight_u(const Interval& interval, const IntervalConstraints& constraints,
                  const ControllableInterval& controllable, double q) {
  const double h = interval.length();
  return constraints.straight_u(
      std::min({controllable.inside.q, constraints.straight_rise(q, h),
                constraints.straight_rise(0.5 * (q + controllable.right_q), 0.5 * h)}));
}

double run_straight(const Interval& interval, const ControllableInterval& controllable, double u,
                    double q, std::vector<SpeedPiece>& out) {
  const double top = controllable.inside.q;
  const double free = q + 2 * u * interval.length();
  if (free < std::min(top, controllable.right_q)) {
    append(out, {interval.s0, interval.s1, q, free, Limit::acceleration});
    return free;
  }
  const double braking = controllable.right_q + 2 * u * interval.length();
  const double knee = braking <= top
                          ? interval.s0
                          : std::clamp(interval.s1 - (top - controllable.right_q) / (2 * u),
                                       interval.s0, interval.s1);
  if (knee > interval.s0)
    q = follow({interval.s0, knee, top, top, controllable.inside.limit}, q, u, out);
  if (knee == interval.s1) return q;
  return follow(
      {knee, interval.s1, std::min(top, braking), controllable.right_q, Limit::acceleration}, q, u,
      out);
}

}  // namespace

double backward_step(const Interval& interval, const IntervalConstraints& constraints,
                     const ControllableInterval& controllable) noexcept {
  if (!interval.straight()) return constraints.largest_q(controllable.left.q, controllable.right_q);
  const double h = interval.length();
  const double u = constraints.straight_u(constraints.straight_rise(controllable.right_q, h));
  return std::min(controllable.left.q, controllable.right_q + 2 * u * h);
}

double forward_step(const Interval& interval, const IntervalConstraints& constraints,
                    const ControllableInterval& controllable, double q,
                    std::vector<SpeedPiece>& out) {
  if (interval.straight())
    return run_straight(interval, controllable, straight_u(interval, constraints, controllable, q),
                        q, out);
  const double u = constraints.largest_u(q);
  const double h = interval.length();
  // The line can be followed where the set itself could; from below it, one slope is always left.
  const double u_along_controllable =
      q == controllable.left_q ? u : constraints.largest_u(controllable.left_q);
  const double ahead = controllable.left_q + 2 * u_along_controllable * h;
  if (ahead >= controllable.right_q * (1 - tuning::optimum::kRelative))
    return follow({interval.s0, interval.s1, controllable.left_q, controllable.right_q,
                   limit_along_controllable(controllable)},
                  q, u, out);
  const double end = std::clamp(q + 2 * u * h, 0.0, controllable.right_q);
  append(out, {interval.s0, interval.s1, q, end, Limit::acceleration});
  return end;
}

}  // namespace softcnc::ipo
