// SPDX-License-Identifier: MIT
// The history of a run in bounded memory: its rows thinned out where nothing of interest changes,
// and which line was executed when.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "motion/model/machine.hpp"
#include "runtime/history/run_row.hpp"

namespace softcnc::runtime {

/// A row that is kept, and what was largest in the rows after the node before it up to this one.
struct HistoryNode {
  std::int64_t period = 0;
  AxisVector position = AxisVector::Zero();  // mm
  double s = 0;                              // mm of path from the start of the program
  double v = 0, feed = 0;                    // mm/s
  MotionKind motion = MotionKind::rest;      // of most of these rows, as the limit and the tool
  Limit limit = Limit::stop;
  int tool = 0;
  float acceleration_use = 0, jerk_use = 0;  // parts of the limits of the axes; 0 without limits
  float chord_error = RunRow::kUnknown;      // um
  float contour = RunRow::kUnknown;          // um
  float deviation = RunRow::kUnknown;        // um
  float rmax = RunRow::kUnknown;             // um
  float rmax_target = RunRow::kUnknown;      // um
};

/// The rows after period `period` belong to a line, up to the next span.
struct LineSpan {
  std::int64_t period = 0;
  int file = 0, line = 0;
};

class RunHistory final : public RunRowSink {
 public:
  /// Keeps at most `most` nodes and as many spans as `most_spans`. `machine` gives the limits of
  /// acceleration and jerk; without it their use is 0. `period` in s.
  RunHistory(double period, const Machine* machine, std::size_t most = 250'000,
             std::size_t most_spans = 1'000'000);

  void take(const RunRow& row) override;
  /// Call after the last row.
  void finish();

  double period() const noexcept { return period_; }
  const std::vector<HistoryNode>& nodes() const noexcept { return nodes_; }
  const std::vector<LineSpan>& spans() const noexcept { return spans_; }

  /// Returns how far a row may be from the motion between the nodes, which is uniform: mm along
  /// each axis, and mm/s.
  double position_error() const noexcept;
  double speed_error() const noexcept;

  /// Whether any row knew of it.
  bool knows(float HistoryNode::*value) const noexcept;
};

}  // namespace softcnc::runtime
