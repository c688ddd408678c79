// SPDX-License-Identifier: MIT
#include "ipo/jerk_limited/rest_ramp.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/jerk_limited/plan_check.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

bool keeps(const PlanSpan& span, std::size_t i, const RestRamp& ramp, bool starts) {
  const Interval& in = span.interval(i);
  const Ramp driven =
      starts ? ramp.start(in.s0, in.s0 + ramp.length()) : ramp.end(in.s1 - ramp.length(), in.s1);
  return used_by(span, i, driven, kUnlimited).keeps();
}

}  // namespace

RestRamp rest_ramp(const PlanSpan& span, std::size_t i, Side of_rest) noexcept {
  const bool starts = of_rest == Side::after;
  const Interval& interval = span.interval(i);
  const Inside& inside = span.chain.inside[i];
  const PathPoint& point = starts ? interval.left : interval.right;
  const double limit = along(span.jerk_limits(), point.dq);
  const double acceleration = span.constraints.straight_u(point.dq);
  const VelocityLimit& other = span.chain.nodes[starts ? i + 1 : i].velocity_limit;
  const double q =
      other.q > 0 ? std::min(other.q, inside.velocity_limit.q) : inside.velocity_limit.q;
  RestRamp ramp;
  ramp.jerk = tuning::rest_ramp::kJerkPart * std::min(span.share, 1.0) *
              std::min(inside.share, inside.jerk_share.minCoeff()) * limit;
  const double rise = acceleration / limit;
  const double time =
      std::max(tuning::rest_ramp::kTimePart * rise,
               std::min(tuning::rest_ramp::kPeriodPart * span.constraints.limits().fine_period,
                        tuning::rest_ramp::kMostPart * rise));
  ramp.duration =
      std::min({time, std::cbrt(6 * tuning::rest_ramp::kLengthPart * interval.length() / ramp.jerk),
                std::sqrt(2 * tuning::rest_ramp::kSpeedPart * std::sqrt(q) / ramp.jerk)});
  for (int k = 0; k < tuning::rest_ramp::kMostShorter && !keeps(span, i, ramp, starts); ++k)
    ramp.duration *= tuning::rest_ramp::kShorter;
  return ramp;
}

}  // namespace softcnc::ipo
