// SPDX-License-Identifier: MIT
#include "surface/surface_bands.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>

namespace softcnc::surface {
namespace {

void copy(const Tile& tile, double bottom, SurfaceBand& band) {
  for (int row = 0; row < tile.rows; ++row) {
    const std::size_t from = tile.index(tile.first_column, tile.first_row + row);
    const std::size_t to = band.index(tile.first_column, row);
    for (std::size_t i = 0; i < static_cast<std::size_t>(tile.columns); ++i) {
      band.heights[to + i] = static_cast<float>(tile.heights[from + i] - bottom);
      band.deviations[to + i] = tile.deviations[from + i];
    }
  }
  auto target = tile.targets.begin();
  for (std::size_t row = 0; row < SurfaceBand::blocks(tile.rows); ++row) {
    const std::size_t to = band.block(tile.first_column, static_cast<int>(row) * Workpiece::kBlock);
    for (std::size_t i = 0; i < SurfaceBand::blocks(tile.columns); ++i)
      band.targets[to + i] = *target++;
  }
}

/// Calls work(i) for 0 <= i < count, on some threads; passes an exception on.
template <typename Work>
void share(int count, unsigned threads, Work&& work) {
  std::atomic<int> next{0};
  std::atomic<bool> broken{false};
  std::exception_ptr reason;
  const auto help = [&] {
    try {
      for (int i = next++; i < count && !broken; i = next++) work(i);
    } catch (...) {
      if (!broken.exchange(true)) reason = std::current_exception();
    }
  };
  std::vector<std::jthread> helpers;
  try {
    for (unsigned i = 1; i < threads; ++i) helpers.emplace_back(help);
  } catch (const std::system_error&) {
    // The system has no more threads: those that there are do it.
  }
  help();
  helpers.clear();
  if (reason) std::rethrow_exception(reason);
}

}  // namespace

Result<std::int64_t> cut_bands(const Workpiece& workpiece, unsigned threads, const TakeBand& take,
                               const WantsStop& wants_stop) {
  const StockGrid& grid = workpiece.grid();
  std::atomic<std::int64_t> updates{0};
  std::atomic<bool> stopped{false};
  const auto caller = std::this_thread::get_id();
  const auto stops = [&] {
    if (wants_stop && std::this_thread::get_id() == caller && wants_stop()) stopped = true;
    return stopped.load();
  };
  for (int row = 0; row < grid.rows; row += kTileSide) {
    SurfaceBand band{row, std::min(kTileSide, grid.rows - row), grid.columns, {}, {}, {}};
    band.heights.resize(band.index(0, band.rows));
    band.deviations.resize(band.heights.size());
    band.targets.resize(SurfaceBand::blocks(band.rows) * SurfaceBand::blocks(band.columns));
    share((grid.columns + kTileSide - 1) / kTileSide, threads, [&](int i) {
      const Tile tile = workpiece.cut(i * kTileSide, row, kTileSide, kTileSide, stops);
      if (stopped) return;
      copy(tile, grid.corner[2], band);
      updates += tile.updates;
    });
    if (stops()) break;
    const Result<bool> wanted = take(band);
    if (!wanted) return tl::make_unexpected(wanted.error());
    if (!*wanted) break;
  }
  return updates.load();
}

}  // namespace softcnc::surface
