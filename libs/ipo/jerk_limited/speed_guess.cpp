// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/speed_guess.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// Returns the largest q that the jerk allows at this point of a curve at constant speed.
double jerk_limited_q(const PathPoint& point, const AxisVector& jerk) noexcept {
  double most = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (point.dddq[i] != 0) most = std::min(most, jerk[i] / std::abs(point.dddq[i]));
  return std::cbrt(most);
}

bool hardly_felt(const PathPoint& point, double v, const ConstraintList& constraints) noexcept {
  const AxisVector a = point.ddq.cwiseAbs() * (v * v), j = point.dddq.cwiseAbs() * (v * v * v);
  return (a.array() <= tuning::guess::kHardly * constraints.limits().acceleration.array()).all() &&
         (j.array() <= tuning::guess::kHardly * constraints.limits().jerk.array()).all();
}

/// Whether an axis moves along the path at all.
std::array<bool, kAxes> moving_axes(const PlanSpan& span) noexcept {
  std::array<bool, kAxes> moving{};
  for (std::size_t i = span.first; i < span.last; ++i) {
    const Interval& in = span.interval(i);
    for (int k = 0; k < kAxes; ++k)
      if (in.left.dq[k] != 0 || in.right.dq[k] != 0) moving[static_cast<std::size_t>(k)] = true;
  }
  return moving;
}

/// Returns the shortest time, s, in which an axis that moves builds up its acceleration; one that
/// can do so within a period is followed from sample to sample, or every n-th sample.
double shortest_phase(const PlanSpan& span, double samples) noexcept {
  const double period = span.constraints.limits().fine_period;
  const AxisVector times =
      span.constraints.limits().acceleration.cwiseQuotient(span.constraints.limits().jerk);
  const auto moving = moving_axes(span);
  double shortest = kUnlimited;
  for (int i = 0; i < kAxes; ++i)
    if (moving[static_cast<std::size_t>(i)] && times[i] > 0)
      shortest =
          std::min(shortest, times[i] < period ? tuning::guess::kNodesPerPhase * samples * period
                                               : times[i] / span.jerk_part);
  return shortest;
}

}  // namespace

SpeedGuess::SpeedGuess(const PlanSpan& span, const PlacedMotion& start, const PlacedMotion& end)
    : from_(start.s), to_(end.s) {
  shortest_ = tuning::guess::kShortestTime * span.constraints.limits().fine_period;
  std::vector<Cell> cells;
  for (std::size_t i = span.first; i < span.last; ++i) cells.push_back(cell(span, i));
  std::vector<Cell> mirrored(cells.rbegin(), cells.rend());
  for (Cell& each : mirrored) std::swap(each.begin_v, each.end_v);
  const auto walk_both = [&](double samples) {
    phase_ = shortest_phase(span, samples);
    ahead_ = walk(cells, from_ - span.s(span.first), start.motion, to_ - from_);
    back_ = walk(mirrored, span.s(span.last) - to_, end.motion, to_ - from_);
    return static_cast<double>(std::max(ahead_.size(), back_.size()));
  };
  if (const double samples = walk_both(1); samples > tuning::guess::kMany)
    walk_both(samples / tuning::guess::kMany);
}

SpeedGuess::Cell SpeedGuess::cell(const PlanSpan& span, std::size_t i) const noexcept {
  const Interval& interval = span.interval(i);
  const auto bound = [&](const Node& node, const VelocityLimit& own) {
    return std::sqrt(node.velocity_limit.q > 0 ? node.velocity_limit.q : own.q);
  };
  const AxisVector jerk = span.jerk_limits();
  const bool straight = interval.straight();
  const Directions directions = interval.directions();
  Cell cell{
      interval.length(),
      bound(span.chain.nodes[i], interval.left_limit),
      bound(span.chain.nodes[i + 1], interval.right_limit),
      std::sqrt(span.chain.inside[i].velocity_limit.q),
      tuning::guess::kAccelerationPart * (straight ? span.constraints.straight_u(interval.left.dq)
                                                   : span.constraints.least_u(directions)),
      straight ? along(jerk, interval.left.dq) : directions.least(jerk),
      straight,
      kUnlimited};
  if (straight) {
    cell.steady_v = cell.inside_v;
    return cell;
  }
  cell.begin_v = std::min(cell.begin_v, jerk_limited_q(interval.left, jerk));
  cell.end_v = std::min(cell.end_v, jerk_limited_q(interval.right, jerk));
  const double v = cell.begin_v;
  if (v == cell.end_v && hardly_felt(interval.left, v, span.constraints) &&
      hardly_felt(interval.right, v, span.constraints))
    cell.steady_v = v;
  return cell;
}

/// Returns the longest time to the next node: a part of the phases of a motion, and of the time in
/// which its speed doubles.
double SpeedGuess::time_step(const Motion& at, double j) const noexcept {
  const double phase = std::min(phase_, std::sqrt(at.v / j)) / tuning::guess::kNodesPerPhase;
  return std::max(
      std::min(std::max(phase, shortest_), tuning::guess::kGrowth * at.v / std::abs(at.a)),
      tuning::guess::kLeastTime * shortest_);
}

std::vector<SpeedGuess::Sample> SpeedGuess::walk(const std::vector<Cell>& cells, double skip,
                                                 Motion at, double distance) const {
  std::vector<Sample> samples;
  const double slowest = tuning::guess::kSlowest * at.v;
  double s = 0, begin = -skip, steady_from = kUnlimited;
  for (const Cell& cell : cells) {
    const double end = std::min(begin + cell.length, distance);
    while (s < end) {
      const bool cruises = at.v >= cell.steady_v;
      const double steady = cruises ? tuning::guess::kGrading * std::max(s - steady_from, 0.0) : 0;
      double dt = time_step(at, cell.j) + steady / at.v;
      samples.push_back({s, at.v, at.v * dt});
      const auto free_v = [&] { return at.v + dt * (at.a + 0.5 * dt * cell.j); };
      const auto next_v = [&] { return std::max(free_v(), slowest); };
      double ds = 0.5 * dt * (at.v + next_v());
      if (s + ds >= end) {
        dt *= (end - s) / ds;
        ds = end - s;
      }
      s = s + ds >= end ? end : s + ds;
      Motion next{next_v(), std::min(at.a + dt * cell.j, cell.a)};
      if (free_v() < slowest) next.a = std::max(next.a, 0.0);  // it cannot slow down any further
      const double bound = s == end ? std::min(cell.limit_at(1), cell.end_v)
                                    : cell.limit_at((s - begin) / cell.length);
      if (next.v < bound) steady_from = kUnlimited;
      if (next.v >= bound && (bound < at.v || steady_from == kUnlimited))
        steady_from = s + bound * std::abs(next.a) / cell.j;  // the jerk rounds the corner
      at = next.v < bound ? next : Motion{bound, 0};
    }
    begin += cell.length;
  }
  samples.push_back({distance, at.v, at.v * shortest_});
  return samples;
}

SpeedGuess::Sample SpeedGuess::between(const std::vector<Sample>& samples, double s) noexcept {
  const auto after = std::partition_point(samples.begin(), samples.end(),
                                          [s](const Sample& sample) { return sample.s < s; });
  if (after == samples.begin()) return samples.front();
  if (after == samples.end()) return samples.back();
  const Sample &a = after[-1], &b = *after;
  const double w = (s - a.s) / (b.s - a.s);
  return {s, a.v + w * (b.v - a.v), a.spacing + w * (b.spacing - a.spacing)};
}

double SpeedGuess::speed(double s) const noexcept {
  return std::min(between(ahead_, s - from_).v, between(back_, to_ - s).v);
}

double SpeedGuess::spacing(double s) const noexcept {
  return std::min(between(ahead_, s - from_).spacing, between(back_, to_ - s).spacing);
}

}  // namespace softcnc::ipo
