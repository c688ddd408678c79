// SPDX-License-Identifier: MIT
// Rows of a run by the batch: where they come from, and where they are kept until they have been
// looked at.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/realtime/setpoint_queue.hpp"
#include "runtime/session/channel.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::runtime {

/// A Recorder that keeps the rows of a batch, with what the backend says of them: its values, and
/// where the axes were.
class RowBuffer {
 public:
  RowBuffer(const hal::Backend& backend, std::size_t rows)
      : backend_(backend),
        columns_(row_columns(backend).size()),
        rows_(rows),
        pulses_(rows),
        fine_(rows),
        values_(rows * columns_),
        actual_(rows) {}

  void clear() noexcept { used_ = 0; }

  void record(const Setpoint& setpoint, const Feedback&) noexcept {
    backend_.values(values(used_).first(backend_.columns().size()));
    add(setpoint, backend_.actual());
  }
  void add(const SetpointQueue::Row& row) noexcept {
    std::copy(row.values.begin(), row.values.end(), values(used_).begin());
    add(row.setpoint, row.actual);
  }

  std::span<const Setpoint> rows() const noexcept { return std::span(rows_).first(used_); }
  std::span<double> values(std::size_t row) noexcept {
    return std::span(values_).subspan(row * columns_, columns_);
  }
  std::span<const AxisVector> actual(std::size_t row) const noexcept { return actual_[row]; }

 private:
  /// Pulses and fine points of the setpoint stand only until the next one is made.
  void add(const Setpoint& setpoint, std::span<const AxisVector> actual) noexcept {
    actual_[used_].assign(actual.begin(), actual.end());
    Setpoint& row = rows_[used_] = setpoint;
    pulses_[used_].assign(setpoint.pulses.begin(), setpoint.pulses.end());
    row.pulses = pulses_[used_];
    fine_[used_].assign(setpoint.fine.begin(), setpoint.fine.end());
    row.fine = fine_[used_];
    ++used_;
  }

  const hal::Backend& backend_;
  std::size_t columns_, used_ = 0;
  std::vector<Setpoint> rows_;
  std::vector<std::vector<TimedStep>> pulses_;
  std::vector<std::vector<FinePoint>> fine_;
  std::vector<double> values_;
  std::vector<std::vector<AxisVector>> actual_;
};

/// A Source that ends with the batch, before the program waits or is to be planned again, or where
/// rows need not be looked at and no difference feels those before any more.
class Batch {
 public:
  Batch(Channel& channel, std::size_t rows, bool skims) noexcept
      : channel_(channel), left_(rows), skims_(skims) {}

  std::optional<Setpoint> step(const Panel& panel) noexcept {
    ends_early_ = left_ > 0 && (channel_.request_due() || channel_.pause_ahead());
    if (left_ == 0 || ends_early_) return std::nullopt;
    if (skims_ && !quiet_ && left_ >= kFelt && channel_.quiet_ahead().rows >= kFewQuiet) {
      quiet_ = true;
      left_ = kFelt;
    }
    --left_;
    auto next = channel_.step(panel);
    ends_early_ = !next;
    at_end_ = !next && !channel_.waiting();
    return next;
  }

  /// Nothing follows the batch.
  bool at_end() const noexcept { return at_end_; }
  /// The batch has ended before all of its rows were there.
  bool ends_early() const noexcept { return ends_early_; }
  /// What follows is quiet, and no difference there feels the rows before the quiet ones.
  bool leads_into_quiet() const noexcept { return quiet_ && left_ == 0 && !at_end_; }

  static constexpr std::size_t kFelt = 3;  // rows before one that its differences depend on

 private:
  static constexpr std::int64_t kFewQuiet = 32;  // rows: fewer are not worth passing over

  Channel& channel_;
  std::size_t left_;
  bool skims_, quiet_ = false, at_end_ = false, ends_early_ = false;
};

}  // namespace softcnc::runtime
