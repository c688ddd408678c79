// SPDX-License-Identifier: MIT
// `softcnc check`: the whole pipeline without motion; every diagnostic of every file on stdout.
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "commands.hpp"
#include "hal/machine_file.hpp"
#include "messages.hpp"
#include "preflight.hpp"
#include "progress.hpp"

namespace softcnc::app {
namespace {

int check_program(const std::string& name, const Machine& machine, const Options& options,
                  Messages& messages) {
  auto program = Program::open(name);
  if (!program) return messages.fail(program.error());
  const Preflight checked = preflight(*program, machine, channel_options(options), messages);
  if (checked.status == 0)
    spdlog::debug("{}: {}, {:.3f} mm in {} blocks", program->name(),
                  duration_text(checked.outcome.time), checked.outcome.last.s,
                  checked.outcome.last.block);
  return checked.status;
}

}  // namespace

int check(const Options& options) {
  StandardOutput out;
  Messages messages([&out](std::string_view text) { out.write(text); }, colourful(STDOUT_FILENO));
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  int status = machine ? 0 : messages.fail(machine.error());
  for (const std::string& name : options.files)
    if (machine && out.ok())
      status = worse_status(status, check_program(name, *machine, options, messages));
  const int written = out.finish();
  return written != 0 ? written : status;
}

}  // namespace softcnc::app
