// SPDX-License-Identifier: MIT
#include "output/surface_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hal/files/hash.hpp"
#include "hal/machine/machine_file.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostListed = 1000;  // regions

/// The middle of a region, mm.
struct RegionCentre {
  double x, y;
};

RegionCentre centre_of(std::size_t region, const surface::RoughnessMap& map,
                       const surface::StockGrid& grid) {
  const auto columns = static_cast<std::size_t>(map.columns());
  const double side = map.side() * grid.step;
  return {grid.corner[0] + (static_cast<double>(region % columns) + 0.5) * side,
          grid.corner[1] + (static_cast<double>(region / columns) + 0.5) * side};
}

/// In the order of rows and columns; the first ones of many.
Json missed_regions(const surface::RoughnessMap& map, const surface::StockGrid& grid) {
  const std::vector<float> rmax = map.rmax(), targets = map.targets(), met = map.met();
  Json list = Json::array();
  for (std::size_t i = 0; i < met.size() && list.size() < kMostListed; ++i) {
    if (met[i] != 0) continue;
    const RegionCentre at = centre_of(i, map, grid);
    list.push_back(
        {{"x_mm", at.x}, {"y_mm", at.y}, {"rmax_um", rmax[i]}, {"rmax_target_um", targets[i]}});
  }
  return list;
}

}  // namespace

std::string surface_report(Job& job, const surface::RoughnessMap& map,
                           const surface::StockGrid& grid) {
  const surface::RegionFigures rough = surface::figures(map.rmax()),
                               gouges = surface::figures(map.gouges());
  const surface::TargetFigures target = target_figures(map);
  Json report;
  report["program"] = job.program.name();
  report["program_hash"] = job.program.hash();
  report["machine"] = job.machine.name;
  report["machine_hash"] = hal::hash_hex(hal::machine_toml(job.machine));
  report["softcnc"] = SOFTCNC_VERSION;
  report["grid_mm"] = grid.step;
  report["region_mm"] = map.side() * grid.step;
  report["regions"] = map.columns() * static_cast<std::int64_t>(map.rows());
  report["regions_known"] = rough.regions;
  const bool known = rough.regions > 0;
  report["rmax_um_max"] = known ? Json(rough.largest) : Json();
  report["rmax_um_mean"] = known ? Json(rough.mean) : Json();
  report["regions_gouged"] = gouges.marked;
  report["gouge_um_max"] = gouges.largest;
  report["regions_judged"] = target.judged;
  report["regions_missed"] = target.missed;
  report["missed"] = missed_regions(map, grid);
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string missed_text(const surface::TargetFigures& target, const surface::RoughnessMap& map,
                        const surface::StockGrid& grid) {
  const RegionCentre at = centre_of(target.worst, map, grid);
  return fmt::format(
      "an Rmax of {:.2f} um (target {:.4g} um) at X{:.6g} Y{:.6g}; {} of {} regions exceed their "
      "target",
      target.rmax, target.target, at.x, at.y, target.missed, target.judged);
}

}  // namespace softcnc::app
