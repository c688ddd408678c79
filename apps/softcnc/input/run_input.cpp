// SPDX-License-Identifier: MIT
#include "input/run_input.hpp"

#include "input/program_run.hpp"
#include "input/surface_run.hpp"
#include "input/trace_run.hpp"

namespace softcnc::app {
namespace {

/// Where a program asks for a roughness, its surface is cut, too.
Status add_surface(Job& job, Terminal& terminal, ReportedRun& run) {
  if (run.ending != Ending::done || !run.history->knows(&runtime::HistoryNode::rmax)) return {};
  auto surface = cut_surface(job, terminal);
  if (!surface) return tl::make_unexpected(std::move(surface.error()));
  run.surface = std::move(*surface);
  return {};
}

Result<ReportedRun> read_program(const std::string& file, const Options& options,
                                 Terminal& terminal, Messages& messages) {
  Options of_file = options;
  of_file.files = {file};
  auto job = open_job(of_file);
  if (!job) return tl::make_unexpected(std::move(job.error()));
  auto run = run_program(*job, terminal, messages);
  if (!run) return run;
  if (Status added = add_surface(*job, terminal, *run); !added)
    return tl::make_unexpected(std::move(added.error()));
  return run;
}

Result<ReportedRun> named(Result<ReportedRun> run, const std::string& file) {
  if (!run && run.error().file.empty()) run.error().file = file;
  return run;
}

}  // namespace

Result<ReportedRun> read_run(const std::string& file, const Options& options, Terminal& terminal,
                             Messages& messages) {
  switch (input_kind(file)) {
    case InputKind::program:
      return read_program(file, options, terminal, messages);
    case InputKind::trace:
      return named(read_trace_run(file), file);
    case InputKind::recording:
      return named(read_recording_run(file), file);
  }
  return {};
}

}  // namespace softcnc::app
