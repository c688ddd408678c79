// SPDX-License-Identifier: MIT
// `softcnc run`: pre-flight, motion, summary.
#include "commands.hpp"
#include "messages.hpp"
#include "performance.hpp"

namespace softcnc::app {

int run(const Options& options) {
  auto job = open_job(options);
  if (!job) return failed(job.error());
  const std::string trace = options.dry_run && options.trace.empty() ? "-" : options.trace;
  return conclude(*job, options, perform(*job, options, trace));
}

}  // namespace softcnc::app
