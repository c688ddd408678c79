// SPDX-License-Identifier: MIT
#include "runtime/check/check.hpp"

#include <utility>

#include "hal/backends/backend.hpp"
#include "runtime/check/corner_cost.hpp"
#include "runtime/check/endless.hpp"
#include "runtime/check/travel_summary.hpp"
#include "runtime/run/judge.hpp"
#include "runtime/session/simulate.hpp"

namespace softcnc::runtime {
namespace {

/// By exact interpolation nothing depends on the rows before.
ChannelOptions skimming(ChannelOptions options, const Machine& machine) {
  options.skims = machine.control.interpolation == Method::arc_length && options.events.empty();
  return options;
}

Outcome only_read(Program& program, const Machine& machine, const ChannelOptions& options,
                  Diagnostics& diagnostics, Watcher* watcher) {
  ipr::Reader reader = program.reader();
  Unplanned read = read_unplanned(reader, machine, options, diagnostics, watcher);
  Outcome outcome;
  outcome.called_files = std::move(read.called_files);
  outcome.missing_files = std::move(read.missing_files);
  return outcome;
}

/// What reading the program from a state finds.
TravelReading read_from(const MachineState& state, Program& program, const Machine& machine,
                        ChannelOptions options, Watcher* watcher) {
  TravelReading reading{.before = state};
  bool beyond = false, wrong = false;
  Diagnostics silent([&](const Diagnostic& diagnostic) {
    if (diagnostic.severity() != Severity::error) return;
    (diagnostic.code == Code::SC4001 ? beyond : wrong) = true;
  });
  options.state = state;
  ipr::Reader reader = program.reader();
  Unplanned read = read_unplanned(reader, machine, options, silent, watcher);
  reading.after = std::move(read.state);
  reading.survey = std::move(read.travel);
  wrong = wrong || (watcher != nullptr && watcher->wants_stop());
  reading.good = !beyond && !wrong;
  reading.only_travel = beyond && !wrong;
  return reading;
}

/// Everything that running the program finds.
Outcome run(Program& program, const Machine& machine, const ChannelOptions& options,
            hal::Backend& backend, Diagnostics& diagnostics, Watcher* watcher) {
  if (!program.streamed() && is_endless(program, machine, options, watcher))
    return only_read(program, machine, options, diagnostics, watcher);
  ipr::Reader reader = program.reader();
  ChannelOptions running = skimming(options, machine);
  if (program.streamed())
    running.is_endless = [&] {
      ipr::Reader again = reader.again();
      return is_endless(again, machine, options, watcher);
    };
  return simulate(reader, program.descriptor(), machine, running, backend, diagnostics, nullptr,
                  watcher);
}

}  // namespace

Machine without_backend(Machine machine) {
  machine.control.backend = BackendKind::none;
  return machine;
}

Outcome check(Program& program, const Machine& machine, const ChannelOptions& options,
              Diagnostics& diagnostics, Watcher* watcher, CheckNotes notes) {
  auto backend = hal::open_backend(without_backend(machine));
  if (!backend) {
    diagnostics.report(backend.error());
    return Outcome();
  }
  // Who streams a program is to see at once which move leaves the travel.
  TravelSummary travel(diagnostics, !program.streamed());
  Diagnostics all(travel.sink());
  all.set_file(diagnostics.file());
  Outcome outcome = run(program, machine, options, **backend, all, watcher);
  travel.report(options.state, machine, [&](const MachineState& state) {
    return read_from(state, program, machine, options, watcher);
  });
  if (all.errors() > 0 || outcome.end != Outcome::End::done) return outcome;
  judge(outcome, **backend, machine, all);
  if (notes == CheckNotes::surface_too) outcome.surface.report_blocks(all);
  outcome.surface.warn(all);
  report_corner_cost(program, machine, options, outcome, watcher, all);
  return outcome;
}

}  // namespace softcnc::runtime
