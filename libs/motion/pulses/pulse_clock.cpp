// SPDX-License-Identifier: MIT
#include "motion/pulses/pulse_clock.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc {

bool ClockDropper::counts(Step step) const noexcept {
  if (method_ == PulseMethod::dda || !constant_feed_) return false;
  return method_ == PulseMethod::sam ? step == last_ : step.axes() > 1;
}

int ClockDropper::clocks(Step step) noexcept {
  const int enough = method_ == PulseMethod::sam ? 2 : 3;
  if (counts(step)) ++counted_;
  last_ = step;
  if (counted_ < enough) return 1;
  counted_ = 0;
  return 2;
}

/// From rest to the frequency f along n clocks at constant acceleration: clock i comes at
/// (2 / f) sqrt(n i).
double ClockRamp::delay(std::int64_t clock) const noexcept {
  const auto from_rest = static_cast<double>(std::min(clock, clocks_ - 1 - clock));
  const auto ramp = static_cast<double>(ramp_);
  if (from_rest >= ramp) return period_;
  return 2.0 * period_ * std::sqrt(ramp) / (std::sqrt(from_rest + 1.0) + std::sqrt(from_rest));
}

}  // namespace softcnc
