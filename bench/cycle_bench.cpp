// SPDX-License-Identifier: MIT
// The butterfly, again and again until 100,000 setpoints have been made: what interpolation and
// cycle cost per setpoint, and beside it what planning costs.
#include <benchmark/benchmark.h>

#include <string>

#include "hal/backends/backend.hpp"
#include "runtime/session/simulate.hpp"

namespace softcnc::app {
namespace {

constexpr int kSetpoints = 100'000;

/// The text of programs/08_butterfly.nc without its end, as often as `times` says.
std::string butterflies(int times) {
  auto reader = ipr::Reader::open(SOFTCNC_SOURCE_DIR "/programs/08_butterfly.nc");
  if (!reader) return {};
  std::string once;
  while (const auto line = reader->next()) {
    if (line->find("M30") != std::string_view::npos) break;
    once.append(*line) += '\n';
  }
  std::string text;
  for (int i = 0; i < times; ++i) (text += once) += "G00 X0 Y0\n";
  return text;
}

/// Ends a run when there are enough samples.
class Enough final : public runtime::RowSink {
 public:
  bool row(const Setpoint&, std::span<const double>) override { return ++rows_ < kSetpoints; }

 private:
  int rows_ = 0;
};

void cycle(benchmark::State& state) {
  Machine machine;
  machine.control.backend = BackendKind::none;
  const std::string text = butterflies(20);
  runtime::Outcome::Cpu cpu;
  double setpoints = 0;
  for (auto _ : state) {
    auto backend = hal::open_backend(machine);
    Diagnostics diagnostics;
    ipr::Reader reader = ipr::Reader::from_text(text);
    Enough enough;
    const runtime::Outcome outcome =
        runtime::simulate(reader, -1, machine, {}, **backend, diagnostics, &enough, nullptr);
    if (diagnostics.errors() > 0 || outcome.setpoints < kSetpoints) {
      state.SkipWithError("the butterfly does not run as it should");
      return;
    }
    cpu.cycle += outcome.cpu.cycle;
    cpu.planning += outcome.cpu.planning;
    cpu.verification += outcome.cpu.verification;
    setpoints += static_cast<double>(outcome.setpoints);
  }
  constexpr double kNanoseconds = 1e9;
  state.counters["cycle_ns"] = kNanoseconds * cpu.cycle / setpoints;
  state.counters["planning_ns"] = kNanoseconds * cpu.planning / setpoints;
  state.counters["verification_ns"] = kNanoseconds * cpu.verification / setpoints;
  state.counters["setpoints"] = setpoints / static_cast<double>(state.iterations());
}
BENCHMARK(cycle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace softcnc::app
