// SPDX-License-Identifier: MIT
// What a period costs at the machine: the simulated mill, and a row of its trace.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>

#include "hal/backends/backend.hpp"
#include "hal/trace/trace.hpp"

namespace softcnc::hal {
namespace {

Machine two_axes() {
  Machine machine;
  machine.axes[2].present = false;
  return machine;
}

/// A circle of 30 mm at 100 mm/s.
Setpoint on_circle(std::int64_t period) {
  const double angle = static_cast<double>(period) * 0.001 * 100.0 / 30.0;
  Setpoint setpoint;
  setpoint.period = period;
  setpoint.line = 4;
  setpoint.block = 2;
  setpoint.s = 30.0 * angle;
  setpoint.v = 100.0;
  setpoint.limit = Limit::feed;
  setpoint.position = {30.0 * std::cos(angle), 30.0 * std::sin(angle), 0.0};
  return setpoint;
}

/// One period of 1 ms of the mill alone. `times_real` is how much faster than the mill itself.
void simulated_mill(benchmark::State& state) {
  const Machine machine = two_axes();
  const auto mill = open_backend(machine);
  std::array<Setpoint, 1885> turn;  // a full turn, near enough
  for (std::size_t i = 0; i < turn.size(); ++i) turn[i] = on_circle(static_cast<std::int64_t>(i));
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize((*mill)->exchange(turn[next]));
    next = (next + 1) % turn.size();
  }
  state.counters["times_real"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * machine.control.period,
                         benchmark::Counter::kIsRate);
}
BENCHMARK(simulated_mill);

void trace_row(benchmark::State& state, const char* file) {
  const Machine machine = two_axes();
  const auto mill = open_backend(machine);
  const auto trace = TraceWriter::open(file, {}, machine, (*mill)->columns());
  std::array<double, 6> values{};
  std::int64_t period = 0;
  for (auto _ : state) {
    const Setpoint setpoint = on_circle(period++);
    (*mill)->exchange(setpoint);
    (*mill)->values(values);
    (*trace)->row(setpoint, values);
  }
}
BENCHMARK_CAPTURE(trace_row, csv, "/dev/null");

}  // namespace
}  // namespace softcnc::hal
