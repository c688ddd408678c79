// SPDX-License-Identifier: MIT
// The simulated mill: a servo axis for each axis of the machine.
#pragma once

#include <string>
#include <vector>

#include "hal/backend.hpp"
#include "hal/servo.hpp"

namespace softcnc::hal {

class SimulatedMill final : public Backend {
 public:
  explicit SimulatedMill(const Machine& machine);

  Feedback exchange(const Setpoint& setpoint) noexcept override;

  /// For each axis: actual position (mm), command minus actual (um), motor current (A).
  std::span<const std::string> columns() const noexcept override { return columns_; }
  void values(std::span<double> out) const noexcept override;
  std::array<double, kAxes> following_error_max() const noexcept override { return error_max_; }

  /// Runs a copy on until no encoder moves any more, for kSettleTime at most.
  AxisVector settle() const noexcept override;
  static constexpr double kSettleTime = 10.0;  // s

 private:
  void run_period(const AxisVector& target) noexcept;

  struct Slide {
    int axis;
    ServoAxis servo;
  };
  std::vector<Slide> slides_;
  std::vector<std::string> columns_;
  int servo_periods_;  // in one period
  double servo_period_;
  bool started_ = false;
  AxisVector commanded_ = AxisVector::Zero();
  std::array<double, kAxes> error_max_;
};

}  // namespace softcnc::hal
