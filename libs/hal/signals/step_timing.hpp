// SPDX-License-Identifier: MIT
// The timing that the driver of a motor requires on its step and direction lines.
#pragma once

#include <cstdint>

#include "motion/model/machine.hpp"

namespace softcnc::hal {

/// The timing that a driver requires, ns. A step is a rising edge of the step line; the direction
/// line is high for steps in negative direction.
struct StepTiming {
  std::int64_t length = 0;    // the step line stays high
  std::int64_t space = 0;     // and low
  std::int64_t interval = 0;  // from rising edge to rising edge: one over the largest rate, or more
  std::int64_t setup = 0;     // from an edge of the direction line to a step
  std::int64_t hold = 0;      // from the end of a step to an edge of the direction line
};

/// Returns the timing of the machine's driver in whole ns, never rounded down.
StepTiming step_timing(const StepPort& port) noexcept;

}  // namespace softcnc::hal
