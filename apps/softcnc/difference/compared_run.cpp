// SPDX-License-Identifier: MIT
#include "difference/compared_run.hpp"

#include <utility>

#include "hal/backends/backend.hpp"
#include "job/job.hpp"
#include "recording/recording.hpp"
#include "runtime/check/check.hpp"
#include "runtime/history/read_trace.hpp"
#include "runtime/history/run_rows.hpp"
#include "runtime/run/run.hpp"

namespace softcnc::app {
namespace {

Status read_trace_file(const std::string& file, runtime::RowStore& rows) {
  const auto facts = runtime::read_trace(file, rows);
  if (!facts) return tl::make_unexpected(facts.error());
  return rows.finish(facts->period);
}

/// Runs it without backend; returns the exit status.
Result<int> run_program(const std::string& file, Options options, runtime::RowStore& rows,
                        Messages& messages, Terminal& terminal) {
  options.files = {file};
  options.dry_run = true;
  auto job = open_job(options);
  if (!job) return tl::make_unexpected(std::move(job.error()));
  auto backend = hal::open_backend(runtime::without_backend(job->machine));
  if (!backend) return tl::make_unexpected(std::move(backend.error()));
  const double period = job->machine.control.period;
  job->options.interpreter.stop = terminal.stop();
  terminal.begin(file, 0, job->program.size());
  terminal.begin_run(0, period);
  runtime::RunRows sink(rows, false);
  const runtime::JudgedRun judged =
      runtime::run({job->program, job->machine, job->options, **backend, &sink, &terminal},
                   messages.sink(job->program));
  terminal.end();
  if (judged.outcome.end == runtime::Outcome::End::stopped)
    return worse_status(judged.status, kSignalled + terminal.signal());
  if (Status kept = rows.finish(period); !kept) return tl::make_unexpected(kept.error());
  return judged.status;
}

}  // namespace

Status read_recording(const std::string& file, runtime::RowStore& rows) {
  const auto recording = Recording::open(file);
  if (!recording) return tl::make_unexpected(recording.error());
  if (Status good = recording->check_trace(); !good) return good;
  auto trace = recording->trace();
  if (!trace) return tl::make_unexpected(std::move(trace.error()));
  const auto facts = runtime::read_trace(std::move(*trace), file, rows);
  if (!facts) return tl::make_unexpected(facts.error());
  return rows.finish(facts->period);
}

Result<ComparedRun> read_compared(const std::string& file, const Options& options,
                                  Messages& messages, Terminal& terminal) {
  ComparedRun run{file == "-" ? "<stdin>" : file, input_kind(file), {}, 0};
  if (run.kind == InputKind::program) {
    const auto status = run_program(file, options, run.rows, messages, terminal);
    if (!status) return tl::make_unexpected(status.error());
    run.status = *status;
    return run;
  }
  const Status read = run.kind == InputKind::trace ? read_trace_file(file, run.rows)
                                                   : read_recording(file, run.rows);
  if (!read) {
    Diagnostic error = read.error();
    if (error.file.empty()) error.file = run.name;
    return tl::make_unexpected(std::move(error));
  }
  return run;
}

}  // namespace softcnc::app
