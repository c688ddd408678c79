// SPDX-License-Identifier: MIT
// The run of a job: what `run` and `record` have in common.
#pragma once

#include <string>

#include "hal/files/temporary_file.hpp"
#include "job/job.hpp"

namespace softcnc::app {

/// Where the rows of a run go.
struct TraceTarget {
  std::string file;                          // empty: nowhere, unless
  hal::TemporaryFile* compressed = nullptr;  // they are for a recording
};

/// Does the pre-flight (except for a dry run), then the motion; the rows go to `trace`. Diagnostics
/// are shown.
JobResult run_job(Job& job, const Options& options, const TraceTarget& trace);

}  // namespace softcnc::app
