// SPDX-License-Identifier: MIT
// The figures of a run as JSON.
#pragma once

#include <string>

#include "job/job.hpp"

namespace softcnc::app {

/// Keys and units: docs/cli.md. All of it but the CPU times and `realtime` follows from program and
/// machine alone.
std::string report_json(Job& job, const JobResult& result);

}  // namespace softcnc::app
