// SPDX-License-Identifier: MIT
// What planning a program costs, without reading it: all of its blocks are there before the clock
// starts, and reach the planner one after the other, as from a stream. One JSON object, for
// scripts/generate feed.
//
//   plan_program SECONDS PROGRAM [KEY=VALUE ...]
//
// plans until SECONDS of CPU time have passed (0: once), on the built-in machine with these values;
// the fastest plan counts, since other programs only slow it down.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "hal/machine/machine_file.hpp"
#include "ipo/planner/planner.hpp"
#include "ipr/interpreter/interpreter.hpp"

namespace softcnc {
namespace {

double cpu_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Planned {
  double motion = 0, planning = 0;  // s
  ipo::PlannerCounts counts;
};

/// `blocks`: a copy for the planner to take.
Planned plan(const Machine& machine, std::vector<Block> blocks, const ipo::Horizon& horizon) {
  Diagnostics diagnostics;
  Planned planned;
  const double begin = cpu_seconds();
  ipo::Planner planner(machine, 1, diagnostics, horizon);
  const auto take = [&] {
    while (const auto part = planner.pop_part())
      std::visit([&](const auto& timed) { planned.motion += timed.profile.duration(); }, *part);
  };
  for (Block& block : blocks) {
    planner.push(std::move(block));
    take();
  }
  planner.finish();
  take();
  planned.planning = cpu_seconds() - begin;
  planned.counts = planner.counts();
  return planned;
}

[[noreturn]] void give_up(const Diagnostic& diagnostic) {
  fmt::print(stderr, "{}", render(diagnostic));
  std::exit(2);
}

std::vector<Block> read(const Machine& machine, const std::string& file) {
  auto reader = ipr::Reader::open(file);
  if (!reader) give_up(reader.error());
  Diagnostics diagnostics;
  ipr::Parser parser(*reader, diagnostics);
  ipr::Interpreter interpreter(parser, machine, diagnostics);
  std::vector<Block> blocks;
  while (auto block = interpreter.next()) blocks.push_back(std::move(*block));
  if (diagnostics.errors() > 0) give_up(diagnostics.all().front());
  return blocks;
}

std::string measure(double seconds, const Machine& machine, const std::vector<Block>& blocks) {
  const Planned streamed = plan(machine, blocks, {});
  double least = streamed.planning;
  for (double spent = least; spent < seconds;) {
    const double again = plan(machine, blocks, {}).planning;
    least = std::min(least, again);
    spent += again;
  }
  const Planned whole = plan(machine, blocks, ipo::Horizon::whole());
  return nlohmann::ordered_json{{"blocks", blocks.size()},
                                {"motion_s", streamed.motion},
                                {"planning_s", least},
                                {"nodes", streamed.counts.nodes},
                                {"plan_nodes", streamed.counts.effort.nodes},
                                {"iterations", streamed.counts.effort.iterations},
                                {"fallbacks", streamed.counts.effort.fallbacks},
                                {"whole_motion_s", whole.motion},
                                {"whole_fallbacks", whole.counts.effort.fallbacks}}
      .dump();
}

}  // namespace
}  // namespace softcnc

int main(int argc, char** argv) {
  using namespace softcnc;
  if (argc < 3) {
    fmt::print(stderr, "usage: plan_program SECONDS PROGRAM [KEY=VALUE ...]\n");
    return 2;
  }
  const std::vector<std::string> settings(argv + 3, argv + argc);
  const auto machine = hal::load_machine("", settings);
  if (!machine) give_up(machine.error().front());
  fmt::print("{}\n", measure(std::atof(argv[1]), *machine, read(*machine, argv[2])));
}
