// SPDX-License-Identifier: MIT
// Pulses per second of CPU. A pulse is one step of the staircase; a diagonal counts as one. `blu_s`
// is the length of the path, in BLU, that is interpolated in a second: what the maximum feeds of
// Tables 3 and 5 of paper 003 are.
#include <benchmark/benchmark.h>

#include <vector>

#include "motion/pulses/staircase.hpp"
#include "support/curves.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

template <typename Make>
void staircase(benchmark::State& state, double length, Make&& make) {
  std::vector<Step> steps(4096);
  std::int64_t moves = 0, runs = 0;
  for (auto _ : state) {
    auto pulses = make(static_cast<PulseMethod>(state.range(0)));
    while (const std::size_t n = pulses.fill(steps)) {
      moves += static_cast<std::int64_t>(n);
      benchmark::DoNotOptimize(steps.data());
      benchmark::ClobberMemory();
    }
    ++runs;
  }
  using benchmark::Counter;
  state.SetLabel(std::string(name(static_cast<PulseMethod>(state.range(0)))));
  state.counters["pulses_s"] = Counter(static_cast<double>(moves), Counter::kIsRate);
  state.counters["blu_s"] = Counter(static_cast<double>(runs) * length, Counter::kIsRate);
}

void line(benchmark::State& state) {
  const GridPoint way{4'000'000, 2'828'427, 0};
  staircase(state, std::hypot(4e6, 2.828427e6),
            [&](PulseMethod method) { return LinePulses(way, method); });
}

void arc(benchmark::State& state) {
  constexpr std::int64_t kRadius = 1'000'000;
  const double turn = 2 * std::numbers::pi;
  const PulseArc arc = test::arc_about_origin({kRadius, 0}, {kRadius, 0}, kRadius, turn);
  staircase(state, turn * kRadius, [&](PulseMethod method) { return ArcPulses(arc, method); });
}

void spline(benchmark::State& state) {
  static const Path butterfly = test::curve("butterfly");
  constexpr double kBlu = 1e-4;
  staircase(state, length(butterfly) / kBlu, [&](PulseMethod method) {
    return Staircase(butterfly, AxisVector::Constant(kBlu), method);
  });
}

BENCHMARK(line)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(arc)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);
BENCHMARK(spline)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace softcnc
