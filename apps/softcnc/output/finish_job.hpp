// SPDX-License-Identifier: MIT
// The end of a job: summary, report and exit status.
#pragma once

#include "job/job.hpp"

namespace softcnc::app {

/// Writes the report where one is asked for, and prints the summary, which names the files that
/// have been written. Returns the exit status of the job.
int finish_job(Job& job, const Options& options, JobResult& result);

}  // namespace softcnc::app
