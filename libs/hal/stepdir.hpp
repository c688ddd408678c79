// SPDX-License-Identifier: MIT
// The backend of drives with step and direction inputs: a timed list of edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/backend.hpp"
#include "hal/edge_file.hpp"
#include "hal/pulse_source.hpp"

namespace softcnc::hal {

/// Pulses by fine interpolation of the setpoints or by a method of reference pulses, put on wires
/// as the driver allows, into a file. The file is the machine: where the axes are is what has been
/// sent to them.
class StepDir final : public Backend {
 public:
  /// An empty file name: pulses are counted and not kept. Errors: those of EdgeWriter::open().
  static Result<std::unique_ptr<StepDir>> open(const Machine& machine);

  Feedback exchange(const Setpoint& setpoint) noexcept override;

  /// For each axis the pulses so far, as counts of its position.
  std::span<const std::string> columns() const noexcept override { return columns_; }
  void values(std::span<double> out) const noexcept override;
  AxisVector settle() const noexcept override { return position(); }
  Status finish() override;

 private:
  StepDir(const Machine& machine, std::optional<EdgeWriter> file);

  void begin(const AxisVector& position);
  AxisVector position() const noexcept;
  void write(std::span<const Edge> edges) noexcept;

  std::vector<PulseSource> motors_;
  std::vector<std::string> columns_;
  double period_;             // ns
  std::int64_t periods_ = 0;  // that have passed
  bool started_ = false;
  AxisVector last_ = AxisVector::Zero();  // mm, commanded
  StepEdges edges_;
  std::optional<EdgeWriter> file_;
};

/// What the machine's driver asks of its lines.
StepTiming step_timing(const StepPort& port) noexcept;

}  // namespace softcnc::hal
