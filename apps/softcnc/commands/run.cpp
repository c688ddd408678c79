// SPDX-License-Identifier: MIT
// `softcnc run`: pre-flight, motion, summary.
#include "commands/commands.hpp"
#include "hal/files/file_lock.hpp"
#include "job/run_job.hpp"
#include "messages/messages.hpp"
#include "output/finish_job.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

void keep_state(MachineMemory& memory, const std::string& file, JobResult& result) {
  const auto kept = memory.keep(result.outcome.state);
  if (!kept) result.status = worse_status(result.status, failed(kept.error()));
  if (kept && *kept) result.written.push_back({"state", file});
}

}  // namespace

int run(const Options& options) {
  auto lock = hal::FileLock::take(options.dry_run ? "" : options.state);
  if (!lock) return failed(lock.error());
  auto job = open_job(options);
  if (!job) return failed(job.error());
  auto memory =
      MachineMemory::open(options.dry_run ? "" : options.state,
                          options.work.empty() ? std::optional(job->options.state) : std::nullopt);
  if (!memory) return failed(memory.error());
  job->options.keeps_state = !options.dry_run && !options.state.empty();
  const std::string trace = options.dry_run && options.trace.empty() ? "-" : options.trace;
  JobResult result = run_job(*job, options, {trace});
  if (result.moved) keep_state(*memory, options.state, result);
  return finish_job(*job, options, result);
}

}  // namespace softcnc::app
