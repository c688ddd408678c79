// SPDX-License-Identifier: MIT
// The configuration of FluidNC, which it keeps as YAML.
#pragma once

#include <string>
#include <string_view>

#include "hal/import/machine_draft.hpp"

namespace softcnc::hal {

/// Takes over a configuration of FluidNC 3, as its wiki describes it: name, junction_deviation_mm
/// (as the corner tolerance), arc_tolerance_mm (as the chord tolerance), pulse_us, dir_delay_us,
/// the largest speed of the spindles' speed_maps, and of each axis steps_per_mm,
/// max_rate_mm_per_min, acceleration_mm_per_sec2 and max_travel_mm. The travel lies below mpos_mm,
/// or above it where the axis homes in the negative direction, as FluidNC has it; of an axis that
/// neither homes nor has soft_limits machine zero may be anywhere in it. What is empty in the file
/// is left out, and of a setting that is given twice the last counts (SC7036). Errors: SC7034 (no
/// YAML, or a kind of machine that is not Cartesian), SC7035 (no number, or one that cannot be).
void take_fluidnc_configuration(const std::string& text, const std::string& file,
                                MachineDraft& draft);

/// Returns whether a text has the axes of FluidNC at its outermost level.
bool is_fluidnc_configuration(std::string_view text);

}  // namespace softcnc::hal
