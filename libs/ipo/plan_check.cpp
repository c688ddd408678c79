// SPDX-License-Identifier: MIT
#include "ipo/plan_check.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// Rows are promised to a little more.
constexpr double kJerkAllowed = 1.003, kAccelerationAllowed = 1.0007, kCapAllowed = 1.0004;

double most(const AxisVector& values, const AxisVector& limits) noexcept {
  return values.cwiseAbs().cwiseQuotient(limits).maxCoeff();
}

/// Between a and b, h apart, q'' is linear.
SpeedSquare middle(double h, const SpeedSquare& a, const SpeedSquare& b) noexcept {
  const double u = 0.5 * h, third = (b.ddq - a.ddq) / h;
  return {a.q + u * (a.dq + u * (a.ddq / 2 + u * third / 6)), a.dq + u * (a.ddq + u * third / 2),
          0.5 * (a.ddq + b.ddq)};
}

double used(const SpeedSquare& at, const PathPoint& x, const Inside& inside,
            const PlanSpan& span) noexcept {
  const AxisVector jerk =
      (x.dddq * at.q + 1.5 * x.ddq * at.dq + 0.5 * x.dq * at.ddq) * std::sqrt(at.q);
  const AxisVector acceleration = x.ddq * at.q + 0.5 * x.dq * at.dq;
  const Constraints& limits = span.constraints;
  return std::max(
      most(jerk, limits.jerk_limits()) / (kJerkAllowed * span.share * inside.jerk_share),
      most(acceleration, limits.acceleration_limits()) /
          (kAccelerationAllowed * span.share * inside.share));
}

/// The cap of a node holds up to its neighbours; that of the two ends is none.
double cap_between(const SpeedProblem& problem, std::size_t p) noexcept {
  const std::size_t last = problem.size() - 1;
  if (p == 0) return last == 1 ? kUnlimited : std::max(problem.cap(1), problem.start().q);
  return p + 1 == last ? problem.cap(p) : std::max(problem.cap(p), problem.cap(p + 1));
}

}  // namespace

std::vector<Used> used_between(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                               const SpeedProblem& problem,
                               const std::vector<double>& coefficients) {
  std::vector<Used> all;
  all.reserve(nodes.size());
  SpeedSquare a = problem.spline().at_node(0, coefficients);
  std::size_t i = span.first;
  for (std::size_t p = 0; p + 1 < nodes.size(); ++p) {
    const SpeedSquare b = problem.spline().at_node(p + 1, coefficients);
    const SpeedSquare at = middle(nodes[p + 1].s - nodes[p].s, a, b);
    const double s = 0.5 * (nodes[p].s + nodes[p + 1].s);
    while (i + 1 < span.last && span.s(i + 1) <= s) ++i;
    Used most_used{kUnlimited, 0};
    if (at.q > 0)
      most_used.rows = used(at, span.point(i, s, Side::after), span.chain.inside[i], span);
    most_used.cap = at.q / (kCapAllowed * cap_between(problem, p));
    all.push_back(most_used);
    a = b;
  }
  return all;
}

}  // namespace softcnc::ipo
