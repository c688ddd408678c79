// SPDX-License-Identifier: MIT
// `softcnc check`: the whole pipeline without motion; every diagnostic of every file on stdout.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "commands.hpp"
#include "hal/machine_file.hpp"
#include "machine_memory.hpp"
#include "messages.hpp"
#include "preflight.hpp"
#include "progress.hpp"

namespace softcnc::app {
namespace {

int check_program(const std::string& name, const Machine& machine, const ChannelOptions& options,
                  Messages& messages) {
  auto program = Program::open(name);
  if (!program) return messages.fail(program.error());
  ChannelOptions beside = options;
  beside.interpreter.folder = program->folder();
  const Preflight checked = preflight(*program, machine, beside, messages);
  if (checked.status == 0)
    spdlog::debug("{}: {}, {:.3f} mm in {} blocks", program->name(),
                  duration_text(checked.outcome.time), checked.outcome.last.s,
                  checked.outcome.last.block);
  return checked.status;
}

int check_all(const Options& options, const StandardOutput& out, Messages& messages) {
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  if (!machine) return messages.fail(machine.error());
  auto state = open_state(options.state, messages);
  if (!state) return messages.fail(state.error());
  ChannelOptions channel = channel_options(options, {});
  channel.state = std::move(*state);
  int status = 0;
  for (const std::string& name : options.files)
    if (out.ok()) status = worse_status(status, check_program(name, *machine, channel, messages));
  return status;
}

/// All files once, in the form asked for.
int check_once(const Options& options) {
  StandardOutput out;
  const auto write = [&out](std::string_view text) { out.write(text); };
  const auto document = make_document(options.diagnostics, write);
  Messages messages = document ? Messages(*document) : Messages(write, colourful(STDOUT_FILENO));
  const int status = check_all(options, out, messages);
  if (document) document->finish(status);
  const int written = out.finish();
  return written != 0 ? written : status;
}

}  // namespace

int check(const Options& options) { return check_once(options); }

}  // namespace softcnc::app
