// SPDX-License-Identifier: MIT
#include "ipo/jerk/plan_check.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/profile.hpp"

namespace softcnc::ipo {
namespace {

/// The constraints allow a little more.
constexpr double kJerkAllowed = 1.0045, kAccelerationAllowed = 1.0007, kVelocityAllowed = 1.0004;
constexpr double kPassingAllowed =
    1.0012;  // of the limit at a place: its constraints keep more free
constexpr double kStrictAllowed = 1 + 1e-7;  // rounding of a strict velocity limit
constexpr int kInstants = 4;                 // beside the first, or one per sample, up to
constexpr int kMostInstants = 16;            // this many
constexpr Used kTooMuch{kUnlimited, 0};      // the motion does not go forward

double used_constraints(const PlanSpan& span, const Inside& inside, const PathPoint& x,
                        const Instant& at, const CurvatureJumpLoad& load) noexcept {
  const double q = at.v * at.v;
  double acceleration = 0, jerk = 0;
  for (const Inequality& limit : span.constraints.accelerations(x))
    acceleration = std::max(acceleration, std::abs(limit.ddx * q + limit.dx * at.a) / limit.bound);
  for (const Inequality& limit : span.constraints.jerks(x)) {
    const int axis = limit.axis;
    const double own = limit.dddx * (q * at.v) + limit.ddx * (3 * at.v * at.a) + limit.dx * at.j;
    const double used = std::max(own + load.above[axis], load.below[axis] - own);
    jerk = std::max(jerk, std::abs(used) / (limit.bound * inside.jerk_share[axis]));
  }
  return std::max(jerk / (kJerkAllowed * span.share),
                  acceleration / (kAccelerationAllowed * span.share * inside.share));
}

/// Returns one instant per sample. The duration of a plan that went wrong may not be a number.
int instants_on(const Ramp& ramp, double period) noexcept {
  const double samples = ramp.duration / period;
  return static_cast<int>(std::fmin(std::fmax(samples, kInstants), kMostInstants));
}

/// Evaluates a ramp that begins at `t` s of its plan.
Used used_by(const PlanSpan& span, std::size_t i, const Ramp& ramp, double max_q, double t,
             PassedJumps& jumps) {
  const Quintic motion = quintic(ramp);
  const int instants = instants_on(ramp, span.constraints.limits().fine_period);
  Used used;
  for (int k = 0; k <= instants; ++k) {
    const double passed = ramp.duration * k / instants;
    const Instant at = motion.at(passed);
    if (!(at.v > -kStandstill && at.s > ramp.s0 - kStandstill && at.s < ramp.s1 + kStandstill))
      return kTooMuch;
    while (i + 1 < span.last && k < instants && span.interval(i).s1 <= at.s) ++i;
    const Interval& interval = span.interval(i);
    const PathPoint point =
        interval.straight()
            ? interval.left
            : softcnc::at(*interval.path, at.s, k < instants ? Side::after : Side::before);
    used.constraints =
        std::max(used.constraints,
                 used_constraints(span, span.chain.inside[i], point, at, jumps.at(t + passed)));
    const double q = at.v * at.v;
    used.velocity = std::max({used.velocity, q / (kVelocityAllowed * max_q),
                              q / (kPassingAllowed * interval.limit_at(at.s)),
                              q / (kStrictAllowed * interval.strict_q_at(at.s))});
  }
  return used;
}

}  // namespace

Used used_by(const PlanSpan& span, std::size_t i, const Ramp& ramp, double max_q) {
  PassedJumps none;
  return used_by(span, i, ramp, max_q, 0, none);
}

std::vector<Used> used_by(const PlanSpan& span, const std::vector<PlanNode>& nodes,
                          const PlanProblem& problem, const std::vector<Ramp>& ramps) {
  PassedJumps jumps(span, problem.jumps(), nodes.front().s, problem.problem().start(), ramps);
  std::vector<Used> all;
  all.reserve(ramps.size());
  double t = 0;
  for (std::size_t p = 0; p < ramps.size(); ++p) {
    all.push_back(used_by(span, nodes[p].interval, ramps[p], problem.limit_between(p), t, jumps));
    t += ramps[p].duration;
  }
  return all;
}

}  // namespace softcnc::ipo
