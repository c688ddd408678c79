// SPDX-License-Identifier: MIT
// What corners and other joints require of the speed, the acceleration and the jerk around them.
#pragma once

#include <vector>

#include "ipo/path/chain.hpp"

namespace softcnc::ipo {

/// Lowers the velocity limits around the joints from node `first` on that the machine passes with a
/// jump of velocity or acceleration, and notes what the jumps leave of the axis limits to the
/// curve. `times` are the shortest times of the intervals, s.
void apply_corner_limits(Chain& chain, const ConstraintList& constraints,
                         const std::vector<double>& times, std::size_t first);

/// Returns a speed, mm/s, that no machine with jerk limits exceeds at a node, given the rests
/// within three fine periods of it; kUnlimited without any, or without jerk limits.
double fastest_beside_rest(const Chain& chain, const ConstraintList& constraints,
                           std::size_t node) noexcept;

}  // namespace softcnc::ipo
