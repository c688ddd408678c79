// SPDX-License-Identifier: MIT
#include "ipo/path/chain.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/rest_to_rest.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

struct Halves {
  Interval left, right;
};

Halves cut(const Interval& interval, double s) {
  Halves halves{interval, interval};
  halves.left.s1 = halves.right.s0 = s;
  halves.left.right = halves.right.left = point_inside(interval, s);
  halves.left.ends_move = false;
  VelocityLimit bound =
      interval.left_limit.q <= interval.right_limit.q ? interval.left_limit : interval.right_limit;
  bound.q = interval.limit_at(s);
  halves.left.right_limit = halves.right.left_limit = bound;
  halves.left.right_strict_q = halves.right.left_strict_q = interval.strict_q_at(s);
  return halves;
}

/// Returns how far, mm, the speed matters at which a tangent jump that stands alone may be passed.
double step_over(const AxisVector& tangent_jump, const ConstraintList& constraints) {
  const double period = constraints.limits().fine_period;
  const double by_acceleration =
      period / tangent_jump.cwiseQuotient(constraints.limits().acceleration).maxCoeff() * period;
  if (!constraints.limits_jerk())
    return tuning::joints::kStraightTangentJumpShare * by_acceleration;
  const double by_jerk =
      period * period / tangent_jump.cwiseQuotient(constraints.limits().jerk).maxCoeff() * period;
  return std::min(tuning::joints::kTangentJumpShare * by_acceleration,
                  tuning::joints::kJerkSteps * tuning::joints::kTangentJumpJerkShare * by_jerk);
}

double middle(const Interval& interval) { return 0.5 * (interval.s0 + interval.s1); }

/// The step that an interval, or the joint before it, requires of a neighbour that could be faster.
double step_asked(const VelocityLimit& asked, const VelocityLimit& neighbour, double period) {
  return asked.q < neighbour.q ? std::sqrt(asked.q) * period : kUnlimited;
}

/// The shortest step that all intervals within its range, from its joint on, require of a
/// neighbour.
template <typename Iterator>
double step_across(Iterator first, Iterator last, const VelocityLimit& neighbour, double period) {
  const double longest = std::sqrt(neighbour.q) * period;
  double step = kUnlimited, distance = 0;
  for (; first != last && distance < longest; ++first) {
    const double asked = step_asked(first->step_limit, neighbour, period);
    if (asked > distance) step = std::min(step, asked);
    distance += first->length();
  }
  return step;
}

/// Whether the first interval is a turn that is not resolved and ends in a corner. It begins with a
/// rest as well: the curvature jumps there by far more than any speed allows.
bool turns_unresolved(std::span<const Interval> ahead) {
  return ahead.size() > 1 && ahead[0].straight() && !std::holds_alternative<Line>(*ahead[0].path) &&
         (ahead[1].left.dq - ahead[0].right.dq).norm() > tuning::chain::kTangentTolerance;
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

void Chain::append(const Move& move, const ConstraintList& constraints, RestBefore rest) {
  if (nodes.empty()) nodes.emplace_back();
  const double whole = length(move.path);
  // What lies further ahead of the joint is not limited by it.
  double felt = intervals.empty()
                    ? 0
                    : std::sqrt(intervals.back().right_limit.q) * constraints.limits().period;
  make_grid(move, constraints, grid_, [&](double s) {
    const double begin = grid_.front().s0;
    if (s < whole && s - begin < felt) return;
    reserve_for(static_cast<double>(grid_.size()) * (whole - begin) / (s - begin));
    for (std::size_t i = 0; i < grid_.size(); ++i) {
      add(std::span<const Interval>(grid_).subspan(i), constraints, rest);
      rest.reset();
    }
    grid_.clear();
    felt = 0;
  });
  if (std::holds_alternative<Line>(move.path) && constraints.limits_jerk() &&
      constraints.contour() == nullptr)
    split_at_cruise(constraints);
}

/// Splits the last move if it is a line from rest that is long enough. After the first node so made
/// the machine can still come to rest before the second one; what follows the line matters only
/// after the second.
void Chain::split_at_cruise(const ConstraintList& constraints) {
  std::size_t first = intervals.size() - 1;
  while (intervals[first].s0 > 0) --first;
  if (nodes[first].own.q > 0) return;
  const Interval& line = intervals[first];
  const double end = intervals.back().s1;
  const double period_distance = std::sqrt(line.left_limit.q) * constraints.limits().period;
  const double ramp = distance_to_cruise(line_limits(line, line.left_limit, constraints));
  const double felt_from = ipo::felt_from(line, end, constraints.limits().period);
  const double cruise_at = felt_from - ramp - period_distance;
  if (cruise_at <= ramp + tuning::grid::kWorthwhile * period_distance) return;
  for (std::size_t i = first; i < intervals.size(); ++i) intervals[i].cruise_at = cruise_at;
  split_move_at(cruise_at);
  split_move_at(felt_from);
}

/// Splits the last move.
void Chain::split_move_at(double s) {
  std::size_t i = intervals.size() - 1;
  while (intervals[i].s0 > s) --i;
  if (intervals[i].s0 < s) split(i, s);
}

/// Reserves memory once for the number of intervals that come if the rest of the move resembles its
/// first part; a long curve has thousands.
void Chain::reserve_for(double more) {
  const std::size_t needed =
      intervals.size() + static_cast<std::size_t>(std::min(tuning::chain::kMostReserved, more)) + 1;
  if (needed <= intervals.capacity()) return;
  const std::size_t capacity = std::max(needed, 2 * intervals.capacity());
  intervals.reserve(capacity);
  inside.reserve(capacity);
  nodes.reserve(capacity + 1);
}

/// Adds the first of `ahead`; the others are those that are known to follow it.
void Chain::add(std::span<const Interval> ahead, const ConstraintList& constraints,
                RestBefore rest) {
  const Interval& interval = ahead.front();
  const double period = constraints.limits().period;
  double step = kUnlimited;
  if (!intervals.empty()) {
    Interval& before = intervals.back();
    const AxisVector jump = interval.left.dq - before.right.dq;
    const double turn = jump.norm();
    step = note_curvature_jump(before, interval, constraints);
    double back = std::min(step, step_asked(interval.step_limit, before.right_limit, period));
    step = std::min(step, step_asked(before.step_limit, interval.left_limit, period));
    if (turn > tuning::chain::kSameTangent) {
      Node& joint = nodes.back();
      joint.turn = turn;
      joint.tangent_jump = jump.cwiseAbs();
      if (turn > tuning::chain::kTangentTolerance) rest = rest.value_or(Limit::corner);
      const double tangent_jump_step =
          std::min({4 * tuning::joints::kTurnShare * constraints.limits().chord_tolerance / turn,
                    std::sqrt(std::max(before.right_limit.q, interval.left_limit.q)) * period,
                    step_over(joint.tangent_jump, constraints)});
      back = std::min(back, tangent_jump_step);
      step = std::min(step, tangent_jump_step);
    }
    if (before.ends_move) {
      back = std::min(back, step_across(ahead.begin(), ahead.end(), before.right_limit, period));
      step = std::min(
          step, step_across(intervals.rbegin(), intervals.rend(), interval.left_limit, period));
    }
    while (intervals.back().length() > back) split(intervals.size() - 1, middle(intervals.back()));
  }
  if (turns_unresolved(ahead)) rest = rest.value_or(Limit::corner);
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

/// Notes how x'' jumps at the last node, and returns how far, mm, that matters.
double Chain::note_curvature_jump(const Interval& before, const Interval& interval,
                                  const ConstraintList& constraints) {
  if (!constraints.limits_jerk()) return kUnlimited;
  const AxisVector jump = interval.left.ddq - before.right.ddq;
  if (jump.cwiseAbs().maxCoeff() <=
      tuning::chain::kSameCurvature * (interval.left.ddq.norm() + before.right.ddq.norm()))
    return kUnlimited;
  nodes.back().curvature_jump = jump;
  const double period = constraints.limits().fine_period;
  const double fastest = std::max(before.right_limit.q, interval.left_limit.q);
  const double passed =
      period / jump.cwiseAbs().cwiseQuotient(constraints.limits().jerk).maxCoeff();
  return 0.5 * tuning::joints::kJerkSteps * period * std::sqrt(std::min(fastest, passed));
}

void Chain::push(const Interval& interval) {
  nodes.back().own.lower_to(interval.left_limit);
  Node end;
  end.own = interval.right_limit;
  end.s = nodes.back().s + interval.length();
  intervals.push_back(interval);
  nodes.push_back(end);
}

void Chain::split(std::size_t i, double s) {
  const auto n = static_cast<std::ptrdiff_t>(i);
  const Halves halves = cut(intervals[i], s);
  Node between;
  between.own = halves.left.right_limit;
  between.s = nodes[i].s + halves.left.length();
  intervals[i] = halves.left;
  intervals.insert(intervals.begin() + n + 1, halves.right);
  nodes.insert(nodes.begin() + n + 1, between);
}

void Chain::split_from(std::size_t first, const std::vector<std::vector<double>>& cuts) {
  const auto n = static_cast<std::ptrdiff_t>(first);
  const std::vector<Interval> old(intervals.begin() + n, intervals.end());
  const std::vector<Node> ends(nodes.begin() + n + 1, nodes.end());
  intervals.resize(first);
  nodes.resize(first + 1);
  for (std::size_t i = 0; i < old.size(); ++i) {
    Interval rest = old[i];
    for (const double s : cuts[i]) {
      const Halves halves = cut(rest, s);
      Node between;
      between.own = halves.left.right_limit;
      between.s = nodes.back().s + halves.left.length();
      intervals.push_back(halves.left);
      nodes.push_back(between);
      rest = halves.right;
    }
    intervals.push_back(rest);
    nodes.push_back(ends[i]);
  }
}

void Chain::lower(std::size_t node, const VelocityLimit& bound) noexcept {
  nodes[node].own.lower_to(bound);
  if (node > 0) intervals[node - 1].right_limit.lower_to(bound);
  if (node < intervals.size()) intervals[node].left_limit.lower_to(bound);
}

VelocityLimit Chain::left_limit(std::size_t interval) const noexcept {
  VelocityLimit bound = intervals[interval].left_limit;
  if (nodes[interval].s >= slower_from) bound.lower_to(intervals[interval].slower_limit);
  return bound;
}

VelocityLimit Chain::own_limit(std::size_t node) const noexcept {
  VelocityLimit bound = nodes[node].own;
  if (node < intervals.size() && nodes[node].s >= slower_from)
    bound.lower_to(intervals[node].slower_limit);
  if (node > 0 && nodes[node - 1].s >= slower_from)
    bound.lower_to(intervals[node - 1].slower_limit);
  return bound;
}

std::size_t Chain::felt_from(std::size_t node, double period) const noexcept {
  double time = 0;
  while (node > 0 && time < tuning::grid::kFeltPeriods * period)
    time += intervals[--node].shortest_time();
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
