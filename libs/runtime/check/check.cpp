// SPDX-License-Identifier: MIT
#include "runtime/check/check.hpp"

#include <utility>

#include "hal/backends/backend.hpp"
#include "runtime/check/corner_cost.hpp"
#include "runtime/check/endless.hpp"
#include "runtime/session/simulate.hpp"
#include "runtime/session/verification.hpp"

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
  if (!program.streamed() && is_endless(program, machine, options, watcher))
    return only_read(program, machine, options, diagnostics, watcher);
  ipr::Reader reader = program.reader();
  ChannelOptions running = skimming(options, machine);
  if (program.streamed())
    running.is_endless = [&] {
      ipr::Reader again = reader.again();
      return is_endless(again, machine, options, watcher);
    };
  Outcome outcome = simulate(reader, program.descriptor(), machine, running, **backend, diagnostics,
                             nullptr, watcher);
  if (diagnostics.errors() > 0 || outcome.end != Outcome::End::done) return outcome;
  report_excess(outcome.measured, outcome.deviation, machine, diagnostics);
  if (notes == CheckNotes::surface_too) outcome.surface.report_blocks(diagnostics);
  outcome.surface.warn(diagnostics);
  report_corner_cost(program, machine, options, outcome, watcher, diagnostics);
  return outcome;
}

}  // namespace softcnc::runtime
