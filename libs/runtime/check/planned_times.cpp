// SPDX-License-Identifier: MIT
#include "runtime/check/planned_times.hpp"

#include <utility>

#include "ipo/planner/planner.hpp"
#include "ipr/interpreter/interpreter.hpp"
#include "runtime/figures/time_sheet.hpp"
#include "runtime/program/each_block.hpp"

namespace softcnc::runtime {
namespace {}  // namespace

std::optional<PlannedTimes> plan_times(Program& program, const Machine& machine,
                                       const ChannelOptions& options, Watcher* watcher,
                                       const std::function<void(Block&)>& change) {
  Diagnostics silent([](const Diagnostic&) {});
  ipr::Reader reader = program.reader();
  ipr::Parser parser(reader, silent);
  ipr::InterpreterOptions reading = options.interpreter;
  reading.compare_dialects = reading.unreachable_too = false;
  ipr::Interpreter interpreter(parser, machine, silent, reading, options.state);
  ipo::Planner planner(machine, options.feed_override, silent, {}, options.constraints);
  TimeKeeper keeper;
  PlannedTimes times;
  const auto take_timed = [&] {
    while (const auto timed = planner.pop()) {
      keeper.add(*timed, timed->profile.duration(), options.feed_override);
      times.time = timed->t_end();
    }
  };
  int blocks = 0;
  bool stopped = false;
  const auto take = [&](Block block) {
    change(block);
    planner.push(std::move(block));
    take_timed();
    stopped = watcher != nullptr && ++blocks % kBlocksBetweenLooks == 0 && watcher->wants_stop();
    return !stopped;
  };
  each_block(interpreter, take, [] { return false; });
  planner.finish();
  if (!stopped) take_timed();
  if (stopped || silent.errors() > 0) return std::nullopt;
  times.rests = keeper.sheet().corners.count;
  return times;
}

}  // namespace softcnc::runtime
