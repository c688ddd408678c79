// SPDX-License-Identifier: MIT
// The run of a part program on its simulated machine, for a report.
#pragma once

#include "input/reported_run.hpp"
#include "job/terminal.hpp"
#include "messages/messages.hpp"
#include "runtime/program/program.hpp"

namespace softcnc::app {

/// Runs a program. What is wrong with it is shown and is in the result. Errors: those of opening
/// the simulated backend.
Result<ReportedRun> run_program(Job& job, Terminal& terminal, Messages& messages);

/// Returns the text of a program.
std::string program_text(runtime::Program& program);

}  // namespace softcnc::app
