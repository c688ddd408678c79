// SPDX-License-Identifier: MIT
// The simulated mill: a servo axis and a screw for each axis of the machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/backends/home_switches.hpp"
#include "hal/backends/lag_monitor.hpp"
#include "hal/backends/lead_screw.hpp"
#include "hal/backends/servo.hpp"
#include "hal/backends/simulated_touch.hpp"
#include "hal/signals/commands.hpp"
#include "hal/signals/pulse_source.hpp"

namespace softcnc::hal {

/// Its up/down counters count the very pulses that a drive with step and direction inputs would
/// get. The axes are those of the machine, or of its plant if it has one. Their loop is closed at
/// the motor, so it does not see what the screw makes of it; the position of an axis is its
/// table's.
class SimulatedMill final : public Backend {
 public:
  explicit SimulatedMill(const Machine& machine);

  Feedback exchange(const Setpoint& setpoint) noexcept override;
  void begin_again() noexcept override {
    started_ = false;
    switches_.begin_again();
  }
  bool has_home_switches() const noexcept override { return true; }
  bool has_probe() const noexcept override { return touch_.has_bodies(); }
  void touch_with(const ProbeTip& tip) override { touch_.begin(tip); }
  Feedback look() noexcept override { return seen_inputs_; }

  /// Returns, for each axis, the columns of the position sent (mm) where it is not that of the
  /// path, actual position (mm), path minus actual (um) and motor current (A).
  std::span<const std::string> columns() const noexcept override { return columns_; }
  void values(std::span<double> out) const noexcept override;
  std::span<const AxisVector> actual() const noexcept override {
    return std::span(actual_).last(seen_);
  }
  std::size_t instants() const noexcept override { return actual_.size(); }
  std::array<double, kAxes> following_error_max() const noexcept override { return error_max_; }

  std::array<double, kAxes> lag_misfit() const noexcept override;

  /// Returns where a copy that runs on comes to rest: until no encoder moves any more, for at most
  /// kSettleTime.
  AxisVector settle() const noexcept override;
  static constexpr double kSettleTime = 10.0;  // s

  AxisVector command_velocity_max() const noexcept override { return commands_.velocity_max(); }

 private:
  struct Slide {
    int axis;
    ServoAxis servo;
    LeadScrew screw;
    PulseSource source;
    std::optional<LagMonitor> monitor;  // of a plant
  };

  void begin(const Setpoint& sent) noexcept;
  void run_period(Slide& slide, const Setpoint& sent) noexcept;

  static constexpr std::size_t kPulses = 4096;  // in a period without a further allocation

  Commands commands_;
  std::vector<Slide> slides_;
  HomeSwitches switches_;  // of the tables
  SimulatedTouch touch_;
  Feedback seen_inputs_;  // the last feedback, without its alarm
  std::vector<std::string> columns_;
  double servo_period_;  // s: of the position loop
  int servo_periods_;    // in one period
  bool started_ = false;
  std::vector<CommandPulse> pulses_;           // of one axis and period
  AxisVector commanded_ = AxisVector::Zero();  // mm: of the path
  std::vector<AxisVector> actual_;             // of each servo period
  std::size_t seen_ = 0;  // so many of them, the last ones, are of the last exchange
  std::array<double, kAxes> error_max_;
};

}  // namespace softcnc::hal
