// SPDX-License-Identifier: MIT
// A driver's timing in the base periods of a port that is written to by a program.
#pragma once

#include "hal/signals/step_timing.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::hal {

struct PortTiming {
  std::int64_t base;      // ns: between two writes
  StepTiming rules;       // ns, in whole base periods, at least one each
  std::int64_t shortest;  // ns: as close may two writes come without breaking a rule of the driver
};

PortTiming port_timing(const Machine& machine) noexcept;

}  // namespace softcnc::hal
