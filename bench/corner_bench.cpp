// SPDX-License-Identifier: MIT
// 20,000 chords of 0.1 mm on arcs and sines, G64 P0.005: what rounding costs per chord, and what
// all of planning does (per_block).
#include <benchmark/benchmark.h>

#include "ipo/planner/planner.hpp"
#include "ipo/planner/trial_plan.hpp"
#include "support/chords.hpp"

namespace softcnc::ipo {
namespace {

constexpr int kChords = 20'000;

std::vector<Block> chords(bool corners = true) {
  const auto points = corners ? test::Chopped(3.5, 0.1, 1e-4).points(kChords)
                              : test::chopped_laps(3.5, 0.1, kChords);
  std::vector<Block> blocks;
  for (int i = 1; i <= kChords; ++i) {
    const auto n = static_cast<std::size_t>(i);
    blocks.push_back({Move{.path = Line(points[n - 1], points[n]),
                           .feed = 250,
                           .corner_tolerance = 0.005,
                           .chord_tolerance = 0.005},
                      {i, 1, 1},
                      i});
  }
  return blocks;
}

void round_corners(benchmark::State& state) {
  const Machine machine;
  const auto blocks = chords();
  std::size_t pieces = 0;
  for (auto _ : state) {
    CornerStage stage(machine, make_trial_plan(machine));
    pieces = 0;
    for (const Block& block : blocks) {
      stage.push(block);
      while (stage.pop()) ++pieces;
    }
    stage.finish();
    while (stage.pop()) ++pieces;
  }
  state.counters["pieces"] = static_cast<double>(pieces);
  state.SetItemsProcessed(state.iterations() * kChords);
}
BENCHMARK(round_corners)->Unit(benchmark::kMillisecond);

/// As in the table of docs/corners.md.
Machine machine_with(double jerk) {
  Machine machine;
  machine.control.period = 0.001;
  machine.control.chord_tolerance = 0.001;
  for (Axis& axis : machine.axes) {
    axis.velocity = 250;
    axis.acceleration = 1000;
    axis.jerk = jerk;
  }
  machine.axes[0].max = 10'000;
  return machine;
}

/// Without limits of jerk, and with them; a figure with corners, and that of the table.
void plan(benchmark::State& state) {
  const Machine machine = machine_with(static_cast<double>(state.range(0)));
  const auto blocks = chords(state.range(1) != 0);
  std::size_t nodes = 0;
  for (auto _ : state) {
    Diagnostics diagnostics;
    Planner planner(machine, 1, diagnostics);
    for (const Block& block : blocks) {
      planner.push(block);
      while (auto timed = planner.pop()) benchmark::DoNotOptimize(timed);
    }
    planner.finish();
    while (auto timed = planner.pop()) benchmark::DoNotOptimize(timed);
    nodes = planner.counts().nodes;
    if (diagnostics.errors() > 0) return state.SkipWithError("chords are left out");
  }
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["per_block"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * kChords,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(plan)
    ->ArgNames({"jerk", "corners"})
    ->ArgsProduct({{0, 50'000}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace softcnc::ipo
