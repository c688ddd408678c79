// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/plan_check.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/path/profile.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

constexpr Used kTooMuch{kUnlimited, 0};  // the motion does not go forward

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
  return std::max(jerk / (tuning::check::kJerk * span.share),
                  acceleration / (tuning::check::kAcceleration * span.share * inside.share));
}

/// Returns one instant per sample. The duration of a plan that went wrong may not be a number.
int instants_on(const Ramp& ramp, double period) noexcept {
  const double samples = ramp.duration / period;
  return static_cast<int>(
      std::fmin(std::fmax(samples, tuning::check::kInstants), tuning::check::kMostInstants));
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
    if (!(at.v > -tuning::path::kStandstill && at.s > ramp.s0 - tuning::path::kStandstill &&
          at.s < ramp.s1 + tuning::path::kStandstill))
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
    used.velocity = std::max({used.velocity, q / (tuning::check::kVelocity * max_q),
                              q / (tuning::check::kPassing * interval.limit_at(at.s)),
                              q / (tuning::check::kStrict * interval.strict_q_at(at.s))});
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
