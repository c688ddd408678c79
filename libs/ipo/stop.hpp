// SPDX-License-Identifier: MIT
// The way to a standstill from anywhere on the path.
#pragma once

#include <vector>

#include "ipo/block_queue.hpp"
#include "ipo/constraint.hpp"
#include "ipo/window.hpp"

namespace softcnc::ipo {

struct StopPlan {
  std::vector<Profile> profiles;  // of the blocks from the present one to that of the stop
  PlanEffort effort;
};

/// The shortest stop on the path, under the same constraints, from the state `now` inside the first
/// block not passed, at program time `t`; the last profile ends at rest. `as`: what the profiles
/// are to say holds the feed down. Should rounding leave no way to stop at once, the plan goes on
/// to its next rest at the end of a block, which counts as a fall-back.
StopPlan plan_stop(const Constraints& constraints, const PartlyPassed& rest, const State& now,
                   double t, Limit as);

/// A plan leaves nothing of its accelerations unused where another one begins: what interpolating
/// and rounding may cost is added here, well within the 0.1 % of the promise.
inline constexpr double kAccelerationShare = 1 + 5e-4;

}  // namespace softcnc::ipo
