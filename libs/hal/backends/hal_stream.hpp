// SPDX-License-Identifier: MIT
// The backend of machines on LinuxCNC's HAL: rows for halstreamer, one per servo period.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/backends/stream_rows.hpp"
#include "hal/files/output_file.hpp"
#include "hal/signals/commands.hpp"

namespace softcnc::hal {

class HalRows final : public Backend {
 public:
  /// An empty file name: rows are counted and not kept. Errors: SC6011, SC6070.
  static Result<std::unique_ptr<HalRows>> open(const Machine& machine);

  Feedback exchange(const Setpoint& setpoint) noexcept override;
  /// Returns, for each axis, the column of the position sent (mm) where it is not that of the path.
  std::span<const std::string> columns() const noexcept override { return columns_; }
  void values(std::span<double> out) const noexcept override;
  AxisVector settle() const noexcept override { return position(); }
  AxisVector command_velocity_max() const noexcept override { return commands_.velocity_max(); }
  void rest(const Setpoint& at) noexcept override;
  Status finish() override;
  std::optional<Tally> tally() const override;

 private:
  HalRows(const Machine& machine, std::unique_ptr<ByteSink> out);

  AxisVector position() const noexcept;
  void send(const Setpoint& sent) noexcept;
  void hand_on() noexcept;

  Commands commands_;
  std::vector<int> axes_;
  std::vector<std::string> columns_;
  StreamRows rows_;
  std::size_t enough_;             // bytes to hand on at once
  std::unique_ptr<ByteSink> out_;  // may be null
  Status status_;
};

}  // namespace softcnc::hal
