// SPDX-License-Identifier: MIT
// Runs whose rows have been written down, for a report.
#pragma once

#include <string>

#include "input/reported_run.hpp"

namespace softcnc::app {

/// Reads a trace. Errors: those of runtime::read_trace().
Result<ReportedRun> read_trace_run(const std::string& file);

/// Reads a recording: the rows that were recorded, its machine, and the text of its program.
/// Errors: those of Recording, of its machine file and of runtime::read_trace().
Result<ReportedRun> read_recording_run(const std::string& file);

}  // namespace softcnc::app
