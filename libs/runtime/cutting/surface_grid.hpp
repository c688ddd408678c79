// SPDX-License-Identifier: MIT
// The grid of a surface: from the stock in the machine file, and from the program.
#pragma once

#include "runtime/cutting/cutting.hpp"
#include "surface/workpiece.hpp"

namespace softcnc::runtime {

/// Returns the grid. A stock that is not stated extends as far as the program cuts and the tool
/// radius around that; its lower end is the lowest tip. Errors: SC2382 (no stock there), SC7050.
Result<surface::StockGrid> stock_grid(const Stock& stock, const Cutting& cutting);

/// Returns the points along a side of the regions of Rmax: the larger of pick-feed and feed per
/// tooth, or half a millimetre where no pick-feed is stated.
int region_side(const Cutting& cutting, double step);

}  // namespace softcnc::runtime
