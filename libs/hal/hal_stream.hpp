// SPDX-License-Identifier: MIT
// The backend of machines behind LinuxCNC's HAL: rows for halstreamer, one a servo period.
#pragma once

#include <string>
#include <vector>

#include "hal/backend.hpp"
#include "hal/output_file.hpp"

namespace softcnc::hal {

/// A row: the position of every axis in mm, then whether the program runs (1; 0 at rest in its last
/// row and before it waits for somebody), then the number of the row, from 1. For streamer that is
/// cfg=fffbu. Lines that begin with '#' are comments.
class HalRows final : public Backend {
 public:
  /// An empty file name: rows are counted and not kept. Errors: SC6011, SC6070.
  static Result<std::unique_ptr<HalRows>> open(const Machine& machine);

  Feedback exchange(const Setpoint& setpoint) noexcept override;
  AxisVector settle() const noexcept override { return last_; }
  void rest() noexcept override;
  Status finish() override;
  std::optional<Tally> tally() const override;

 private:
  HalRows(const Machine& machine, std::unique_ptr<ByteSink> out);

  void row(const AxisVector& position, bool runs) noexcept;
  void hand_on() noexcept;

  std::vector<int> axes_;
  int parts_;  // servo periods in a period
  bool started_ = false;
  AxisVector last_ = AxisVector::Zero();  // mm, commanded
  std::int64_t rows_ = 0;
  std::string bytes_;
  std::size_t enough_;  // bytes to hand on at once
  Hasher hasher_;
  std::unique_ptr<ByteSink> out_;  // may be null
  Status status_;
};

/// The pins of a row as streamer's cfg names them: "fffbu".
std::string stream_config(const Machine& machine);

}  // namespace softcnc::hal
