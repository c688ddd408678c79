// SPDX-License-Identifier: MIT
// `softcnc run`: pre-flight, motion, summary.
#include "commands/commands.hpp"
#include "job/run_job.hpp"
#include "messages/messages.hpp"
#include "output/finish_job.hpp"

namespace softcnc::app {

int run(const Options& options) {
  auto job = open_job(options);
  if (!job) return failed(job.error());
  const std::string trace = options.dry_run && options.trace.empty() ? "-" : options.trace;
  JobResult result = run_job(*job, options, {trace});
  return finish_job(*job, options, result);
}

}  // namespace softcnc::app
