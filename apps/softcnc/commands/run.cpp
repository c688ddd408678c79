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

void keep_state(MachineMemory& memory, const std::string& file, Performance& performance) {
  const auto kept = memory.keep(performance.outcome.state);
  if (!kept) performance.status = worse_status(performance.status, failed(kept.error()));
  if (kept && *kept) performance.written.push_back({"state", file});
}

}  // namespace

int run(const Options& options) {
  auto lock = hal::FileLock::take(options.dry_run ? "" : options.state);
  if (!lock) return failed(lock.error());
  auto job = open_job(options);
  if (!job) return failed(job.error());
  auto memory = MachineMemory::open(options.dry_run ? "" : options.state, job->options.state);
  if (!memory) return failed(memory.error());
  job->options.keeps_state = !options.dry_run && !options.state.empty();
  const std::string trace = options.dry_run && options.trace.empty() ? "-" : options.trace;
  Performance performance = perform(*job, options, {trace});
  if (performance.moved) keep_state(*memory, options.state, performance);
  return conclude(*job, options, performance);
}

}  // namespace softcnc::app
