// SPDX-License-Identifier: MIT
// The way to a standstill from anywhere on the path.
#pragma once

#include <vector>

#include "ipo/limits/constraint.hpp"
#include "ipo/path/window.hpp"
#include "ipo/queue/block_queue.hpp"

namespace softcnc::ipo {

struct StopPlan {
  std::vector<Profile> profiles;  // of the blocks from the present one to that of the stop
  PlanEffort effort;
};

/// The blocks around the machine, in order; the first `passed` lie behind it.
struct BlocksAround {
  std::vector<const TimedBlock*> blocks;
  std::size_t passed = 0;
};

/// The shortest stop on the path, under the same constraints, from the state `now` inside the first
/// block not passed; the last profile ends at rest. `as`: what the profiles are to say holds the
/// feed down. No profiles, should rounding leave no way to stop.
StopPlan plan_stop(const Constraints& constraints, const BlocksAround& around, const State& now,
                   Limit as);

/// No stop from this state need be longer than this on a straight line of these directions, mm.
double longest_stop(const State& now, const Constraints& constraints,
                    const Directions& directions) noexcept;

/// A plan leaves nothing of its accelerations unused where another one begins: what interpolating
/// and rounding may cost is added here, well within the 0.1 % of the promise.
inline constexpr double kAccelerationShare = 1 + 5e-4;

}  // namespace softcnc::ipo
