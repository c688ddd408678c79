// SPDX-License-Identifier: MIT
// What was identified of the axes of a machine, for a person or as JSON.
#pragma once

#include <string>
#include <vector>

#include "motion/model/machine.hpp"
#include "runtime/identification/axis_fit.hpp"

namespace softcnc::app {

struct IdentifiedAxis {
  int axis;
  Axis described;                    // as the machine file has it,
  double described_backlash = 0;     // mm, its screw,
  double described_loop_period = 0;  // s, and how often its counter is read
  runtime::AxisFit fit;
};

/// Returns a table for each axis: each figure with its uncertainty, and as the machine file has it.
std::string identification_text(const std::vector<IdentifiedAxis>& axes);

/// Returns the same as one JSON document; what the motion does not determine is null.
std::string identification_json(const std::vector<IdentifiedAxis>& axes);

}  // namespace softcnc::app
