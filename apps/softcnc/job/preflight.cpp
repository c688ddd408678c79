// SPDX-License-Identifier: MIT
#include "job/preflight.hpp"

#include <utility>

#include "job/corner_cost.hpp"
#include "job/endless.hpp"
#include "messages/repeated_errors.hpp"
#include "runtime/session/simulate.hpp"
#include "runtime/session/verification.hpp"

namespace softcnc::app {

namespace {

/// A report names some of them even if none are asked for.
std::size_t worst_lines(const Options& options) {
  constexpr std::size_t kReported = 10;
  if (options.worst > 0) return static_cast<std::size_t>(options.worst);
  return options.report.empty() ? 0 : kReported;
}

}  // namespace

ipr::InterpreterOptions interpreter_options(const Options& options, const std::string& folder) {
  ipr::InterpreterOptions interpreter;
  interpreter.block_skip = options.block_skip;
  interpreter.optional_stop = options.optional_stop;
  interpreter.dialect = options.dialect;
  interpreter.format = options.format;
  interpreter.folder = folder;
  return interpreter;
}

runtime::ChannelOptions channel_options(const Options& options, const std::string& folder) {
  runtime::ChannelOptions channel;
  channel.feed_override = options.feed_override;
  channel.interpreter = interpreter_options(options, folder);
  channel.single_block = options.single_block;
  channel.events = options.events;
  channel.worst_lines = worst_lines(options);
  return channel;
}

Machine without_backend(Machine machine) {
  machine.control.backend = BackendKind::none;
  return machine;
}

/// By exact interpolation nothing depends on the rows before.
runtime::ChannelOptions skimming(runtime::ChannelOptions options, const Machine& machine) {
  options.skims = machine.control.interpolation == Method::arc_length && options.events.empty();
  return options;
}

Preflight preflight(runtime::Program& program, const Machine& machine,
                    const runtime::ChannelOptions& options, Messages& messages,
                    runtime::Watcher* watcher, PreflightNotes notes) {
  auto backend = hal::open_backend(without_backend(machine));
  if (!backend) return {messages.fail(backend.error()), runtime::Outcome()};
  ShownOnce errors(program, messages.sink(program));
  Diagnostics diagnostics(errors.sink());
  diagnostics.set_file(program.name());
  Preflight result;
  if (!program.streamed() && is_endless(program, machine, options, watcher)) {
    ipr::Reader reader = program.reader();
    Unplanned read = read_unplanned(reader, machine, options, diagnostics, watcher);
    result.outcome.called_files = std::move(read.called_files);
    result.outcome.missing_files = std::move(read.missing_files);
    errors.finish();
    result.status = diagnostics.status();
    return result;
  }
  ipr::Reader reader = program.reader();
  runtime::ChannelOptions running = skimming(options, machine);
  if (program.streamed())
    running.is_endless = [&] {
      ipr::Reader again = reader.again();
      return is_endless(again, machine, options, watcher);
    };
  result.outcome = runtime::simulate(reader, program.descriptor(), machine, running, **backend,
                                     diagnostics, nullptr, watcher);
  if (diagnostics.errors() == 0 && result.outcome.end == runtime::Outcome::End::done) {
    runtime::report_excess(result.outcome.measured, result.outcome.deviation, machine, diagnostics);
    if (notes == PreflightNotes::surface_too) result.outcome.surface.report_blocks(diagnostics);
    result.outcome.surface.warn(diagnostics);
    report_corner_cost(program, machine, options, result.outcome, watcher, diagnostics);
  }
  errors.finish();
  result.status = diagnostics.status();
  return result;
}

}  // namespace softcnc::app
