// SPDX-License-Identifier: MIT
// How fast edges cut a Z-map, on one core. An update is one edge pass tested against one point.
#include <benchmark/benchmark.h>

#include "support/milled.hpp"

namespace softcnc::surface {
namespace {

/// A tile in the midst of passes; `incline` in degrees, `micrometres` per tooth.
void cut_tile(benchmark::State& state) {
  test::Milling milling;
  milling.incline = static_cast<double>(state.range(0));
  milling.feed = static_cast<double>(state.range(1)) / 1000;
  const auto track = test::milled(milling, 13, 6);
  const auto grid = test::grid_of(2, 1.5, 2.55, 2.55, 0.01);
  const Workpiece workpiece(track, grid);
  std::int64_t updates = 0, points = 0;
  for (auto _ : state) {
    const Tile tile = workpiece.cut(0, 0, grid.columns, grid.rows);
    benchmark::DoNotOptimize(tile.heights.data());
    updates += tile.updates;
    points += static_cast<std::int64_t>(tile.heights.size());
  }
  using benchmark::Counter;
  state.counters["updates"] = Counter(static_cast<double>(updates), Counter::kIsRate);
  state.counters["points"] = Counter(static_cast<double>(points), Counter::kIsRate);
}
BENCHMARK(cut_tile)
    ->ArgNames({"degrees", "um_per_tooth"})
    ->Args({0, 500})
    ->Args({0, 330})
    ->Args({10, 500})
    ->Args({45, 500});

}  // namespace
}  // namespace softcnc::surface
