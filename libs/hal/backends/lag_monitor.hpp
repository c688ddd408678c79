// SPDX-License-Identifier: MIT
// Whether an axis lags as the machine file says.
#pragma once

#include <limits>
#include <span>

#include "hal/backends/servo.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// Runs the axis that softcnc knows beside another one, with the same command pulses, and compares
/// where they are: a difference that goes with the speed is one of the lag, 1/Kv.
class LagMonitor {
 public:
  LagMonitor(const Axis& known, double loop_period)
      : known_(known, loop_period), kv_(known.drive.kv), loop_period_(loop_period) {}

  /// Begins at rest at `position`, mm. Realtime.
  void begin(double position) noexcept {
    known_.reset(position);
    products_ = squares_ = 0;
  }

  /// Runs one servo period with these command pulses, after which the other axis is at `actual`,
  /// mm. Realtime.
  void advance(std::span<const CommandPulse> pulses, double actual) noexcept {
    known_.advance(pulses);
    const double v = known_.velocity();
    products_ += (known_.position() - actual) * v * loop_period_;
    squares_ += v * v * loop_period_;
  }

  /// Returns by which part of 1/Kv the other axis lags more than the known one, by least squares
  /// over all periods; NaN before the axis has moved far enough to tell.
  double misfit() const noexcept {
    constexpr double kEnough = 1000;  // mm^2/s: a second at 32 mm/s
    return squares_ < kEnough ? std::numeric_limits<double>::quiet_NaN()
                              : kv_ * products_ / squares_;
  }

 private:
  ServoAxis known_;
  double kv_, loop_period_;
  double products_ = 0, squares_ = 0;  // mm^2, mm^2/s
};

}  // namespace softcnc::hal
