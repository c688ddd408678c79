// SPDX-License-Identifier: MIT
// The grid that a surface is cut from: what the machine file says of the stock, and the program.
#pragma once

#include "cutting/cutting.hpp"
#include "surface/workpiece.hpp"

namespace softcnc::app {

/// Where the stock is not told, it reaches as far as the program cuts and the tool radius around
/// that; below it ends with the lowest tip. Errors: SC2382 (no stock there), SC7050.
Result<surface::StockGrid> stock_grid(const Stock& stock, const Cutting& cutting);

/// Points along a side of the regions by which Rmax is told: the larger of pick-feed and feed per
/// tooth, or half a millimetre where no pick-feed is told.
int region_side(const Cutting& cutting, double step);

}  // namespace softcnc::app
