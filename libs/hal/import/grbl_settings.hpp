// SPDX-License-Identifier: MIT
// Settings of grbl, as it lists them after `$$`.
#pragma once

#include <string>
#include <string_view>

#include "hal/import/machine_draft.hpp"

namespace softcnc::hal {

/// Takes over settings of grbl 0.9 to 1.1, grblHAL or FluidNC, as grbl's page "Settings" describes
/// them, with descriptions after the values or without: $0 (step length), $11 (as the corner
/// tolerance), $12 (as the chord tolerance), $20 (see below), $30 and $31 (spindle), $100 to $102
/// (steps/mm), $110 to $112 (mm/min), $120 to $122 (mm/s^2), $130 to $132 (travel). With soft
/// limits
/// ($20=1) the travel lies below machine zero, as grbl has it; without them machine zero may be
/// anywhere in it. Of a setting that is given twice the last counts (SC7036). Errors: SC7034 (a
/// line that grbl does not send), SC7035 (no number, or one that cannot be).
void take_grbl_settings(std::string_view text, const std::string& file, MachineDraft& draft);

/// Returns whether a text has settings of grbl.
bool is_grbl_settings(std::string_view text);

}  // namespace softcnc::hal
