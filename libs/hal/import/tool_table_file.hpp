// SPDX-License-Identifier: MIT
// LinuxCNC's tool tables (.tbl).
#pragma once

#include <string>
#include <string_view>

#include "hal/import/machine_draft.hpp"

namespace softcnc::hal {

/// Takes over a tool table, as LinuxCNC's manual describes it ("Tool Table Format"): a line for
/// each tool, in any order T (its number), P (its pocket), D (diameter) and offsets X to W, I J Q
/// of lathes, and a comment after ';'. D becomes tool.N.radius_mm, and X Y Z lengths in the state.
/// A unit has `mm_per_unit` mm. Errors: SC7034, SC7035; SC7036 where a tool is given twice: the
/// first counts, as there.
void take_tool_table(std::string_view text, const std::string& file, double mm_per_unit,
                     MachineDraft& draft);

/// Returns whether a text begins like a tool table.
bool is_tool_table(std::string_view text);

}  // namespace softcnc::hal
