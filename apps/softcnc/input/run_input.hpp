// SPDX-License-Identifier: MIT
// Reads a run from whatever file it comes from: a program is run, a trace or a recording is read.
#pragma once

#include <string>

#include "input/reported_run.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// Reads the run of a file. A program is run on its machine, with `options`, without sending
/// anything; where it has errors, they are shown and are in the result, which then may have no
/// motion. Errors: those of opening files, SC6xxx and SC7xxx.
Result<ReportedRun> read_run(const std::string& file, const Options& options, Terminal& terminal,
                             Messages& messages);

}  // namespace softcnc::app
