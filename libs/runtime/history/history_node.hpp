// SPDX-License-Identifier: MIT
// A row of a run that its history keeps.
#pragma once

#include <array>
#include <cstdint>

#include "runtime/history/run_row.hpp"

namespace softcnc::runtime {

/// A row that is kept, and what was largest in the rows after the node before it up to this one.
struct HistoryNode {
  std::int64_t period = 0;
  AxisVector position = AxisVector::Zero();  // mm
  double s = 0;                              // mm of path from the start of the program
  double v = 0, feed = 0;                    // mm/s
  MotionKind motion = MotionKind::rest;      // of most of these rows, as the limit
  Limit limit = Limit::stop;
  int tool = 0;
  float acceleration_use = 0, jerk_use = 0;  // parts of the limits of the axes; 0 without limits
  float chord_error = RunRow::kUnknown;      // um
  float contour = RunRow::kUnknown;          // um
  float deviation = RunRow::kUnknown;        // um
  float rmax = RunRow::kUnknown;             // um
  float rmax_target = RunRow::kUnknown;      // um
};

/// What is largest since the node before.
inline constexpr std::array kLargest{&HistoryNode::acceleration_use, &HistoryNode::jerk_use,
                                     &HistoryNode::chord_error,      &HistoryNode::contour,
                                     &HistoryNode::deviation,        &HistoryNode::rmax,
                                     &HistoryNode::rmax_target};
/// A value for each of them.
using LargestValues = std::array<float, kLargest.size()>;

}  // namespace softcnc::runtime
