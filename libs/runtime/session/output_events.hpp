// SPDX-License-Identifier: MIT
// The outputs that a program has set, at the end of its run.
#pragma once

#include "motion/model/machine.hpp"
#include "runtime/figures/time_sheet.hpp"

namespace softcnc::runtime {

/// Names the files of the events, and reports once if the backend moves a machine whose outputs it
/// does not set: SC5050. A parallel port sets those that have a pin, rows for HAL those
/// that it streams; the simulated mill has none.
void settle_outputs(TimeSheet& sheet, const Machine& machine, Diagnostics& diagnostics);

}  // namespace softcnc::runtime
