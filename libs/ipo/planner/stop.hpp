// SPDX-License-Identifier: MIT
// A stop from anywhere on the path.
#pragma once

#include <vector>

#include "ipo/limits/constraint_list.hpp"
#include "ipo/path/window.hpp"
#include "ipo/queue/block_queue.hpp"

namespace softcnc::ipo {

struct StopPlan {
  std::vector<Profile> profiles;  // of the blocks from the present one to that of the stop
  PlanEffort effort;
};

/// The blocks around the machine, in order; the first `passed` have been passed.
struct BlocksAround {
  std::vector<const TimedBlock*> blocks;
  std::size_t passed = 0;
};

/// Returns the shortest stop on the path, under the same constraints, from the state `now` inside
/// the first block not passed; the last profile ends at rest. `as` is the limit that the profiles
/// name. Returns no profiles should rounding leave no way to stop.
StopPlan plan_stop(const ConstraintList& constraints, const BlocksAround& around, const State& now,
                   Limit as);

/// Returns a distance, mm, that a stop from this state need not exceed on a straight line of these
/// directions.
double longest_stop(const State& now, const ConstraintList& constraints,
                    const Directions& directions) noexcept;

}  // namespace softcnc::ipo
