// SPDX-License-Identifier: MIT
// `softcnc check`: the whole pipeline without motion; every diagnostic of every file on stdout.
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "commands/commands.hpp"
#include "hal/machine/machine_confinement.hpp"
#include "input/program_files.hpp"
#include "job/preflight.hpp"
#include "job/terminal.hpp"
#include "messages/duration_text.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "output/time_text.hpp"
#include "process/file_watch.hpp"
#include "settings/machine_choice.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

/// Diagnostics on standard output. Those of a stream are shown at once as text, since what
/// follows may take long; a document is of use only as a whole.
class Shown {
 public:
  explicit Shown(DiagnosticsFormat format) : text_(format == DiagnosticsFormat::text) {}
  void write(std::string_view text) {
    out_.write(text);
    if (streaming_) out_.flush();
  }
  void set_streaming(bool streaming) {
    streaming_ = streaming && text_;
    if (streaming_) out_.flush();
  }
  bool ok() const noexcept { return out_.ok(); }
  int finish() { return out_.finish(); }

 private:
  StandardOutput out_;
  bool text_;
  bool streaming_ = false;
};

/// The files that the program has called, and would have called if they were there, are added to
/// `called`.
int check_program(const std::string& name, const Machine& machine,
                  const runtime::ChannelOptions& options, Shown& out, Messages& messages,
                  Terminal& terminal, std::vector<std::string>& called) {
  auto program = runtime::Program::open(name, runtime::Readings::one);
  if (!program) return messages.fail(program.error());
  out.set_streaming(program->streamed());
  runtime::ChannelOptions beside = options;
  beside.interpreter.folder = program->folder();
  beside.interpreter.called = &program->called();
  terminal.begin("checking", 0, program->size());
  const Preflight checked =
      preflight(*program, machine, beside, messages, &terminal, runtime::CheckNotes::surface_too);
  terminal.end();
  for (const ipr::FoundFile& file : checked.outcome.called_files) called.push_back(file.path);
  for (const std::string& file : checked.outcome.missing_files) called.push_back(file);
  if (checked.status == 0) {
    spdlog::debug("{}: {}, {:.3f} mm in {} blocks", program->name(),
                  duration_text(checked.outcome.time), checked.outcome.last.s,
                  checked.outcome.last.block);
    spdlog::debug("{}", time_sheet_text(checked.outcome.time_sheet));
    if (options.worst_lines > 0)
      spdlog::info("{}:\n{}", program->name(), losses_text(checked.outcome));
  }
  return checked.status;
}

int check_all(const Options& options, const ProgramFiles& programs, Shown& out, Messages& messages,
              Terminal& terminal, std::vector<std::string>& called) {
  auto state = open_state(options, messages);
  if (!state) return messages.fail(state.error());
  MachineCache machines(options, messages);
  runtime::ChannelOptions channel = channel_options(options, {});
  channel.interpreter.compare_dialects = true;
  channel.state = std::move(*state);
  channel.interpreter.stop = terminal.stop();
  int status = 0;
  for (const Diagnostic& error : programs.errors)
    status = worse_status(status, messages.fail(error));
  for (const std::string& name : programs.names) {
    if (!out.ok() || terminal.signal() != 0) break;
    const Machine* machine = machines.of(name);
    if (!machine) continue;
    channel.interpreter.unreachable_too = name != "-";  // a pipe ends when it likes
    status = worse_status(status,
                          check_program(name, *machine, channel, out, messages, terminal, called));
  }
  return worse_status(status, machines.status());
}

struct Checked {
  int status = 0;   // of what was found
  int written = 0;  // 0: the output was written
};

std::string counts(const Messages& messages) {
  const auto counted = [](int count, Severity severity) {
    return fmt::format("{} {}{}", count, name(severity), count == 1 ? "" : "s");
  };
  return fmt::format("{}, {}, {}", counted(messages.count(Severity::error), Severity::error),
                     counted(messages.count(Severity::warning), Severity::warning),
                     counted(messages.count(Severity::note), Severity::note));
}

/// All files once, in the form asked for. Those that they call are watched, too.
Checked check_once(const Options& options, const ProgramFiles& programs, Terminal& terminal,
                   FileWatch* changes) {
  Shown out(options.diagnostics);
  const auto write = [&](std::string_view text) {
    terminal.end();
    out.write(text);
  };
  const auto document = make_document(options.diagnostics, write);
  Messages messages = document
                          ? Messages(*document)
                          : Messages(write, colourful(STDOUT_FILENO), ::isatty(STDOUT_FILENO) != 0);
  std::vector<std::string> called;
  const int status = check_all(options, programs, out, messages, terminal, called);
  if (changes) changes->also(called);
  if (document)
    document->finish(status);
  else if (options.watch)
    out.write(fmt::format("--- {}; watching\n", counts(messages)));
  return {status, out.finish()};
}

/// Machine files beside programs are watched before they are there.
std::vector<std::string> files_of(const Options& options, const ProgramFiles& programs) {
  std::vector<std::string> files = programs.names;
  for (const std::string& part : programs.names)
    if (!options.names_machine) files.push_back(hal::name_beside(part));
  for (const std::string& file : {options.machine_file, options.state})
    if (!file.empty()) files.push_back(file);
  return files;
}

int check_again_and_again(const Options& options, const ProgramFiles& programs,
                          Terminal& terminal) {
  auto changes = FileWatch::open(files_of(options, programs));
  if (!changes) return failed(changes.error());
  do {
    if (const Checked checked = check_once(options, programs, terminal, &*changes);
        checked.written != 0)
      return checked.written;
  } while (changes->wait(terminal.signals()));
  return kSignalled + terminal.signal();
}

}  // namespace

int check(const Options& options) {
  const ProgramFiles programs = programs_in(options.files);
  Terminal terminal(options.progress, false, Machine().control.period);
  if (options.watch) return check_again_and_again(options, programs, terminal);
  const Checked checked = check_once(options, programs, terminal, nullptr);
  if (checked.written != 0) return checked.written;
  return terminal.signal() != 0 ? kSignalled + terminal.signal() : checked.status;
}

}  // namespace softcnc::app
