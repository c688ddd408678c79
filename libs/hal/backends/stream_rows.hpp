// SPDX-License-Identifier: MIT
// Rows for LinuxCNC's halstreamer as text: one a servo period, counted and checksummed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/hash.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// A digital output of the machine that rows carry.
struct StreamedOutput {
  int number;
  std::string name;
};

/// A row: the position of every axis in mm, then whether the program runs (1; 0 at rest in its last
/// row and before it waits for somebody), then the number of the row, from 1. For streamer that is
/// cfg=fffbu. With backend.hal-stream.outputs there follow the speed of the spindle in rpm
/// (negative: counterclockwise), mist, flood, and the digital outputs by their number:
/// cfg=fffbufbb, and a b for each. Lines that begin with '#' are comments.
class StreamRows {
 public:
  /// Makes the rows; `lead` is how many bytes are reserved at once.
  StreamRows(const Machine& machine, std::size_t lead);

  std::string head() const;
  /// Returns the comment after the last row.
  std::string tail() const;

  /// Adds the rows that lead to a setpoint. Realtime, as long as memory is reserved.
  void add(const Setpoint& setpoint) noexcept;
  /// Signals to HAL that no more rows come for a while.
  void rest() noexcept;
  /// Adds the last row: at rest, with spindle, coolant and outputs off.
  void end() noexcept {
    outputs_ = {};
    rest();
  }

  /// Returns the rows that wait to be passed on; pass() forgets and counts them.
  std::string_view bytes() const noexcept { return bytes_; }
  void pass() noexcept;

  bool started() const noexcept { return started_; }
  const AxisVector& last() const noexcept { return last_.position; }  // mm, commanded
  std::int64_t rows() const noexcept { return rows_; }
  std::string checksum() const { return hasher_.hex(); }  // of what has been passed

 private:
  void row(const AxisVector& position, bool runs) noexcept;
  char* write_outputs(char* end) const noexcept;

  std::string period_, config_;
  std::vector<int> axes_;
  std::vector<StreamedOutput> digital_;
  bool streams_outputs_;
  Outputs outputs_;  // of the next row
  int parts_;        // servo periods in a period
  bool started_ = false;
  FinePoint last_;
  std::int64_t rows_ = 0;
  std::string bytes_;
  Hasher hasher_;
};

/// The pins of a row as streamer's cfg names them: "fffbu".
std::string stream_config(const Machine& machine);

}  // namespace softcnc::hal
