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
bool worth_keeping(const JobResult& result) {
  return result.moved && (result.ending == Ending::done || result.ending == Ending::alarm);
}

void keep(Job& job, hal::OutputFile& file, const std::string& to, JobResult& result,
          const hal::TemporaryFile& trace) {
  RecordingMeta meta;
  meta.rows = result.outcome.setpoints;
  meta.options = job.options;
  for (const ipr::FoundFile& called : result.outcome.called_files)
    meta.called.push_back({called.name, {}, called.path});
  const Status written = write_recording(file, job.program, job.machine, meta, trace);
  if (written)
    result.written.push_back({"recording", to});
  else
    result.status = worse_status(result.status, failed(written.error()));
}

}  // namespace

int record(const Options& options) {
  auto job = open_job(options);
  if (!job) return failed(job.error());
  const auto file = hal::OutputFile::open(options.output);  // before anything moves
  if (!file) return failed(file.error());
  auto trace = hal::TemporaryFile::make();
  if (!trace) return failed(trace.error());
  JobResult result = run_job(*job, options, {"", &*trace});
  const bool kept = worth_keeping(result);
  if (kept) keep(*job, **file, options.output, result, *trace);
  const int status = finish_job(*job, options, result);
  if (result.moved && !kept) spdlog::warn("no recording is written of a run that did not finish");
  return status;
}

}  // namespace softcnc::app
