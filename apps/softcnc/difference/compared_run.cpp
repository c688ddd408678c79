// SPDX-License-Identifier: MIT
#include "difference/compared_run.hpp"

#include <utility>

#include "hal/backends/backend.hpp"
#include "hal/machine/machine_file.hpp"
#include "job/job.hpp"
#include "runtime/history/read_trace.hpp"
#include "runtime/history/run_rows.hpp"
#include "runtime/run/run.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::app {
namespace {

/// The machine is not known where a later version has written it.
Status read_recording(const std::string& file, ComparedRun& run) {
  const auto recording = Recording::open(file);
  if (!recording) return tl::make_unexpected(recording.error());
  if (auto machine = hal::parse_machine(recording->machine(), file, {}))
    run.machine = std::move(*machine);
  return read_rows(*recording, file, run.rows);
}

Status read_trace_file(const std::string& file, runtime::RowStore& rows) {
  const auto facts = runtime::read_trace(file, rows);
  if (!facts) return tl::make_unexpected(facts.error());
  return rows.finish(facts->period);
}

/// Runs it on the simulated mill, if its machine is one; returns the exit status.
Result<int> run_program(const std::string& file, Options options, ComparedRun& run,
                        Messages& messages, Terminal& terminal) {
  options.files = {file};
  options.dry_run = true;
  auto job = open_job(options);
  if (!job) return tl::make_unexpected(std::move(job.error()));
  auto backend = hal::open_backend(hal::without_port(job->machine));
  if (!backend) return tl::make_unexpected(std::move(backend.error()));
  const double period = job->machine.control.period;
  job->options.interpreter.stop = terminal.stop();
  terminal.begin(file, 0, job->program.size());
  terminal.begin_run(0, period);
  runtime::RunRows sink(run.rows, runtime::knows_contour(**backend));
  const runtime::JudgedRun judged =
      runtime::run({job->program, job->machine, job->options, **backend, &sink, &terminal},
                   messages.sink(job->program));
  terminal.end();
  if (judged.outcome.end == runtime::Outcome::End::stopped)
    return worse_status(judged.status, kSignalled + terminal.signal());
  if (Status kept = run.rows.finish(period); !kept) return tl::make_unexpected(kept.error());
  run.machine = std::move(job->machine);
  return judged.status;
}

}  // namespace

Status read_rows(const Recording& recording, const std::string& name, runtime::RowStore& rows) {
  if (Status good = recording.check_trace(); !good) return good;
  auto trace = recording.trace();
  if (!trace) return tl::make_unexpected(std::move(trace.error()));
  const auto facts = runtime::read_trace(std::move(*trace), name, rows);
  if (!facts) return tl::make_unexpected(facts.error());
  return rows.finish(facts->period);
}

Result<ComparedRun> read_compared(const std::string& file, const Options& options,
                                  Messages& messages, Terminal& terminal) {
  ComparedRun run{.name = file == "-" ? "<stdin>" : file, .kind = input_kind(file)};
  if (run.kind == InputKind::program) {
    const auto status = run_program(file, options, run, messages, terminal);
    if (!status) return tl::make_unexpected(status.error());
    run.status = *status;
    return run;
  }
  const Status read =
      run.kind == InputKind::trace ? read_trace_file(file, run.rows) : read_recording(file, run);
  if (!read) {
    Diagnostic error = read.error();
    if (error.file.empty()) error.file = run.name;
    return tl::make_unexpected(std::move(error));
  }
  return run;
}

}  // namespace softcnc::app
