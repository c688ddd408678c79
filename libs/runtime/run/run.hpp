// SPDX-License-Identifier: MIT
// One run of a program: what it is made of, and what has come of it.
#pragma once

#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "runtime/program/program.hpp"
#include "runtime/run/judge.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "runtime/session/watcher.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc::runtime {

class SetpointQueue;

/// A program on a machine, and who sees its rows and its progress. All of it must outlive the run.
struct RunParts {
  Program& program;
  const Machine& machine;
  const ChannelOptions& options;
  hal::Backend& backend;
  RowSink* rows = nullptr;
  Watcher* watcher = nullptr;
  SetpointQueue* ahead = nullptr;  // of a run in real time
  bool is_judged = true;           // by judge(): not where recorded rows are the judgement
};

struct JudgedRun {
  Outcome outcome;
  Ending ending = Ending::error;
  int errors = 0;
  int status = 0;                  // exit status: the worst of the diagnostics
  std::vector<std::string> files;  // that diagnostics and lines name by number; the program first
};

/// Runs a program and judges the run. What is found goes to `show`: errors of one cause on many
/// lines once, a program in the language of another control as one error.
JudgedRun run(const RunParts& parts, Diagnostics::Sink show);

}  // namespace softcnc::runtime
