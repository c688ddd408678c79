// SPDX-License-Identifier: MIT
#include "report/surface_json.hpp"

#include <nlohmann/json.hpp>

namespace softcnc::app {
namespace {

constexpr double kHeight = 1e-4;  // mm: steps of heights
constexpr double kRmax = 0.01;    // um

}  // namespace

nlohmann::ordered_json surface_json(const ReportedSurface& surface, PackedData& data) {
  const auto column = [&](const std::vector<float>& values, double scale, Order order) {
    return data.add_column(values.size(), scale, order, [&](std::size_t i) { return values[i]; });
  };
  const surface::RegionFigures rough = surface::figures(surface.rmax);
  const auto& corner = surface.grid.corner;
  return {{"step_mm", surface.grid.step},
          {"columns", surface.columns},
          {"rows", surface.rows},
          {"origin_mm", {corner[0], corner[1], corner[2]}},
          {"heights", column(surface.heights, kHeight, Order::differences)},
          {"heights_step", surface.every},
          {"region_mm", surface.region},
          {"region_columns", surface.region_columns},
          {"region_rows", surface.region_rows},
          {"rmax_um", column(surface.rmax, kRmax, Order::values)},
          {"target_um", column(surface.targets, kRmax, Order::values)},
          {"regions_judged", surface.judged.judged},
          {"regions_missed", surface.judged.missed},
          {"rmax_max_um", rough.largest},
          {"rmax_mean_um", rough.mean}};
}

}  // namespace softcnc::app
