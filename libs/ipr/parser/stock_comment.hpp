// SPDX-License-Identifier: MIT
// LinuxCNC's comment (WORKPIECE,BOX,XMIN=...): the stock that a program is cut from.
#pragma once

#include <string_view>

#include "motion/core/result.hpp"
#include "motion/model/stock_outline.hpp"

namespace softcnc::ipr {

/// Returns whether a comment, without its parentheses, states a stock, well or badly: it has a key.
bool states_stock(std::string_view comment) noexcept;

/// Returns the outline in programmed coordinates, mm. `mm_per_unit` counts where the comment names
/// no UNITS. Keys that are not known count nothing, as in LinuxCNC. Errors: SC2388, without a
/// place.
Result<StockOutline> read_stock(std::string_view comment, double mm_per_unit);

}  // namespace softcnc::ipr
