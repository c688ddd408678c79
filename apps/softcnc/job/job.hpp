// SPDX-License-Identifier: MIT
// A part program on its machine, and all that is known after its run.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/program/program.hpp"
#include "runtime/realtime/realtime_cycle.hpp"
#include "runtime/run/judge.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/outcome.hpp"
#include "settings/machine_memory.hpp"
#include "settings/options.hpp"

namespace softcnc::app {

/// A program and what it runs on.
struct Job {
  runtime::Program program;
  Machine machine;
  std::string machine_file;  // beside the program; empty: its machine is another one
  runtime::ChannelOptions options;
  MachineMemory memory = {};  // of a command that keeps no state: without a file
};
Result<Job> open_job(const Options& options);

using runtime::Ending;

/// A file that a run has left, under its final name.
struct WrittenFile {
  std::string what;  // "trace", "edges", ...
  std::string file;
};

/// All that is known after a run, for the summary and the report.
struct JobResult {
  Ending ending = Ending::error;
  int status = 0;      // exit status
  bool moved = false;  // false: refused before anything moved; the rest means nothing
  runtime::Outcome outcome;
  std::array<double, kAxes> following_error{};      // mm, largest; NaN: not measured
  AxisVector settled = AxisVector::Zero();          // mm, where a following error is measured
  std::optional<hal::Backend::Tally> tally;         // of rows sent elsewhere
  std::optional<runtime::Punctuality> punctuality;  // of a run in real time
  std::vector<Diagnostic> diagnostics;
  std::vector<WrittenFile> written;
};

}  // namespace softcnc::app
