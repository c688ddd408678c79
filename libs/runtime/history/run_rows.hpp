// SPDX-License-Identifier: MIT
// The rows of a simulated run, with what the verifier and the blocks say of them.
#pragma once

#include <deque>

#include "runtime/history/run_row.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc::runtime {

class RunRows final : public RowSink, public RowObserver {
 public:
  /// Passes rows on to `sink`. `knows_contour`: the last value of the backend is the contour error.
  RunRows(RunRowSink& sink, bool knows_contour) : sink_(sink), knows_contour_(knows_contour) {}

  RowObserver* observer() override { return this; }
  void block(const ipo::TimedBlock& timed) override;
  void observe(const ObservedRow& observed) override;
  bool row(const Setpoint& setpoint, std::span<const double> backend_values) override;

 private:
  /// What holds from a block on.
  struct Change {
    int block = 0, file = 0, tool = 0;
    MotionKind motion = MotionKind::rest;
  };

  void add_change(const SourcePos& source, int number, MotionKind motion);
  void change_until(int block);

  RunRowSink& sink_;
  bool knows_contour_;
  int tool_ = 0;
  std::deque<Change> changes_;  // that lie ahead
  Change present_;
  std::deque<RunRow> observed_;  // that have not been taken yet
};

}  // namespace softcnc::runtime
