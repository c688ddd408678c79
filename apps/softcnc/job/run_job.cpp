// SPDX-License-Identifier: MIT
#include "job/run_job.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <filesystem>

#include "job/open_player.hpp"
#include "job/preflight.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "runtime/check/corner_cost.hpp"
#include "runtime/operator/position_status.hpp"
#include "runtime/run/run.hpp"
#include "runtime/sinks/trace_rows.hpp"
#include "settings/file_clash.hpp"

namespace softcnc::app {
namespace {

/// What the backend of a machine writes, if anything.
WrittenFile backend_output(const Machine& machine) {
  const bool is_edges = machine.control.backend == BackendKind::stepdir;
  return {is_edges ? "edges" : "rows", backend_file(machine).second};
}

bool on_terminal(const std::string& trace) { return trace == "-" && ::isatty(STDOUT_FILENO) != 0; }

bool may_ask(const Options& options) {
  return !options.dry_run && options.files.front() != "-" && ::isatty(STDIN_FILENO) != 0 &&
         ::isatty(STDERR_FILENO) != 0;
}

/// The run itself, after the pre-flight.
class JobRunner {
 public:
  JobRunner(Job& job, const Options& options, Messages& messages, Terminal& terminal)
      : job_(job), options_(options), messages_(messages), terminal_(terminal) {}

  /// `expected` is the outcome of the pre-flight.
  JobResult move(const TraceTarget& trace, const runtime::Outcome& expected);

 private:
  JobResult refused(const Diagnostic& diagnostic) const;
  void note_missing_fifo();
  Status mark_motion(const runtime::Outcome& expected);
  void keep_state();
  Diagnostics::Sink sink();
  void run(hal::Backend& backend, runtime::TraceRows& rows);
  bool sends_to_port() const;
  bool in_real_time() const;
  hal::Patience patience() const;
  void add_corner_cost();
  void judge_punctuality();
  bool is_dropped(const std::string& file) const;
  void close(runtime::TraceRows& rows, const std::string& trace);
  void close(hal::Backend& backend);
  void settle(const Status& finished, WrittenFile file);
  void failed_to_write(const Diagnostic& diagnostic);

  Job& job_;
  const Options& options_;
  Messages& messages_;
  Terminal& terminal_;
  JobResult result_;
};

JobResult JobRunner::refused(const Diagnostic& diagnostic) const {
  JobResult result;
  result.status = messages_.fail(diagnostic);
  return result;
}

/// Rows for later may go into a file; rows for a program that reads along would be lost in it.
void JobRunner::note_missing_fifo() {
  const Machine& machine = job_.machine;
  const std::string& file = machine.hal_stream.file;
  const bool sends = !options_.dry_run && machine.control.backend == BackendKind::hal_stream;
  std::error_code ignored;
  if (!sends || file.empty() || file == "-" || std::filesystem::exists(file, ignored)) return;
  messages_.show({.code = Code::SC6076,
                  .message = "does not exist: the rows go to a new file, and no program reads them",
                  .file = file});
}

/// A program without motion leaves the machine where it is.
Status JobRunner::mark_motion(const runtime::Outcome& expected) {
  const bool stays = expected.end == runtime::Outcome::End::done && expected.last.s == 0;
  return stays ? Status() : job_.memory.mark_motion(job_.options.state);
}

void JobRunner::keep_state() {
  const auto kept = job_.memory.keep(result_.outcome.state);
  if (!kept) result_.status = worse_status(result_.status, messages_.fail(kept.error()));
  if (kept && *kept) result_.written.push_back({"state", job_.memory.file()});
}

JobResult JobRunner::move(const TraceTarget& trace, const runtime::Outcome& expected) {
  note_missing_fifo();
  auto backend = hal::open_backend(
      options_.dry_run ? runtime::without_backend(job_.machine) : job_.machine, open_player);
  if (!backend) return refused(backend.error());
  auto rows = trace.compressed ? runtime::compressed_trace(*trace.compressed, job_.program,
                                                           job_.machine, **backend)
                               : runtime::open_trace(trace.file, job_.program, job_.machine,
                                                     **backend, options_.columns, patience());
  if (!rows) return refused(rows.error());
  if (const Status marked = mark_motion(expected); !marked) return refused(marked.error());
  if (!options_.dry_run) terminal_.begin_motion(moves_machine(job_.machine.control.backend));
  if (in_real_time() || (!options_.dry_run && moves_machine(job_.machine.control.backend)))
    terminal_.keep_the_clock();
  terminal_.begin(options_.dry_run ? "planning" : "running", expected.time, job_.program.size());
  result_.moved = true;
  run(**backend, *rows);
  close(**backend);
  close(*rows, trace.file);
  keep_state();
  return std::move(result_);
}

/// After a pre-flight only errors are news, and what a run without the backend could not know.
Diagnostics::Sink JobRunner::sink() {
  return [this, show = messages_.sink(job_.program)](const Diagnostic& diagnostic) {
    const bool is_news =
        diagnostic.severity() == Severity::error || runtime::is_of_backend(diagnostic.code);
    if (options_.dry_run || is_news) show(diagnostic);
  };
}

void JobRunner::run(hal::Backend& backend, runtime::TraceRows& rows) {
  using Pace = runtime::RealtimeCycle::Pace;
  std::optional<runtime::RealtimeCycle> ahead;
  if (in_real_time() || sends_to_port())
    ahead.emplace(backend, job_.machine.control.period,
                  in_real_time() ? Pace::clock : Pace::backend);
  runtime::JudgedRun judged = runtime::run({job_.program, job_.machine, job_.options, backend,
                                            &rows, &terminal_, ahead ? &*ahead : nullptr},
                                           sink());
  terminal_.end();
  result_.outcome = std::move(judged.outcome);
  result_.ending = judged.ending;
  result_.status = judged.status;
  if (in_real_time()) result_.punctuality = ahead->punctuality();
  result_.following_error = backend.following_error_max();
  result_.settled = backend.settle();
  if (options_.dry_run && result_.ending == Ending::done) add_corner_cost();
  if (result_.outcome.end == runtime::Outcome::End::stopped)
    result_.status = worse_status(result_.status, kSignalled + terminal_.signal());
  if (in_real_time()) judge_punctuality();
}

void JobRunner::add_corner_cost() {
  Diagnostics diagnostics(messages_.sink(job_.program));
  diagnostics.set_file(job_.program.name());
  runtime::report_corner_cost(job_.program, job_.machine, job_.options, result_.outcome, &terminal_,
                              diagnostics);
}

bool JobRunner::sends_to_port() const {
  return !options_.dry_run && job_.machine.control.backend == BackendKind::parport;
}

/// A parallel port keeps a clock of its own.
bool JobRunner::in_real_time() const { return options_.realtime && !sends_to_port(); }

/// A machine that moves by the clock waits for nobody: half a second is planned ahead.
hal::Patience JobRunner::patience() const {
  constexpr int kOfTheClock = 200;  // ms
  const bool waits = !in_real_time() && !moves_machine(job_.machine.control.backend);
  return {terminal_.stop(), waits ? -1 : kOfTheClock};
}

/// Without the rights nothing was promised.
void JobRunner::judge_punctuality() {
  const runtime::Punctuality& punctuality = *result_.punctuality;
  const runtime::RealtimeRights& rights = punctuality.rights;
  if (!rights.all())
    messages_.show({.code = Code::SC6075, .message = "no real-time rights: " + rights.refusal});
  if (punctuality.overruns() == 0) return;
  const Diagnostic missed = runtime::missed_periods(punctuality, job_.program.name());
  messages_.show(missed);
  result_.status = worse_status(result_.status, exit_status(missed));
}

/// After an error in program or output a file is not whole, and what it would replace stays. What
/// has gone down a pipe has gone.
bool JobRunner::is_dropped(const std::string& file) const {
  return result_.ending == Ending::error && hal::is_replaced(file);
}

void JobRunner::close(runtime::TraceRows& rows, const std::string& trace) {
  if (is_dropped(trace) && rows.ok()) return;  // otherwise its error is still to be shown
  if (result_.outcome.end == runtime::Outcome::End::done) rows.add_hash_of(job_.program);
  settle(rows.finish(), {"trace", trace});
}

void JobRunner::close(hal::Backend& backend) {
  WrittenFile output = backend_output(options_.dry_run ? Machine() : job_.machine);
  if (!is_dropped(output.file)) settle(backend.finish(), std::move(output));
  result_.tally = backend.tally();
}

void JobRunner::settle(const Status& finished, WrittenFile file) {
  if (!finished) return failed_to_write(finished.error());
  if (!file.file.empty() && file.file != "-") result_.written.push_back(std::move(file));
}

void JobRunner::failed_to_write(const Diagnostic& diagnostic) {
  result_.ending = Ending::error;
  result_.status = worse_status(result_.status, messages_.fail(diagnostic));
}

void explain(std::string_view what, const runtime::Outcome& outcome) {
  spdlog::debug(
      "{}: {} nodes planned in {} passes; CPU {:.3f} s planning, {:.3f} s cycle, {:.3f} s "
      "verification, {:.3f} s output",
      what, outcome.planner.nodes, outcome.planner.passes, outcome.cpu.planning, outcome.cpu.cycle,
      outcome.cpu.verification, outcome.cpu.output);
}

/// The pre-flight; `expected` becomes its outcome.
JobResult check_first(Job& job, Messages& messages, Terminal& terminal,
                      runtime::Outcome& expected) {
  terminal.begin("checking", 0, job.program.size());
  Preflight checked = preflight(job.program, job.machine, job.options, messages, &terminal);
  terminal.end();
  explain("pre-flight", checked.outcome);
  JobResult result;
  result.status = checked.status;
  if (checked.outcome.end == runtime::Outcome::End::stopped) {
    result.status = worse_status(checked.status, kSignalled + terminal.signal());
    if (checked.status == 0) result.ending = Ending::stopped;
  }
  expected = std::move(checked.outcome);
  return result;
}

}  // namespace

JobResult run_job(Job& job, const Options& options, const TraceTarget& trace) {
  Terminal terminal(options.progress, on_terminal(trace.file), job.machine.control.period);
  Messages messages([&terminal] { terminal.end(); });
  job.options.interpreter.stop = terminal.stop();
  runtime::Outcome expected;
  JobResult result;
  if (!options.dry_run) result = check_first(job, messages, terminal, expected);
  if (result.status == 0) {
    if (may_ask(options))
      terminal.wait_at_stops(options.realtime || moves_machine(job.machine.control.backend));
    result = JobRunner(job, options, messages, terminal).move(trace, expected);
    if (!options.dry_run) result.outcome.time_sheet.corner_cost = expected.time_sheet.corner_cost;
    if (result.moved) explain("run", result.outcome);
  }
  result.diagnostics.assign(messages.kept().begin(), messages.kept().end());
  return result;
}

}  // namespace softcnc::app
