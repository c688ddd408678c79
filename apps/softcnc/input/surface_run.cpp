// SPDX-License-Identifier: MIT
#include "input/surface_run.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "hal/backends/backend.hpp"
#include "runtime/check/check.hpp"
#include "runtime/cutting/cutting_rows.hpp"
#include "runtime/cutting/surface_grid.hpp"
#include "runtime/run/run.hpp"
#include "runtime/sinks/contour_rows.hpp"
#include "surface/surface_bands.hpp"

namespace softcnc::app {
namespace {

constexpr int kShown = 600;  // heights along the longer side, at most

/// Where the tool goes; nothing if the program has errors.
Result<std::optional<surface::ToolTrack>> track_of(Job& job, const runtime::Cutting& cutting,
                                                   Terminal& terminal) {
  const Machine machine = runtime::without_backend(job.machine);
  auto backend = hal::open_backend(machine);
  if (!backend) return tl::make_unexpected(std::move(backend.error()));
  runtime::CuttingRows rows(cutting, machine.surfacing.phase, machine.control.period,
                            runtime::row_columns(**backend));
  const runtime::JudgedRun run = runtime::run({.program = job.program,
                                               .machine = machine,
                                               .options = job.options,
                                               .backend = **backend,
                                               .rows = &rows,
                                               .watcher = &terminal,
                                               .is_judged = false},
                                              [](const Diagnostic&) {});
  auto track = rows.finish();
  if (!track) return tl::make_unexpected(std::move(track.error()));
  if (run.errors > 0) return std::nullopt;
  return std::move(*track);
}

/// Keeps some heights of each band.
class ShownHeights {
 public:
  ShownHeights(const surface::StockGrid& grid, ReportedSurface& shown) : shown_(shown) {
    shown.every = (std::max(grid.columns, grid.rows) + kShown - 1) / kShown;
    shown.columns = (grid.columns + shown.every - 1) / shown.every;
  }

  void add(const surface::SurfaceBand& band) {
    for (int row = 0; row < band.rows; ++row) {
      if ((band.first_row + row) % shown_.every != 0) continue;
      for (int column = 0; column < band.columns; column += shown_.every)
        shown_.heights.push_back(band.heights[band.index(column, row)]);
      ++shown_.rows;
    }
  }

 private:
  ReportedSurface& shown_;
};

Result<std::optional<ReportedSurface>> cut(const surface::ToolTrack& track,
                                           const runtime::Cutting& cutting,
                                           const surface::StockGrid& grid, Terminal& terminal) {
  surface::RoughnessMap map(grid, runtime::region_side(cutting, grid.step));
  ReportedSurface shown;
  shown.grid = grid;
  ShownHeights heights(grid, shown);
  const auto updates = surface::cut_bands(
      surface::Workpiece(track, grid), std::max(1U, std::thread::hardware_concurrency()),
      [&](const surface::SurfaceBand& band) -> Result<bool> {
        map.add(band);
        heights.add(band);
        return true;
      },
      [&] { return terminal.signal() != 0; });
  if (!updates) return tl::make_unexpected(updates.error());
  if (terminal.signal() != 0) return std::nullopt;
  shown.region_columns = map.columns();
  shown.region_rows = map.rows();
  shown.region = map.side() * grid.step;
  shown.rmax = map.rmax();
  shown.targets = map.targets();
  shown.judged = surface::target_figures(map);
  return shown;
}

bool is_too_large(const surface::StockGrid& grid) {
  const double points = static_cast<double>(grid.columns) * grid.rows;
  if (points <= kMostSurfacePoints) return false;
  spdlog::info(
      "the report leaves out the surface, which has {:.0f} million points; 'softcnc "
      "surface' computes it",
      points / 1e6);
  return true;
}

}  // namespace

Result<std::optional<ReportedSurface>> cut_surface(Job& job, Terminal& terminal) {
  Diagnostics silent([](const Diagnostic&) {});
  terminal.begin("cutting", 0, job.program.size());
  const runtime::Cutting cutting =
      runtime::read_cutting(job.program, job.machine, job.options, silent, terminal);
  if (silent.errors() > 0 || terminal.signal() != 0) return std::nullopt;
  const auto grid = runtime::stock_grid(job.machine.stock, cutting);
  if (!grid || is_too_large(*grid)) return std::nullopt;
  const auto track = track_of(job, cutting, terminal);
  if (!track) return tl::make_unexpected(track.error());
  if (!*track || terminal.signal() != 0) return std::nullopt;
  return cut(**track, cutting, *grid, terminal);
}

}  // namespace softcnc::app
