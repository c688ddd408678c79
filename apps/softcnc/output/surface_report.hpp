// SPDX-License-Identifier: MIT
// What a surface is like, as JSON, and its worst place in words.
#pragma once

#include <string>

#include "job/job.hpp"
#include "surface/roughness_map.hpp"

namespace softcnc::app {

/// Keys and units: docs/surface.md.
std::string surface_report(Job& job, const surface::RoughnessMap& map,
                           const surface::StockGrid& grid);

/// Of SC4040. Expects that a region misses its target.
std::string missed_text(const surface::TargetFigures& target, const surface::RoughnessMap& map,
                        const surface::StockGrid& grid);

}  // namespace softcnc::app
