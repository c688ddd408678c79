// SPDX-License-Identifier: MIT
#include "hal/signals/step_timing.hpp"

#include "motion/model/step_rate.hpp"

namespace softcnc::hal {

StepTiming step_timing(const StepPort& port) noexcept {
  return {least_ns(port.step_length), least_ns(port.step_space), step_interval(port),
          least_ns(port.direction_setup), least_ns(port.direction_hold)};
}

}  // namespace softcnc::hal
