// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/plan_problem.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

std::vector<double> places(const std::vector<PlanNode>& nodes) {
  std::vector<double> s;
  s.reserve(nodes.size());
  for (const PlanNode& node : nodes) s.push_back(node.s);
  return s;
}

bool same(const PathPoint& a, const PathPoint& b) noexcept {
  const auto near = [](const AxisVector& x, const AxisVector& y) {
    return (x - y).norm() <= tuning::plan::kSame * (x.norm() + y.norm());
  };
  return near(a.dq, b.dq) && near(a.ddq, b.ddq) && near(a.dddq, b.dddq);
}

/// The lower of two insides.
Inside lower(const Inside& a, const Inside& b) noexcept {
  return {a.velocity_limit.q <= b.velocity_limit.q ? a.velocity_limit : b.velocity_limit,
          std::min(a.share, b.share), a.jerk_share.cwiseMin(b.jerk_share),
          a.feels_jump || b.feels_jump};
}

}  // namespace

PlanProblem::PlanProblem(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                         const PlanEnds& ends, const std::vector<NodeShare>& shares)
    : span_(span),
      nodes_(nodes),
      ends_(ends),
      shares_(shares),
      jumps_(find_jumps(span, nodes)),
      loads_(curvature_jump_loads(span, nodes, jumps_)),
      problem_(places(nodes), ends.start, ends.end) {
  limits_.reserve(nodes.size());
  const Directions directions = span.chain.directions(span.first, span.last);
  const double v = std::sqrt(ends.start.q), j = directions.least(span.jerk_limits());
  if (span.replans) faster_ = distance_to_fastest({v, 0.5 * ends.start.dq}, j);
  stop_ = stopping_distance(v, span.constraints, directions);
  for (std::size_t p = 0; p < nodes.size(); ++p) add_node(p);
}

void PlanProblem::add_node(std::size_t p) {
  const PlanNode& node = nodes_[p];
  const bool is_last = p + 1 == nodes_.size();
  VelocityLimit most = velocity_limit(p);
  const bool strict = most.limit == Limit::roughness;
  const double usual = strict ? tuning::plan::kStrictVelocityPart : tuning::plan::kVelocityPart;
  const double first = strict          ? tuning::plan::kFirstStrictVelocityPart
                       : span_.replans ? tuning::plan::kReplannedVelocityPart
                                       : tuning::plan::kFirstVelocityPart;
  const double part = usual + first_part(p) * (first - usual);
  // Both ends are given.
  problem_.add_node(p == 0    ? 2 * ends_.start.q
                    : is_last ? 2 * ends_.end.q
                              : part * shares_[p].velocity * most.q);
  if (shares_[p].holds_velocity && p > 0 && !is_last)
    problem_.add_constraint({{1, 0, 0}, part * shares_[p].velocity * most.q, false});
  if (p == 0 || is_last) most.q = p == 0 ? ends_.start.q : ends_.end.q;
  limits_.push_back(most);
  const std::size_t i = node.interval;
  const Inside inside = inside_around(p);
  const PathPoint point = span_.point(i, node.s, is_last ? Side::before : Side::after);
  add_constraints(p, point, inside);
  if (!node.joint) return;
  const PathPoint before = span_.point(i - 1, node.s, Side::before);
  if (!same(before, point)) add_constraints(p, before, inside);
}

/// Returns the lowest limits between the nodes around it.
Inside PlanProblem::inside_around(std::size_t p) const noexcept {
  const Chain& chain = span_.chain;
  const double from = p > 0 ? nodes_[p - 1].s : nodes_[p].s;
  const double to = p + 1 < nodes_.size() ? nodes_[p + 1].s : nodes_[p].s;
  std::size_t i = nodes_[p].interval;
  Inside inside = chain.inside[i];
  for (std::size_t k = i; k > span_.first && chain.nodes[k].s > from; --k)
    inside = lower(inside, chain.inside[k - 1]);
  for (std::size_t k = i + 1; k < span_.last && chain.nodes[k].s < to; ++k)
    inside = lower(inside, chain.inside[k]);
  return inside;
}

/// Returns the lowest velocity limit between the nodes around it.
VelocityLimit PlanProblem::velocity_limit(std::size_t p) const noexcept {
  const PlanNode& node = nodes_[p];
  const Chain& chain = span_.chain;
  const double from = p > 0 ? nodes_[p - 1].s : node.s;
  const double to = p + 1 < nodes_.size() ? nodes_[p + 1].s : node.s;
  if (slopes(node.interval, from, to)) return sloped_limit(p, from, to);
  VelocityLimit most = limit_inside(node.interval, node.s);
  const auto include = [&](std::size_t i) {
    if (chain.nodes[i].velocity_limit.q > 0) most.lower_to(chain.nodes[i].velocity_limit);
  };
  for (std::size_t i = node.interval; i >= span_.first && chain.nodes[i].s > from; --i) {
    include(i);
    if (i == span_.first) break;
    if (chain.intervals[i - 1].level()) most.lower_to(chain.inside[i - 1].velocity_limit);
  }
  for (std::size_t i = node.interval + 1; i <= span_.last && chain.nodes[i].s < to; ++i) {
    include(i);
    if (i < span_.last && chain.intervals[i].level()) most.lower_to(chain.inside[i].velocity_limit);
  }
  return most;
}

/// Whether a limit that may be steep, or slopes ahead of a bend, binds around interval i.
bool PlanProblem::slopes(std::size_t i, double from, double to) const noexcept {
  const Chain& chain = span_.chain;
  while (i > span_.first && chain.nodes[i].s > from) --i;
  bool binds = false;
  for (; i < span_.last && chain.nodes[i].s < to; ++i) {
    const Interval& in = chain.intervals[i];
    if (in.level() || chain.nodes[i + 1].velocity_limit.q == 0 ||
        chain.nodes[i].velocity_limit.q == 0)
      return false;
    binds = binds || is_steep(in.left_limit.limit) || is_steep(in.right_limit.limit);
  }
  return binds;
}

/// A plan that follows a slope finds a continuation if its next node need not be as slow as the one
/// after it: what counts is how far the limit sags below the line from node to node.
VelocityLimit PlanProblem::sloped_limit(std::size_t p, double from, double to) const noexcept {
  const Chain& chain = span_.chain;
  const PlanNode& node = nodes_[p];
  const VelocityLimit own = limit_inside(node.interval, node.s);
  double sag = 0;
  const auto include = [&](std::size_t i, const PlanNode& other) {
    const double w = (chain.nodes[i].s - node.s) / (other.s - node.s);
    const double line = own.q + w * (limit_inside(other.interval, other.s).q - own.q);
    sag = std::max(sag, line - chain.nodes[i].velocity_limit.q);
  };
  for (std::size_t i = node.interval; i > span_.first && chain.nodes[i].s > from; --i)
    if (chain.nodes[i].s < node.s) include(i, nodes_[p - 1]);
  for (std::size_t i = node.interval + 1; i < span_.last && chain.nodes[i].s < to; ++i)
    if (chain.nodes[i].s > node.s) include(i, nodes_[p + 1]);
  return {std::max(own.q - sag, 0.5 * own.q), own.limit};
}

/// Returns the limit on a curve or ahead of a bend, between the limits of its nodes, except for
/// those at rest.
VelocityLimit PlanProblem::limit_inside(std::size_t i, double s) const noexcept {
  const Chain& chain = span_.chain;
  const VelocityLimit &left = chain.nodes[i].velocity_limit,
                      &right = chain.nodes[i + 1].velocity_limit;
  const Interval& interval = chain.intervals[i];
  if (interval.level() || (left.q == 0 && right.q == 0)) return chain.inside[i].velocity_limit;
  if (left.q == 0 || right.q == 0) return left.q == 0 ? right : left;
  VelocityLimit bound = left.q <= right.q ? left : right;
  const double w = std::clamp((s - chain.nodes[i].s) / interval.length(), 0.0, 1.0);
  bound.q = left.q + w * (right.q - left.q);
  return bound;
}

/// Between two nodes q' stays within the control points of its spline, q' + q'' h / 2. The
/// acceleration constraints bound those, so that they hold between the nodes, too.
void PlanProblem::add_constraints(std::size_t p, const PathPoint& point, const Inside& inside) {
  const bool is_first = p == 0, is_last = p + 1 == nodes_.size();
  const double first = first_part(p);
  const double right = is_last ? 0 : nodes_[p + 1].s - nodes_[p].s;
  const double left = is_first ? 0 : nodes_[p].s - nodes_[p - 1].s;
  const double a_part =
      span_.share * inside.share *
      (tuning::plan::kAccelerationPart +
       first * (tuning::plan::kFirstAccelerationPart - tuning::plan::kAccelerationPart));
  const double j_part =
      span_.share * shares_[p].jerk *
      (tuning::plan::kJerkPart + first * (tuning::plan::kFirstJerkPart - tuning::plan::kJerkPart));
  const auto constrain_acceleration = [&](const Inequality& limit) {
    if (is_first || is_last) return;
    const double dx = limit.dx, ddx = limit.ddx, most = a_part * limit.bound;
    problem_.add_constraint({{ddx, 0.5 * dx, 0.25 * right * dx}, most, false});
    if (ddx != 0) problem_.add_constraint({{ddx, 0.5 * dx, -0.25 * left * dx}, most, false});
  };
  const auto constrain_jerk = [&](const Inequality& limit) {
    const double part = j_part * inside.jerk_share[limit.axis] * span_.jerk_part;
    problem_.add_constraint({{limit.dddx, 1.5 * limit.ddx, 0.5 * limit.dx},
                             part * (limit.bound - loads_[p].whole[limit.axis]),
                             true,
                             part * loads_[p].per_q.above[limit.axis],
                             part * loads_[p].per_q.below[limit.axis]});
  };
  const auto is_at = [](int axis, const Inequality& limit) {
    return limit.axis == axis && (limit.dx != 0 || limit.ddx != 0 || limit.dddx != 0);
  };
  const Inequalities accelerations = span_.constraints.accelerations(point);
  const Inequalities jerks = span_.constraints.jerks(point);
  for (int axis = Inequality::kPath; axis < kAxes; ++axis) {
    for (const Inequality& limit : accelerations)
      if (is_at(axis, limit)) constrain_acceleration(limit);
    for (const Inequality& limit : jerks)
      if (is_at(axis, limit)) constrain_jerk(limit);
  }
}

/// Returns 1 where the plan continues another one, falling to 0 a stopping distance further on;
/// from the present position of the machine, 1 as long as it still accelerates.
double PlanProblem::first_part(std::size_t p) const noexcept {
  if (!ends_.continues) return 0;
  return std::clamp(1 - (nodes_[p].s - nodes_.front().s - faster_) / stop_, 0.0, 1.0);
}

/// The limit of a node holds up to its neighbours; the two ends have none.
double PlanProblem::limit_between(std::size_t p) const noexcept {
  const std::size_t last = limits_.size() - 1;
  if (p == 0) return last == 1 ? kUnlimited : std::max(limits_[1].q, limits_[0].q);
  return p + 1 == last ? limits_[p].q : std::max(limits_[p].q, limits_[p + 1].q);
}

Limit PlanProblem::limit(std::size_t p, const SpeedSquare& at) const noexcept {
  const bool inner = p > 0 && p + 1 < nodes_.size();
  if (inner && at.q >= tuning::plan::kBinds * problem_.velocity_limit(p)) return limits_[p].limit;
  double jerk = 0, acceleration = 0;
  for (std::size_t r = problem_.first_constraint(p); r < problem_.first_constraint(p + 1); ++r) {
    const SpeedConstraint& constraint = problem_.constraints()[r];
    double& used = constraint.over_root ? jerk : acceleration;
    used = std::max(used, std::abs(constraint.value(at)) / constraint.bound *
                              (constraint.over_root ? std::sqrt(at.q) : 1));
  }
  return jerk > acceleration ? Limit::jerk : Limit::acceleration;
}

double distance_to_fastest(const Motion& motion, double j) noexcept {
  return motion.a > 0 ? motion.a * (motion.v + motion.a * motion.a / (3 * j)) / j : 0;
}

double stopping_distance(double v, const ConstraintList& constraints,
                         const Directions& directions) noexcept {
  const double a = constraints.least_u(directions);
  const double j = directions.least(constraints.limits().jerk);
  return std::max(0.5 * v * (v / a + a / j), v * std::sqrt(v / j));
}

}  // namespace softcnc::ipo
