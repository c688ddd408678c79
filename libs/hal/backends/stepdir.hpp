// SPDX-License-Identifier: MIT
// The backend of drives with step and direction inputs: a timed list of edges.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/signals/commands.hpp"
#include "hal/signals/edge_sink.hpp"
#include "hal/signals/pulse_source.hpp"

namespace softcnc::hal {

/// Pulses by fine interpolation of the setpoints or by a method of reference pulses, put on wires
/// as the driver allows, into a file or to a port. The axes are taken to be where they have been
/// sent; a port may have inputs.
class StepDir final : public Backend {
 public:
  /// Opens a backend that writes to a file. With an empty name, pulses are counted and not kept.
  /// Errors: those of EdgeWriter::open().
  static Result<std::unique_ptr<StepDir>> open(const Machine& machine);
  /// Makes a backend that writes edges to `out`, which may be null, under the rules of `timing`.
  StepDir(const Machine& machine, const StepTiming& timing, std::unique_ptr<EdgeSink> out);

  Feedback exchange(const Setpoint& setpoint) noexcept override;
  void begin_again() noexcept override { started_ = false; }

  /// Returns, for each axis, the columns of the position sent (mm) where it is not that of the
  /// path, and of the pulses so far, as counts of that position.
  std::span<const std::string> columns() const noexcept override { return columns_; }
  void values(std::span<double> out) const noexcept override;
  AxisVector settle() const noexcept override { return position(); }
  AxisVector command_velocity_max() const noexcept override { return commands_.velocity_max(); }
  void rest(const Setpoint& at) noexcept override;
  bool has_home_switches() const noexcept override { return inputs_ && inputs_->has_homes(); }
  bool has_probe() const noexcept override { return inputs_ && inputs_->has_probe(); }
  double delay() const noexcept override { return inputs_ ? inputs_->delay() : 0; }
  void follow(double lead) noexcept override {
    if (inputs_) inputs_->follow(lead);
  }
  Feedback look() noexcept override;
  std::optional<Diagnostic> trouble() const override;
  Status recover() override;
  Status finish() override;

 private:
  void begin(const AxisVector& position);
  Alarm send(const Setpoint& sent);
  void release();
  void read_inputs(Feedback& feedback) noexcept;
  AxisVector position() const noexcept;

  Commands commands_;
  std::vector<PulseSource> motors_;
  std::vector<std::string> columns_;
  double period_;             // ns
  std::int64_t periods_ = 0;  // that have passed
  bool started_ = false;
  Alarm alarm_ = Alarm::none;             // of the last exchange
  AxisVector last_ = AxisVector::Zero();  // mm, of the path
  StepTiming timing_;
  StepEdges edges_;
  std::unique_ptr<EdgeSink> out_;
  EdgeInputs* inputs_;           // of that; may be null
  InputLevels seen_;             // the last ones
  EdgeInputs::Counts offset_{};  // from its steps to the counts of the axes
};

}  // namespace softcnc::hal
