// SPDX-License-Identifier: MIT
// The backend of machines on LinuxCNC's HAL: rows for halstreamer, one per servo period.
#pragma once

#include <memory>

#include "hal/backends/backend.hpp"
#include "hal/backends/stream_rows.hpp"
#include "hal/files/output_file.hpp"

namespace softcnc::hal {

class HalRows final : public Backend {
 public:
  /// An empty file name: rows are counted and not kept. Errors: SC6011, SC6070.
  static Result<std::unique_ptr<HalRows>> open(const Machine& machine);

  Feedback exchange(const Setpoint& setpoint) noexcept override;
  AxisVector settle() const noexcept override { return rows_.last(); }
  void rest() noexcept override;
  Status finish() override;
  std::optional<Tally> tally() const override;

 private:
  HalRows(const Machine& machine, std::unique_ptr<ByteSink> out);

  void hand_on() noexcept;

  StreamRows rows_;
  std::size_t enough_;             // bytes to hand on at once
  std::unique_ptr<ByteSink> out_;  // may be null
  Status status_;
};

}  // namespace softcnc::hal
