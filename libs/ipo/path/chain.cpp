// SPDX-License-Identifier: MIT
#include "ipo/path/chain.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/rest_to_rest.hpp"

namespace softcnc::ipo {
namespace {

/// Tangents closer than this (rad) count as one: rounding of the geometry.
constexpr double kSameTangent = 1e-9;
constexpr double kSameBend = 1e-9;  // relative

struct Halves {
  Interval left, right;
};

Halves cut(const Interval& interval, double s) {
  Halves halves{interval, interval};
  halves.left.s1 = halves.right.s0 = s;
  halves.left.right = halves.right.left = point_inside(interval, s);
  halves.left.ends_move = false;
  Cap cap = interval.left_cap.q <= interval.right_cap.q ? interval.left_cap : interval.right_cap;
  cap.q = interval.cap_at(s);
  halves.left.right_cap = halves.right.left_cap = cap;
  halves.left.right_most = halves.right.left_most = interval.most_at(s);
  return halves;
}

/// How far the speed is felt at which a kink that stands alone may be passed, mm.
double step_over(const AxisVector& kink, const Constraints& constraints) {
  const double period = constraints.fine_period();
  const double by_acceleration =
      period / kink.cwiseQuotient(constraints.acceleration_limits()).maxCoeff() * period;
  if (!constraints.limits_jerk()) return kStraightKinkShare * by_acceleration;
  const double by_jerk =
      period * period / kink.cwiseQuotient(constraints.jerk_limits()).maxCoeff() * period;
  return std::min(kKinkShare * by_acceleration, kJerkSteps * kKinkJerkShare * by_jerk);
}

double middle(const Interval& interval) { return 0.5 * (interval.s0 + interval.s1); }

/// The step that an interval, or the joint before it, asks of a neighbour that could be faster.
double step_asked(const Cap& asked, const Cap& neighbour, double period) {
  return asked.q < neighbour.q ? std::sqrt(asked.q) * period : kUnlimited;
}

/// The shortest step asked of a neighbour by all intervals from its joint on that it reaches.
template <typename Iterator>
double step_across(Iterator first, Iterator last, const Cap& neighbour, double period) {
  const double longest = std::sqrt(neighbour.q) * period;
  double step = kUnlimited, distance = 0;
  for (; first != last && distance < longest; ++first) {
    const double asked = step_asked(first->step_cap, neighbour, period);
    if (asked > distance) step = std::min(step, asked);
    distance += first->length();
  }
  return step;
}

}  // namespace

PathPoint point_inside(const Interval& interval, double s) noexcept {
  const double w = (s - interval.s0) / interval.length();
  const auto mix = [w](const AxisVector& a, const AxisVector& b) -> AxisVector {
    return a + w * (b - a);
  };
  const PathPoint &a = interval.left, &b = interval.right;
  return {mix(a.q, b.q), mix(a.dq, b.dq), mix(a.ddq, b.ddq), mix(a.dddq, b.dddq)};
}

void Chain::append(const Move& move, const Constraints& constraints, RestBefore rest) {
  if (nodes.empty()) nodes.emplace_back();
  const double whole = length(move.path);
  // What lies further ahead of the joint is not asked by it.
  double felt =
      intervals.empty() ? 0 : std::sqrt(intervals.back().right_cap.q) * constraints.period();
  make_grid(move, constraints, grid_, [&](double s) {
    const double begin = grid_.front().s0;
    if (s < whole && s - begin < felt) return;
    make_room(static_cast<double>(grid_.size()) * (whole - begin) / (s - begin));
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      add(std::span<const Interval>(grid_).subspan(i), constraints, rest);
      rest.reset();
    }
    grid_.clear();
    felt = 0;
  });
  if (std::holds_alternative<Line>(move.path) && constraints.limits_jerk())
    split_at_cruise(constraints);
}

/// If the last move is a line from rest that is long enough. Behind the first node so made the
/// machine can stand still before the second one, and behind that is what can be felt of what
/// follows.
void Chain::split_at_cruise(const Constraints& constraints) {
  std::size_t first = intervals.size() - 1;
  while (intervals[first].s0 > 0) --first;
  if (nodes[first].own.q > 0) return;
  const Interval& line = intervals[first];
  const double end = intervals.back().s1;
  const double period_way = std::sqrt(line.left_cap.q) * constraints.period();
  const double ramp = way_to_cruise(line_limits(line, line.left_cap, constraints));
  const double felt_from = ipo::felt_from(line, end, constraints.period());
  const double cruise_at = felt_from - ramp - period_way;
  if (cruise_at <= ramp + kWorthwhile * period_way) return;
  for (std::size_t i = first; i < intervals.size(); ++i) intervals[i].cruise_at = cruise_at;
  split_move_at(cruise_at);
  split_move_at(felt_from);
}

/// The last one.
void Chain::split_move_at(double s) {
  std::size_t i = intervals.size() - 1;
  while (intervals[i].s0 > s) --i;
  if (intervals[i].s0 < s) split(i, s);
}

/// At once, for so many intervals as come if all of the move is like its first stretch; a long
/// curve has thousands.
void Chain::make_room(double more) {
  constexpr double kMost = 1e4;
  const std::size_t needed = intervals.size() + static_cast<std::size_t>(std::min(kMost, more)) + 1;
  if (needed <= intervals.capacity()) return;
  const std::size_t room = std::max(needed, 2 * intervals.capacity());
  intervals.reserve(room);
  inside.reserve(room);
  nodes.reserve(room + 1);
}

/// Adds the first of `ahead`; behind it stand those that are known to follow.
void Chain::add(std::span<const Interval> ahead, const Constraints& constraints, RestBefore rest) {
  const Interval& interval = ahead.front();
  const double period = constraints.period();
  double step = kUnlimited;
  if (!intervals.empty()) {
    Interval& before = intervals.back();
    const AxisVector jump = interval.left.dq - before.right.dq;
    const double turn = jump.norm();
    step = bend(before, interval, constraints);
    double back = std::min(step, step_asked(interval.step_cap, before.right_cap, period));
    step = std::min(step, step_asked(before.step_cap, interval.left_cap, period));
    if (turn > kSameTangent) {
      Node& joint = nodes.back();
      joint.turn = turn;
      joint.kink = jump.cwiseAbs();
      if (turn > kTangentTolerance) rest = rest.value_or(Limit::corner);
      const double kink_step =
          std::min({4 * kTurnShare * constraints.chord_tolerance() / turn,
                    std::sqrt(std::max(before.right_cap.q, interval.left_cap.q)) * period,
                    step_over(joint.kink, constraints)});
      back = std::min(back, kink_step);
      step = std::min(step, kink_step);
    }
    if (before.ends_move) {
      back = std::min(back, step_across(ahead.begin(), ahead.end(), before.right_cap, period));
      step = std::min(step,
                      step_across(intervals.rbegin(), intervals.rend(), interval.left_cap, period));
    }
    while (intervals.back().length() > back) split(intervals.size() - 1, middle(intervals.back()));
  }
  if (rest) nodes.back().own.lower_to({0, *rest});
  if (interval.length() <= step) return push(interval);
  Interval rest_of_it = interval;
  std::vector<Interval> later;
  while (rest_of_it.length() > step) {
    Halves halves = cut(rest_of_it, middle(rest_of_it));
    later.push_back(halves.right);
    rest_of_it = halves.left;
  }
  push(rest_of_it);
  for (; !later.empty(); later.pop_back()) push(later.back());
}

/// Notes how x'' jumps at the last node, and returns how far that is felt.
double Chain::bend(const Interval& before, const Interval& interval,
                   const Constraints& constraints) {
  if (!constraints.limits_jerk()) return kUnlimited;
  const AxisVector jump = interval.left.ddq - before.right.ddq;
  if (jump.cwiseAbs().maxCoeff() <=
      kSameBend * (interval.left.ddq.norm() + before.right.ddq.norm()))
    return kUnlimited;
  nodes.back().bend = jump;
  const double period = constraints.fine_period();
  const double fastest = std::max(before.right_cap.q, interval.left_cap.q);
  const double passed =
      period / jump.cwiseAbs().cwiseQuotient(constraints.jerk_limits()).maxCoeff();
  return 0.5 * kJerkSteps * period * std::sqrt(std::min(fastest, passed));
}

void Chain::push(const Interval& interval) {
  nodes.back().own.lower_to(interval.left_cap);
  Node end;
  end.own = interval.right_cap;
  end.s = nodes.back().s + interval.length();
  intervals.push_back(interval);
  nodes.push_back(end);
}

void Chain::split(std::size_t i, double s) {
  const auto n = static_cast<std::ptrdiff_t>(i);
  const Halves halves = cut(intervals[i], s);
  Node between;
  between.own = halves.left.right_cap;
  between.s = nodes[i].s + halves.left.length();
  intervals[i] = halves.left;
  intervals.insert(intervals.begin() + n + 1, halves.right);
  nodes.insert(nodes.begin() + n + 1, between);
}

Cap Chain::left_cap(std::size_t interval) const noexcept {
  Cap cap = intervals[interval].left_cap;
  if (nodes[interval].s >= slower_from) cap.lower_to(intervals[interval].slower_cap);
  return cap;
}

Cap Chain::own_cap(std::size_t node) const noexcept {
  Cap cap = nodes[node].own;
  if (node < intervals.size() && nodes[node].s >= slower_from)
    cap.lower_to(intervals[node].slower_cap);
  if (node > 0 && nodes[node - 1].s >= slower_from) cap.lower_to(intervals[node - 1].slower_cap);
  return cap;
}

std::size_t Chain::felt_from(std::size_t node, double period) const noexcept {
  double time = 0;
  while (node > 0 && time < kFeltPeriods * period) time += intervals[--node].shortest_time();
  return node;
}

Directions Chain::directions(std::size_t first, std::size_t last) const noexcept {
  Directions all;
  for (std::size_t i = first; i < last; ++i) all.add(intervals[i].directions());
  return all;
}

Directions Chain::directions_around(std::size_t node, double time) const noexcept {
  Directions all;
  for_intervals_in_step(node, time, [&](std::size_t i) {
    all.add(intervals[i].directions());
    return true;
  });
  return all;
}

void Chain::drop_front(std::size_t count) {
  const auto n = static_cast<std::ptrdiff_t>(count);
  intervals.erase(intervals.begin(), intervals.begin() + n);
  inside.erase(inside.begin(), inside.begin() + n);
  nodes.erase(nodes.begin(), nodes.begin() + n);
}

}  // namespace softcnc::ipo
