// SPDX-License-Identifier: MIT
// The rows of a run as the track of its tool.
#pragma once

#include <array>

#include "runtime/cutting/cutting.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc::runtime {

class CuttingRows final : public RowSink {
 public:
  /// Makes the rows. `columns` are those of the backend: the tool is where it was measured, if any
  /// are measured; otherwise where it is commanded to be. `period` is in s.
  CuttingRows(const Cutting& cutting, SpindlePhase phase, double period,
              std::span<const std::string> columns);

  bool row(const Setpoint& setpoint, std::span<const double> backend_values) override;

  /// Returns the track of the tool. To be called after the last row. Errors: SC6003.
  Result<surface::ToolTrack> finish();

 private:
  void change_until(const Setpoint& setpoint);

  const Cutting& cutting_;
  SpindlePhase phase_;
  double period_;
  std::array<int, kAxes> measured_{};  // column by axis; -1: none
  std::size_t next_ = 0;               // of the changes
  CuttingChange now_;
  surface::ToolTrack track_;
};

}  // namespace softcnc::runtime
