// SPDX-License-Identifier: MIT
// What a surface is like, as JSON, and its worst place in words.
#pragma once

#include <string>

#include "performance.hpp"
#include "roughness_map.hpp"

namespace softcnc::app {

/// Keys and units: docs/surface.md.
std::string surface_report(Job& job, const RoughnessMap& map, const hal::StockGrid& grid);

/// Of SC4040. Expects that a region misses its target.
std::string missed_text(const TargetFigures& target, const RoughnessMap& map,
                        const hal::StockGrid& grid);

}  // namespace softcnc::app
