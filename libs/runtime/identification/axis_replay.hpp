// SPDX-License-Identifier: MIT
// A recorded command on a simulated axis.
#pragma once

#include <span>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc::runtime {

/// The lost motion between encoder and table, by the side on which it lies at the start: the table
/// stays while the encoder is less than `ahead` in front of it, or less than `after` behind. One of
/// them is negative where the table is not where the encoder says; their sum is not.
struct Gap {
  double ahead = 0, after = 0;  // mm
};

/// The motor of an axis: where its encoder is, mm, at the start and then `parts` times a period.
struct MotorMotion {
  std::vector<double> encoder;
  int parts = 1;
};

/// Returns how the motor of an axis goes that is sent `commanded`, a position for each period, mm.
/// It begins at rest in the first of them. Between two periods the command is a cubic through the
/// four nearest positions. `period` and `loop_period` in s.
MotorMotion replay_motor(const Axis& axis, double period, double loop_period,
                         std::span<const double> commanded);

/// Returns where a record that is `delay` periods late has the table behind this motor at the end
/// of each period, mm: at `start` mm before, and where it came to after.
std::vector<double> replay_table(const MotorMotion& motor, const Gap& gap, double start,
                                 double delay);

}  // namespace softcnc::runtime
