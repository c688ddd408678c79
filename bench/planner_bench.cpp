// SPDX-License-Identifier: MIT
// What planning a whole curve costs beside the motion that is planned, on one core: the curves of
// tests/data, rest to rest.
#include <benchmark/benchmark.h>

#include <array>
#include <string>

#include "ipo/planner/planner.hpp"
#include "support/curves.hpp"

namespace softcnc::ipo {
namespace {

constexpr std::array<const char*, 3> kCurves{"circle_deg2", "infinity8", "butterfly"};

/// mm/s^2, mm/s^3 (0: no limit), mm/min.
struct Setting {
  double acceleration, jerk, feed;
};
constexpr std::array<Setting, 7> kSettings{{{1000, 0, 6000},
                                            {1000, 0, 15000},
                                            {3000, 0, 15000},
                                            {5000, 0, 15000},
                                            {1000, 50000, 15000},
                                            {3000, 60000, 15000},
                                            {5000, 500000, 15000}}};

std::string number(double value) { return std::to_string(static_cast<int>(value)); }

Machine machine_of(const Setting& setting) {
  Machine machine;
  for (Axis& axis : machine.axes) {
    axis.acceleration = setting.acceleration;
    axis.jerk = setting.jerk;
  }
  return machine;
}

/// Nodes of the plan, and s of motion.
struct Planned {
  std::size_t nodes = 0;
  double time = 0;
};

Planned plan(const Machine& machine, const Block& block) {
  Diagnostics diagnostics;
  Planner planner(machine, 1, diagnostics);
  Planned planned;
  const auto take = [&] {
    while (const auto timed = planner.pop()) planned.time += timed->profile.duration();
  };
  planner.push(block);
  take();
  planner.finish();
  take();
  planned.nodes = planner.counts().nodes;
  return planned;
}

void plan_curve(benchmark::State& state) {
  const std::string name = kCurves.at(static_cast<std::size_t>(state.range(0)));
  const Setting& setting = kSettings.at(static_cast<std::size_t>(state.range(1)));
  const Machine machine = machine_of(setting);
  const Block block{Move{.path = test::curve(name), .feed = setting.feed / 60}, {1, 1, 1}, 1};
  Planned planned;
  double motion = 0;
  for (auto _ : state) {
    planned = plan(machine, block);
    motion += planned.time;
  }
  using benchmark::Counter;
  state.SetLabel(name + " A" + number(setting.acceleration) + " J" + number(setting.jerk) + " F" +
                 number(setting.feed));
  state.counters["nodes"] = static_cast<double>(planned.nodes);
  state.counters["motion_s"] = planned.time;
  state.counters["motion/planning"] = Counter(motion, Counter::kIsRate);
}
BENCHMARK(plan_curve)
    ->ArgNames({"curve", "setting"})
    ->ArgsProduct({{0, 1, 2}, {0, 1, 2, 3, 4, 5, 6}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace softcnc::ipo
