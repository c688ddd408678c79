// SPDX-License-Identifier: MIT
// How the axes were commanded and how they went, from a trace.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/core/axes.hpp"
#include "motion/core/result.hpp"

namespace softcnc::runtime {

/// The motion of one axis: a position for each period.
struct AxisRecord {
  std::vector<double> commanded, actual;  // mm, of the same length
};

struct ServoRecord {
  double period = 0;                     // s
  std::array<AxisRecord, kAxes> axes{};  // empty where the trace has no actual position
};

/// Reads the commanded and actual positions of a trace (.csv, .npz, also .zst). The command is
/// x_cmd_mm where the trace has it, else x_mm; likewise of other axes. Errors: those of
/// hal::TraceReader, and SC6100 where no axis has an actual position or the trace has fewer rows
/// than a period needs to be known.
Result<ServoRecord> read_servo_record(const std::string& file);

}  // namespace softcnc::runtime
