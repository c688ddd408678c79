// SPDX-License-Identifier: MIT
#include "replay/replay_run.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include "difference/compared_run.hpp"
#include "difference/difference_text.hpp"
#include "hal/files/hash.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/trace/trace_csv.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "recording/recording.hpp"
#include "recording/trace_comparison.hpp"
#include "runtime/history/run_rows.hpp"
#include "runtime/run/run.hpp"
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
  program->set_folder(folder_of_called(name));
  return Material{std::move(*recording), std::move(*machine), std::move(*program),
                  std::move(*backend)};
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

/// What a difference comes to for somebody who waits for the part, and for the part.
std::string effect_text(const runtime::RunDifference& difference) {
  const runtime::TimePair& time = difference.time;
  std::string text = difference.of(runtime::Aspect::time).same
                         ? fmt::format("takes {:.6g} s as recorded", time.a)
                         : fmt::format("takes {:.6g} s instead of {:.6g} s ({:+.3g} %)", time.b,
                                       time.a, time.a > 0 ? 100 * time.difference() / time.a : 0);
  if (difference.of(runtime::Aspect::path).same) return text + ", on the same path";
  if (!difference.distance) return text;
  return text + fmt::format(", up to {} off the recorded path",
                            amount(runtime::Aspect::path, difference.distance->distance));
}

class Replay {
 public:
  Replay(std::string file, std::string label, const Options& options)
      : file_(std::move(file)), label_(std::move(label)), options_(options) {
    result_.name = file_ == "-" ? "<stdin>" : file_;
  }

  ReplayResult run();

 private:
  Status compare();
  Status judge(const Material& material, const TraceComparison& comparison);
  Status add_effect();
  Status bless();
  runtime::JudgedRun run_again(Material& material, runtime::RowSink& rows, Terminal& terminal);
  void fail(Diagnostic error);

  std::string file_, label_;
  const Options& options_;
  ReplayResult result_;
};

ReplayResult Replay::run() {
  const auto begin = std::chrono::steady_clock::now();
  if (Status compared = compare(); !compared) fail(std::move(compared.error()));
  if (result_.end == ReplayEnd::differs && result_.status == 0)
    if (Status added = add_effect(); !added) fail(std::move(added.error()));
  const bool blesses = options_.bless && result_.end == ReplayEnd::differs && result_.status == 0;
  if (blesses)
    if (Status blessed = bless(); !blessed) fail(std::move(blessed.error()));
  if (result_.end == ReplayEnd::differs)
    result_.status = worse_status(
        result_.status,
        failed({.code = Code::SC6023, .message = result_.message, .file = result_.name}));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  result_.seconds = took.count();
  return std::move(result_);
}

void Replay::fail(Diagnostic error) {
  if (error.file.empty()) error.file = result_.name;
  result_.end = ReplayEnd::error;
  result_.code = code_name(error.code);
  result_.message = error.message;
  result_.status = worse_status(result_.status, failed(error));
}

/// Runs the program; its rows go to `rows`.
runtime::JudgedRun Replay::run_again(Material& material, runtime::RowSink& rows,
                                     Terminal& terminal) {
  const double period = material.machine.control.period;
  terminal.begin(label_, static_cast<double>(material.recording.meta().rows - 1) * period);
  Messages messages([&terminal] { terminal.end(); });
  runtime::ChannelOptions options = material.recording.meta().options;
  options.interpreter.folder = material.program.folder();
  options.interpreter.subprogram_folders =
      material.recording.folders_of_called(material.program.folder());
  options.interpreter.called = &material.program.called();
  options.interpreter.stop = terminal.stop();
  runtime::JudgedRun rerun =
      runtime::run({.program = material.program,
                    .machine = material.machine,
                    .options = options,
                    .backend = *material.backend,
                    .rows = &rows,
                    .watcher = &terminal,
                    .is_judged = false},
                   [show = messages.sink(material.program)](const Diagnostic& d) {
                     if (d.severity() == Severity::error)
                       show(d);  // the rest was reported when it was recorded
                   });
  terminal.end();
  if (rerun.outcome.end == runtime::Outcome::End::stopped)
    rerun.status = worse_status(rerun.status, kSignalled + terminal.signal());
  return rerun;
}

/// The first run: against the recorded trace.
Status Replay::compare() {
  auto material = open_material(file_, options_);
  if (!material) return tl::make_unexpected(std::move(material.error()));
  auto recorded = material->recording.trace();
  if (!recorded) return tl::make_unexpected(std::move(recorded.error()));
  compare_machines(result_.name, *material);
  TraceComparison comparison{TraceLines(std::move(*recorded))};
  runtime::TraceRows rows(hal::csv_trace(
      comparison_sink(comparison), runtime::trace_header(material->program, material->machine),
      material->machine, runtime::row_columns(*material->backend)));
  Terminal terminal(options_.progress, false, material->machine.control.period);
  const runtime::JudgedRun rerun = run_again(*material, rows, terminal);
  result_.status = rerun.status;
  if (rerun.status >= kSignalled) return {};
  const bool stopped = rerun.outcome.end == runtime::Outcome::End::stopped;
  if (!stopped && rows.finish()) comparison.finish();
  return judge(*material, comparison);
}

/// A damaged trace whose rows nevertheless agree is an error all the same.
Status Replay::judge(const Material& material, const TraceComparison& comparison) {
  if (!comparison.status()) return comparison.status();
  result_.rows = comparison.rows();
  if (!comparison.difference().empty()) {
    result_.end = ReplayEnd::differs;
    result_.code = code_name(Code::SC6023);
    result_.message = comparison.in_words();
    result_.table = comparison.difference();
    return {};
  }
  if (const std::int64_t rows = material.recording.meta().rows; rows != comparison.rows())
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6021,
                   .message = fmt::format("its meta.json promises {} rows, its trace has {}", rows,
                                          comparison.rows())});
  if (Status good = material.recording.check_trace(); !good) return good;
  if (result_.status == 0)
    result_.end = ReplayEnd::agrees;
  else
    result_.message = "its program has errors";
  return {};
}

/// Another run, compared as a whole: what the difference means comes before the row that shows it.
Status Replay::add_effect() {
  auto material = open_material(file_, options_);
  if (!material) return tl::make_unexpected(std::move(material.error()));
  runtime::RowStore recorded, here;
  if (!read_rows(material->recording, file_, recorded)) return {};  // damaged: its row stands alone
  const double period = material->machine.control.period;
  Terminal terminal(options_.progress, false, period);
  runtime::RunRows rows(here, false);
  const runtime::JudgedRun rerun = run_again(*material, rows, terminal);
  result_.status = worse_status(result_.status, rerun.status);
  if (rerun.status != 0) return {};
  if (Status kept = here.finish(period); !kept) return kept;
  const std::string effect =
      effect_text(runtime::compare(recorded, here, runtime::replay_margins()));
  result_.message = effect + "; " + result_.message;
  result_.table = effect + '\n' + result_.table;
  return {};
}

/// The second run: into a new recording, which replaces the old one when it is complete.
Status Replay::bless() {
  auto material = open_material(file_, options_);
  if (!material) return tl::make_unexpected(std::move(material.error()));
  auto trace = hal::TemporaryFile::make();
  if (!trace) return tl::make_unexpected(std::move(trace.error()));
  auto rows =
      runtime::compressed_trace(*trace, material->program, material->machine, *material->backend);
  if (!rows) return tl::make_unexpected(std::move(rows.error()));
  Terminal terminal(options_.progress, false, material->machine.control.period);
  const runtime::JudgedRun rerun = run_again(*material, *rows, terminal);
  result_.status = worse_status(result_.status, rerun.status);
  if (rerun.status >= kSignalled) return {};
  if (Status finished = rows->finish(); !finished) return finished;
  if (rerun.errors > 0 || rerun.outcome.end != runtime::Outcome::End::done)
    return tl::make_unexpected(
        Diagnostic{.code = Code::SC6026,
                   .message = rerun.errors > 0 ? "is not made again: its program has errors"
                                               : "is not made again: its run ends by an alarm"});
  RecordingMeta meta = material->recording.meta();
  meta.rows = rerun.outcome.setpoints;
  clear_leftovers(file_);
  const auto file = hal::OutputFile::open(file_);
  if (!file) return tl::make_unexpected(file.error());
  if (Status written =
          write_recording(**file, material->program, material->machine, std::move(meta), *trace);
      !written)
    return written;
  result_.end = ReplayEnd::blessed;
  return {};
}

}  // namespace

std::string_view name(ReplayEnd end) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"agrees", "differs", "blessed", "error"};
  return kNames[static_cast<std::size_t>(end)];
}

ReplayResult replay_recording(const std::string& file, const std::string& label,
                              const Options& options) {
  return Replay(file, label, options).run();
}

}  // namespace softcnc::app
