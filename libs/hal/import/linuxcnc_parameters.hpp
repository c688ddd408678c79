// SPDX-License-Identifier: MIT
// LinuxCNC's parameter files (.var).
#pragma once

#include <string>
#include <string_view>

#include "hal/import/machine_draft.hpp"

namespace softcnc::hal {

/// Takes over a parameter file, as LinuxCNC's manual describes it ("Parameters", persistent ones):
/// lines of a number and a value. Into the state go #5161 to #5163 (G28), #5181 to #5183 (G30),
/// #5210 to #5213 (G92), #5220 (the work system in force), #5221 to #5390 (origins and rotations
/// of the work systems), and those from #31 to #4999 that are not 0. A unit has `mm_per_unit` mm.
/// Errors: SC7034, SC7035.
void take_parameters(std::string_view text, const std::string& file, double mm_per_unit,
                     MachineDraft& draft);

}  // namespace softcnc::hal
