// SPDX-License-Identifier: MIT
// Keys of other controls, and what softcnc has in their place.
#pragma once

#include <string>
#include <string_view>

#include "hal/machine/machine_value.hpp"

namespace softcnc::hal {

/// Returns in words what takes the place of an unknown key that grbl, FluidNC, Marlin, Mach3 or
/// LinuxCNC have, with its value converted where that is a number: "80 steps per mm are
/// axis.x.blu_um = 12.5". Empty for any other key. `path` is a full name, as "axis.x.steps_per_mm";
/// its last part decides, and an axis letter among the others.
std::string counterpart_of(std::string_view path, const FileValue& value);

}  // namespace softcnc::hal
