// SPDX-License-Identifier: MIT
// Random programs with overrides, holds and aborts on random machines with step and direction
// drives, by every interpolation: what the backend has written is read back and judged.
//
//   random_pulses COUNT [SEED]
//
// goes on until so many pulses have been made; exit 1 where a rule of a driver is broken or a count
// is not the commanded one.
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "hal/backends/stepdir.hpp"
#include "hal/signals/edge_reader.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "motion/model/step_rate.hpp"
#include "support/random_program.hpp"

namespace {

using namespace softcnc;

constexpr Method kMethods[] = {Method::arc_length, Method::sam,   Method::m_sam,
                               Method::dsm,        Method::m_dsm, Method::dda};
/// Step length, step space, direction set-up and hold of common drivers, ns.
constexpr double kDrivers[][4] = {{500, 4000, 1000, 20000},
                                  {5000, 5000, 10000, 10000},
                                  {22000, 22000, 100000, 100000},
                                  {2000, 1000, 200, 200},
                                  {500, 500, 0, 0}};

struct Totals {
  std::int64_t programs = 0, halted = 0, aborted = 0, rows = 0, pulses = 0;
};

class Trial {
 public:
  Trial(std::uint32_t seed, const std::string& file) : random_(seed), file_(file) {}

  /// What has gone wrong, or nothing.
  std::string run(Totals& totals);

 private:
  double uniform(double a, double b) {
    return a + (b - a) * static_cast<double>(random_()) / static_cast<double>(std::mt19937::max());
  }
  Machine machine();
  test::Controls controls(Totals& totals);

  std::mt19937 random_;
  const std::string& file_;
};

Machine Trial::machine() {
  Machine machine;
  machine.control.interpolation = kMethods[random_() % std::size(kMethods)];
  machine.control.period = std::pow(10.0, uniform(-3.3, -2));
  if (random_() % 3 == 0) machine.control.pulse_clock = PulseClock::paper;
  if (random_() % 4 == 0) machine.control.constant_feed = ConstantFeed::off;
  machine.limits.feed = 0;
  StepPort& port = machine.step_port;
  const auto& driver = kDrivers[random_() % std::size(kDrivers)];
  port = {file_, 0, driver[0] * 1e-9, driver[1] * 1e-9, driver[2] * 1e-9, driver[3] * 1e-9};
  port.max_rate = uniform(0.2, 1) / (port.step_length + port.step_space);
  const bool jerk = random_() % 6 == 0;
  for (Axis& axis : machine.axes) {
    axis.blu = std::round(std::pow(10.0, uniform(2.5, 4))) * 1e-6;  // whole nm
    if (has_equal_clocks(machine.control)) axis.blu = machine.axes[0].blu;
    axis.velocity = axis.blu * step_rate(port) * uniform(0.3, 1);
    axis.acceleration = std::pow(10.0, uniform(2, 4));
    axis.jerk = jerk ? 20 * axis.acceleration : 0;
  }
  return machine;
}

test::Controls Trial::controls(Totals& totals) {
  if (random_() % 2 == 0) return {};
  ++totals.halted;
  test::Controls controls = test::random_controls(random_, 6);
  if (random_() % 2 == 0) return controls;
  ++totals.aborted;
  controls[std::prev(controls.end())->first + 1 + static_cast<int>(random_() % 300)].stop = true;
  return controls;
}

std::string Trial::run(Totals& totals) {
  const Machine machine = this->machine();
  const auto blocks = test::random_program(random_, 4 + static_cast<int>(random_() % 6));
  auto backend = hal::StepDir::open(machine);
  if (!backend) return backend.error().message;
  const auto run = test::run(machine, blocks, controls(totals), 1, 1,
                             [&](const Setpoint& row) { (*backend)->exchange(row); });
  for (const Diagnostic& told : run.diagnostics)
    if (told.severity() == Severity::error) return told.message;
  if (const auto finished = (*backend)->finish(); !finished) return finished.error().message;
  std::ifstream in(file_, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  const auto edges = hal::read_edges(bytes);
  if (!edges) return "the file of edges cannot be read";
  hal::PulseRules rules(hal::step_timing(machine.step_port));
  rules.read(*edges);
  if (rules.broken()) return *rules.broken();
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    const std::int64_t commanded =
        Counts(machine.axes[i].blu)(run.rows.back().position[static_cast<int>(i)]);
    if (rules.counts()[i] != commanded)
      return fmt::format("axis {}: {} counts sent, {} commanded", i, rules.counts()[i], commanded);
  }
  ++totals.programs;
  totals.rows += static_cast<std::int64_t>(run.rows.size());
  totals.pulses += rules.steps();
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: random_pulses COUNT [SEED]\n");
    return 2;
  }
  const std::int64_t wanted = std::atoll(argv[1]);
  auto seed = static_cast<std::uint32_t>(argc > 2 ? std::atoll(argv[2]) : 1);
  const std::string file =
      std::filesystem::temp_directory_path() / fmt::format("pulses-{}.edges", ::getpid());
  Totals totals;
  std::string wrong;
  for (; totals.pulses < wanted && wrong.empty(); ++seed) wrong = Trial(seed, file).run(totals);
  std::filesystem::remove(file);
  if (!wrong.empty()) {
    fmt::print(stderr, "seed {}: {}\n", seed - 1, wrong);
    return 1;
  }
  fmt::print(
      "{} pulses of {} programs, {} of them with overrides and holds, {} aborted; {} rows: "
      "no rule broken, no count lost\n",
      totals.pulses, totals.programs, totals.halted, totals.aborted, totals.rows);
  return 0;
}
