// SPDX-License-Identifier: MIT
// A recorded command on a simulated axis.
#pragma once

#include <span>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc::runtime {

/// The lost motion between encoder and table, by the side on which it lies at the start: the table
/// stays while the encoder is less than `ahead` in front of it, or less than `after` behind.
struct Gap {
  double ahead = 0, after = 0;  // mm, not negative
};

/// Returns where the table is at the end of each period, mm, where an axis is sent `commanded`, a
/// position for each period, mm. It begins at rest in the first of them, with the table at `start`
/// mm. Between two periods the command is a cubic through the four nearest positions. `period` and
/// `loop_period` in s.
std::vector<double> replay_axis(const Axis& axis, const Gap& gap, double period, double loop_period,
                                std::span<const double> commanded, double start);

}  // namespace softcnc::runtime
