// SPDX-License-Identifier: MIT
// A machine with its operator, moved by the clock, and the state file that follows it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "hal/backends/backend.hpp"
#include "messages/messages.hpp"
#include "motion/core/result.hpp"
#include "runtime/operator/operator.hpp"
#include "runtime/sinks/trace_rows.hpp"
#include "settings/machine_memory.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// Returns the time since it was asked for first in this process, s.
double session_time();

/// Rows for a trace. Where that cannot be written any more the machine goes on.
class LastingRows final : public runtime::RowSink {
 public:
  explicit LastingRows(runtime::TraceRows rows) : rows_(std::move(rows)) {}
  bool row(const Setpoint& setpoint, std::span<const double> values) override {
    if (rows_.ok()) rows_.row(setpoint, values);
    return true;
  }
  void rest(const Setpoint& at) override { rows_.rest(at); }
  void flush() override { rows_.flush(); }
  bool ok() const noexcept { return rows_.ok(); }
  Status finish() { return rows_.finish(); }

 private:
  runtime::TraceRows rows_;
};

class AttendedMachine {
 public:
  /// Opens the machine of the options, its backend, its state and its trace. `report` takes what is
  /// wrong with lines and programs later on. Errors: those of choose_machine(), open_state(),
  /// MachineMemory::open(), hal::open_backend() and hal::TraceWriter::open(); SC7072.
  static Result<std::unique_ptr<AttendedMachine>> open(const Options& options, Messages& messages,
                                                       Diagnostics::Sink report);

  const Machine& machine() const noexcept { return machine_; }
  runtime::Operator& control() noexcept { return *control_; }
  const runtime::Operator& control() const noexcept { return *control_; }

  /// Returns the options with which programs are checked: those of the control, and its present
  /// state.
  runtime::ChannelOptions checking_options() const;

  /// Moves on to the instant `now`, s, of a clock that is never set back: a period for each that
  /// has passed. What comes later than kMostLate is not made up for. The state file is marked
  /// before motion begins, and written once the machine rests; where it cannot be marked, nothing
  /// moves. Errors, each once: SC6011, SC6012, those of the trace among them.
  Status advance(double now);
  /// Something of the state has changed without motion.
  void note_change() noexcept { is_kept_ = false; }
  /// Returns how long the present program has run, without holds and moves by hand, s.
  double program_time() const noexcept {
    return static_cast<double>(program_rows_) * machine_.control.period;
  }

  /// Writes the state, and what is left of trace and backend. Errors: theirs.
  Status finish();

 private:
  static constexpr double kMostLate = 0.1;  // s

  AttendedMachine(Machine machine, MachineMemory memory) noexcept
      : machine_(std::move(machine)), memory_(std::move(memory)) {}
  void settle_place(bool confirmed);
  Status mark_motion();
  Status keep_state();

  Machine machine_;
  runtime::ChannelOptions options_;
  MachineMemory memory_;
  std::unique_ptr<hal::Backend> backend_;
  std::unique_ptr<LastingRows> rows_;
  std::optional<runtime::Operator> control_;  // the last: it uses all others
  std::optional<double> next_;                // s: when the next period begins
  bool is_kept_ = true;                       // the state file has the present state
  bool is_marked_ = false;                    // or the mark of motion
  bool is_assumed_ = false;  // the place, and nothing has moved: the file may stay without a mark
  bool lost_rows_ = false;   // of the trace
  std::int64_t program_rows_ = 0;
};

}  // namespace softcnc::app
