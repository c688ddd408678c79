// SPDX-License-Identifier: MIT
// A configuration of LinuxCNC (.ini), with the tool table and the parameters that it names.
#pragma once

#include <string>
#include <string_view>

#include "hal/import/machine_draft.hpp"

namespace softcnc::hal {

/// Takes over a configuration, by LinuxCNC's manual, "INI Configuration": name, units, velocities,
/// accelerations, limits and scales of the axes X, Y and Z with their joints, limits of the path,
/// spindle, periods, times of step lines, tool table, parameters, and folders of subprograms, which
/// count from `target_folder` in the machine file. Of an axis and its joints the narrowest limit
/// counts. Errors: SC7034, SC7035.
void take_configuration(std::string_view text, const std::string& file,
                        const std::string& target_folder, MachineDraft& draft);

}  // namespace softcnc::hal
