// SPDX-License-Identifier: MIT
#include "input/trace_run.hpp"

#include <utility>

#include "hal/machine/machine_file.hpp"
#include "input/program_run.hpp"
#include "messages/messages.hpp"
#include "recording/recording.hpp"
#include "runtime/history/read_trace.hpp"
#include "runtime/history/row_times.hpp"

namespace softcnc::app {
namespace {

/// `read` passes the rows to a sink and returns the facts of the trace.
template <typename Read>
Status read_rows(ReportedRun& run, const Read& read) {
  const Machine* machine = run.machine ? &*run.machine : nullptr;
  if (machine) run.period = machine->control.period;
  run.history = std::make_unique<runtime::RunHistory>(run.period, machine);
  runtime::RowTimes times;
  runtime::BothSinks sinks(*run.history, times);
  const Result<runtime::TraceFacts> facts = read(sinks);
  if (!facts) return tl::make_unexpected(facts.error());
  run.history->finish();
  run.period = facts->period;
  run.history->set_period(run.period);
  run.time = times.time(run.period);
  run.length = times.last().s;
  run.setpoints = times.rows();
  run.blocks = times.last().block;
  run.time_by_limit = times.by_limit(run.period);
  run.lines = times.by_line(run.period);
  run.ending = Ending::done;
  return {};
}

}  // namespace

Result<ReportedRun> read_trace_run(const std::string& file) {
  ReportedRun run;
  run.kind = InputKind::trace;
  run.name = file;
  run.files = {{file, std::nullopt}};
  if (Status read = read_rows(
          run, [&](runtime::RunRowSink& rows) { return runtime::read_trace(file, rows); });
      !read)
    return tl::make_unexpected(std::move(read.error()));
  return run;
}

Result<ReportedRun> read_recording_run(const std::string& file) {
  auto recording = Recording::open(file);
  if (!recording) return tl::make_unexpected(std::move(recording.error()));
  auto machine = hal::parse_machine(recording->machine(), file + ":machine.toml", {});
  if (!machine) return tl::make_unexpected(Messages().show_but_last(std::move(machine.error())));
  auto program = recording->program();
  if (!program) return tl::make_unexpected(std::move(program.error()));
  ReportedRun run;
  run.kind = InputKind::recording;
  run.name = recording->meta().program_name;
  run.machine = std::move(*machine);
  run.files = {{run.name, program_text(*program)}};
  auto trace = recording->trace();
  if (!trace) return tl::make_unexpected(std::move(trace.error()));
  if (Status read = read_rows(run,
                              [&](runtime::RunRowSink& rows) {
                                return runtime::read_trace(std::move(*trace), file, rows);
                              });
      !read)
    return tl::make_unexpected(std::move(read.error()));
  return run;
}

}  // namespace softcnc::app
