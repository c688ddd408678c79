// SPDX-License-Identifier: MIT
#include "job/preflight.hpp"

#include <utility>

#include "runtime/run/repeated_errors.hpp"

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
  interpreter.guess_dialect = options.guess_dialect;
  interpreter.format = options.format;
  interpreter.folder = folder;
  interpreter.subprogram_folders = options.subprogram_folders;
  interpreter.definitions = options.definitions;
  return interpreter;
}

runtime::ChannelOptions channel_options(const Options& options, const std::string& folder) {
  runtime::ChannelOptions channel;
  channel.feed_override = options.feed_override;
  channel.interpreter = interpreter_options(options, folder);
  channel.single_block = options.single_block;
  channel.rests_at_pauses = options.rest_at_pauses;
  channel.events = options.events;
  channel.worst_lines = worst_lines(options);
  return channel;
}

Preflight preflight(runtime::Program& program, const Machine& machine,
                    const runtime::ChannelOptions& options, Messages& messages,
                    runtime::Watcher* watcher, runtime::CheckNotes notes) {
  runtime::ShownOnce errors(program, options.interpreter, messages.sink(program));
  Diagnostics diagnostics(errors.sink());
  diagnostics.set_file(program.name());
  Preflight result;
  result.outcome = runtime::check(program, machine, options, diagnostics, watcher, notes);
  errors.finish();
  result.status = diagnostics.status();
  return result;
}

}  // namespace softcnc::app
