// SPDX-License-Identifier: MIT
#include "preflight.hpp"

#include "verification.hpp"

namespace softcnc::app {

ChannelOptions channel_options(const Options& options) {
  return {options.feed_override, {options.block_skip, options.optional_stop}};
}

Preflight preflight(Program& program, const Machine& machine, const ChannelOptions& options,
                    Messages& messages, Watcher* watcher) {
  Machine without_backend = machine;
  without_backend.control.backend = BackendKind::none;
  auto backend = hal::open_backend(without_backend);
  if (!backend) return {messages.fail(backend.error()), {}};
  Diagnostics diagnostics(messages.sink(program));
  diagnostics.set_file(program.name());
  ipr::Reader reader = program.reader();
  Preflight result;
  result.outcome = simulate(reader, machine, options, **backend, diagnostics, nullptr, watcher);
  if (diagnostics.errors() == 0) report_excess(result.outcome.measured, machine, diagnostics);
  result.status = diagnostics.status();
  return result;
}

}  // namespace softcnc::app
