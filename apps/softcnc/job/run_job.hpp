// SPDX-License-Identifier: MIT
// The run of a job: what `run` and `record` have in common.
#pragma once

#include <string>

#include "hal/files/temporary_file.hpp"
#include "job/job.hpp"

namespace softcnc::app {

/// Where the rows of a run go.
struct TracePlace {
  std::string file;                      // empty: nowhere, unless
  hal::TemporaryFile* packed = nullptr;  // they are for a recording
};

/// Pre-flight (except for a dry run), then motion; the rows go to `trace`. Diagnostics are shown.
Performance perform(Job& job, const Options& options, const TracePlace& trace);

}  // namespace softcnc::app
