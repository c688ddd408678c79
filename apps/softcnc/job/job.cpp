// SPDX-License-Identifier: MIT
#include "job/job.hpp"

#include <utility>

#include "job/preflight.hpp"
#include "messages/messages.hpp"
#include "runtime/operator/position_status.hpp"
#include "settings/file_clash.hpp"
#include "settings/machine_choice.hpp"

namespace softcnc::app {
namespace {

/// A dry run opens no backend, and surface and report none that writes.
bool moves(const Options& options) {
  return !options.dry_run && options.command != CommandName::surface &&
         options.command != CommandName::report;
}

}  // namespace

Result<Job> open_job(const Options& options) {
  Messages messages;
  auto choice = choose_machine(options.files.front(), options, messages);
  if (!choice) return tl::make_unexpected(std::move(choice.error()));
  const Machine& machine = choice->machine;
  if (const std::string clash = file_clash(options, machine); !clash.empty() && moves(options))
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC7072, .message = clash, .file = options.machine_file});
  for (const std::string& file : written_files(options, moves(options) ? machine : Machine()))
    clear_leftovers(file);
  auto program = runtime::Program::open(
      options.files.front(), options.dry_run ? runtime::Readings::one : runtime::Readings::any);
  if (!program) return tl::make_unexpected(std::move(program.error()));
  MachineMemory memory;
  const bool keeps = keeps_state(options, machine);
  if (keeps) {
    auto opened = MachineMemory::open(options.state);
    if (!opened) return tl::make_unexpected(std::move(opened.error()));
    memory = std::move(*opened);
  }
  auto state = open_state(options, messages);
  if (!state) return tl::make_unexpected(std::move(state.error()));
  if (keeps) {
    const auto lost = runtime::position_error(*state, machine.control.backend,
                                              options.assume_position, options.state);
    if (lost) return tl::make_unexpected(*lost);
    memory.read(options.work.empty() ? std::optional(*state) : std::nullopt);
  }
  const runtime::ChannelOptions channel = channel_options(options, program->folder());
  Job job{std::move(*program), std::move(choice->machine), std::move(choice->file_beside), channel,
          std::move(memory)};
  job.options.state = std::move(*state);
  job.options.keeps_state = keeps;
  job.options.interpreter.called = &job.program.called();
  return job;
}

}  // namespace softcnc::app
