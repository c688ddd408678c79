// SPDX-License-Identifier: MIT
// The way to a standstill from anywhere on the path.
#pragma once

#include <deque>

#include "ipo/block_queue.hpp"
#include "ipo/constraint.hpp"

namespace softcnc::ipo {

/// The shortest stop on the path, under the same constraints, from the state `now` inside the first
/// of `blocks` at program time `t`; the blocks end at rest. What would follow the stop is dropped.
std::deque<TimedBlock> plan_stop(const Constraints& constraints, std::deque<TimedBlock> blocks,
                                 const State& now, double t);

}  // namespace softcnc::ipo
