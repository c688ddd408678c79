// SPDX-License-Identifier: MIT
// `softcnc run`: pre-flight, motion, summary.
#include "commands.hpp"
#include "machine_memory.hpp"
#include "messages.hpp"
#include "performance.hpp"

namespace softcnc::app {

int run(const Options& options) {
  auto job = open_job(options);
  if (!job) return failed(job.error());
  auto memory = MachineMemory::open(options.dry_run ? "" : options.state, job->options.state);
  if (!memory) return failed(memory.error());
  job->options.keeps_state = !options.dry_run && !options.state.empty();
  const std::string trace = options.dry_run && options.trace.empty() ? "-" : options.trace;
  const Performance performance = perform(*job, options, trace);
  const int status = conclude(*job, options, performance);
  if (!performance.moved) return status;
  const Status kept = memory->keep(performance.outcome.state);
  return kept ? status : worse_status(status, failed(kept.error()));
}

}  // namespace softcnc::app
