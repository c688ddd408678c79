// SPDX-License-Identifier: MIT
// `softcnc record`: run, and keep what replay needs.
#include <spdlog/spdlog.h>

#include "commands/commands.hpp"
#include "job/run_job.hpp"
#include "messages/messages.hpp"
#include "output/finish_job.hpp"
#include "recording/recording.hpp"

namespace softcnc::app {
namespace {

/// A run that was stopped by hand cannot be run again as it was.
bool worth_keeping(const Performance& performance) {
  return performance.moved &&
         (performance.ending == Ending::done || performance.ending == Ending::alarm);
}

void keep(Job& job, hal::OutputFile& file, const std::string& to, Performance& performance,
          const hal::TemporaryFile& trace) {
  RecordingMeta meta;
  meta.rows = performance.outcome.setpoints;
  meta.options = job.options;
  for (const std::string& name : performance.outcome.called_files)
    meta.called.push_back({name, {}});
  const Status written = write_recording(file, job.program, job.machine, meta, trace);
  if (written)
    performance.written.push_back({"recording", to});
  else
    performance.status = worse_status(performance.status, failed(written.error()));
}

}  // namespace

int record(const Options& options) {
  auto job = open_job(options);
  if (!job) return failed(job.error());
  const auto file = hal::OutputFile::open(options.output);  // before anything moves
  if (!file) return failed(file.error());
  auto trace = hal::TemporaryFile::make();
  if (!trace) return failed(trace.error());
  Performance performance = perform(*job, options, {"", &*trace});
  const bool kept = worth_keeping(performance);
  if (kept) keep(*job, **file, options.output, performance, *trace);
  const int status = conclude(*job, options, performance);
  if (performance.moved && !kept)
    spdlog::warn("no recording is kept of a run that did not come to its end");
  return status;
}

}  // namespace softcnc::app
