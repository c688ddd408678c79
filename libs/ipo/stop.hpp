// SPDX-License-Identifier: MIT
// The way to a standstill from anywhere on the path.
#pragma once

#include <deque>

#include "ipo/block_queue.hpp"
#include "ipo/constraint.hpp"

namespace softcnc::ipo {

/// The shortest stop on the path, under the same constraints, from the state `now` inside the first
/// block not passed, at program time `t`; the blocks end at rest. Returns the blocks from the
/// present one to that of the stop. Should rounding leave no way to stop at once, the plan goes on
/// to its next rest at the end of a block.
std::deque<TimedBlock> plan_stop(const Constraints& constraints, PartlyPassed rest,
                                 const State& now, double t);

}  // namespace softcnc::ipo
