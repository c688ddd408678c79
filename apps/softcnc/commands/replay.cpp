// SPDX-License-Identifier: MIT
// `softcnc replay`: run recordings again; the first row that differs is shown.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "commands/commands.hpp"
#include "hal/files/hash.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/trace/trace_csv.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "recording/recording.hpp"
#include "recording/trace_comparison.hpp"
#include "runtime/session/simulate.hpp"
#include "runtime/sinks/contour_rows.hpp"
#include "runtime/sinks/trace_rows.hpp"

namespace softcnc::app {
namespace {

/// The machine of the recording unless one is given.
hal::MachineOrErrors machine_of(const Recording& recording, const std::string& name,
                                const Options& options) {
  if (options.names_machine) return hal::load_machine(options.machine_file, options.settings);
  return hal::parse_machine(recording.machine(), name + ":machine.toml", options.settings);
}

/// A name that no file has: what was called is in the recording.
std::string folder_of_called(const std::string& name) { return name + ":called"; }

/// A recording with all that is needed to run it again.
struct Material {
  Recording recording;
  Machine machine;
  runtime::Program program;
  std::unique_ptr<hal::Backend> backend;
  TraceComparison comparison;
};

Result<Material> open_material(const std::string& name, const Options& options) {
  auto recording = Recording::open(name);
  if (!recording) return tl::make_unexpected(std::move(recording.error()));
  auto machine = machine_of(*recording, name, options);
  if (!machine) return tl::make_unexpected(Messages().show_but_last(std::move(machine.error())));
  auto program = recording->program();
  if (!program) return tl::make_unexpected(std::move(program.error()));
  if (Status put = recording->put_called(folder_of_called(name), program->called()); !put)
    return tl::make_unexpected(std::move(put.error()));
  auto backend = hal::open_backend(hal::without_port(*machine));  // counts again, sends nothing
  if (!backend) return tl::make_unexpected(std::move(backend.error()));
  auto trace = recording->trace();
  if (!trace) return tl::make_unexpected(std::move(trace.error()));
  return Material{std::move(*recording), std::move(*machine), std::move(*program),
                  std::move(*backend), TraceComparison(TraceLines(std::move(*trace)))};
}

/// Runs the program; its rows go to the comparison. Returns the exit status of the run.
int run_again(const std::string& name, Material& material, Terminal& terminal) {
  const Machine& machine = material.machine;
  runtime::TraceRows rows(hal::csv_trace(comparison_sink(material.comparison),
                                         runtime::trace_header(material.program, machine), machine,
                                         runtime::row_columns(*material.backend)));
  Messages messages([&terminal] { terminal.end(); });
  Diagnostics diagnostics([&, show = messages.sink(material.program)](const Diagnostic& d) {
    if (d.severity() == Severity::error) show(d);  // the rest was reported when it was recorded
  });
  diagnostics.set_file(material.program.name());
  ipr::Reader reader = material.program.reader();
  runtime::ChannelOptions options = material.recording.meta().options;
  options.interpreter.folder = folder_of_called(name);
  options.interpreter.called = &material.program.called();
  options.interpreter.stop = terminal.stop();
  const runtime::Outcome outcome =
      runtime::simulate(reader, material.program.descriptor(), machine, options, *material.backend,
                        diagnostics, &rows, &terminal);
  terminal.end();
  const bool stopped = outcome.end == runtime::Outcome::End::stopped;
  if (!stopped && rows.finish()) material.comparison.finish();
  return worse_status(diagnostics.status(), stopped ? kSignalled + terminal.signal() : 0);
}

/// Reports a machine other than that of the recording, which an earlier version may have written
/// with fewer keys.
void compare_machines(const std::string& name, const Material& material) {
  const auto recorded = hal::parse_machine(material.recording.machine(), name, {});
  const std::string here = hal::machine_toml(material.machine);
  if (!recorded || hal::machine_toml(*recorded) == here) return;
  spdlog::info(
      "{}: replayed on a machine other than that of the recording: its hash is {} in the recording "
      "and {} here",
      name, material.recording.meta().machine_hash, hal::hash_hex(here));
}

/// Reports the result. A damaged trace whose rows nevertheless agree is an error all the same.
Result<int> verdict(const std::string& name, const Material& material, StandardOutput& out) {
  const TraceComparison& comparison = material.comparison;
  if (!comparison.status()) return tl::make_unexpected(comparison.status().error());
  if (!comparison.difference().empty()) {
    out.write(fmt::format("{}: {}", name, comparison.difference()));
    return failed({.code = Code::SC6023, .message = comparison.in_words(), .file = name});
  }
  if (const std::int64_t rows = material.recording.meta().rows; rows != comparison.rows())
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6021,
                   .message = fmt::format("its meta.json promises {} rows, its trace has {}", rows,
                                          comparison.rows()),
                   .file = name});
  if (Status good = material.recording.check_trace(); !good)
    return tl::make_unexpected(std::move(good.error()));
  spdlog::info("{}: {} rows agree", name, comparison.rows());
  return 0;
}

int replay_one(const std::string& file, const Options& options, StandardOutput& out) {
  const std::string name = file == "-" ? "<stdin>" : file;
  auto material = open_material(file, options);
  if (!material) return failed(material.error());
  compare_machines(name, *material);
  const double period = material->machine.control.period;
  Terminal terminal(options.progress, false, period);
  terminal.begin(name, static_cast<double>(material->recording.meta().rows - 1) * period);
  const int status = run_again(file, *material, terminal);
  if (status >= kSignalled) return status;
  auto result = verdict(name, *material, out);
  if (!result && result.error().file.empty()) result.error().file = name;
  return worse_status(status, result ? *result : failed(result.error()));
}

}  // namespace

int replay(const Options& options) {
  if (options.names_machine)
    if (const auto given = hal::load_machine(options.machine_file, options.settings); !given)
      return failed(given.error());
  StandardOutput out;
  int status = 0;
  for (const std::string& name : options.files) {
    status = worse_status(status, replay_one(name, options, out));
    if (status >= kSignalled) break;
  }
  return worse_status(status, out.finish());
}

}  // namespace softcnc::app
