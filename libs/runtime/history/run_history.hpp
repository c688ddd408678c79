// SPDX-License-Identifier: MIT
// The history of a run in bounded memory: its rows thinned out where little changes, and which line
// was executed when.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "motion/model/machine.hpp"
#include "runtime/history/history_node.hpp"
#include "runtime/history/node_thinning.hpp"

namespace softcnc::runtime {

/// The motion after period `period` belongs to a line, up to the next span.
struct LineSpan {
  std::int64_t period = 0;
  int file = 0, line = 0;
};

class RunHistory final : public RunRowSink {
 public:
  /// How much is kept of a run.
  struct Size {
    std::size_t nodes = 250'000, spans = 1'000'000;  // at most; at least 16
  };

  /// `machine` gives the limits of acceleration and jerk; without it their use is 0. `period` in s.
  RunHistory(double period, const Machine* machine, Size size);
  RunHistory(double period, const Machine* machine) : RunHistory(period, machine, Size()) {}
  RunHistory(const RunHistory&) = delete;
  RunHistory& operator=(const RunHistory&) = delete;

  void take(const RunRow& row) override;
  /// Call after the last row.
  void finish() { thinning_->finish(); }

  double period() const noexcept { return period_; }
  /// Sets the period, s, of rows that stated it only at their end.
  void set_period(double period) noexcept { period_ = period; }
  const std::vector<HistoryNode>& nodes() const noexcept { return nodes_; }
  const std::vector<LineSpan>& spans() const noexcept { return spans_; }

  /// Returns how far a row may be from the motion between the nodes, which is uniform: mm along
  /// each axis.
  double position_error() const noexcept { return error_ * kPosition; }
  /// Returns the same of the speed, mm/s.
  double speed_error() const noexcept { return error_ * (kSpeedPart + kSpeedOfAll) * fastest_; }
  /// Returns the shortest span that is kept where there are too many of them, in periods.
  std::int64_t span_error() const noexcept { return shortest_span_ - 1; }

  /// Returns whether any row knew of a value.
  bool knows(float HistoryNode::*value) const noexcept;

 private:
  static constexpr double kPosition = 5e-4;    // mm
  static constexpr double kSpeedPart = 5e-3;   // of the speed
  static constexpr double kSpeedOfAll = 2e-3;  // of the largest speed so far
  static constexpr int kLimitLevels = 1, kMotionLevels = 6;

  Thinning thinning(double factor) const noexcept;
  void use_axes(const RunRow& row, HistoryNode& node) noexcept;
  void add_span(const RunRow& row);
  void thin_nodes();
  void thin_spans();

  double period_;
  Size size_;
  AxisVector acceleration_ = AxisVector::Zero(), jerk_ = AxisVector::Zero();  // limits; 0: none
  std::array<AxisVector, 3> last_{};  // positions, newest first
  std::int64_t rows_ = 0, last_period_ = 0;
  std::vector<HistoryNode> nodes_;
  std::unique_ptr<NodeThinning> thinning_;
  std::vector<LineSpan> spans_;
  double fastest_ = 0;              // mm/s
  double factor_ = 1, error_ = 1;   // of the tolerances: the present one, and all so far
  int level_ = 0;                   // how often the nodes have been thinned out
  std::int64_t shortest_span_ = 1;  // periods
};

}  // namespace softcnc::runtime
