// SPDX-License-Identifier: MIT
#include "input/program_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "hal/backends/backend.hpp"
#include "motion/core/units.hpp"
#include "runtime/history/run_rows.hpp"
#include "runtime/run/run.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::app {
namespace {

std::vector<RunFigure> contour_figures(const runtime::Outcome& outcome) {
  if (!outcome.contour || outcome.contour->cutting.instants == 0) return {};
  const ContourFigures& cutting = outcome.contour->cutting;
  return {{"contour error, largest", um_from_mm(cutting.max), "um"},
          {"contour error, rms", um_from_mm(cutting.rms()), "um"}};
}

std::vector<RunFigure> figures_of(const runtime::Outcome& outcome, const Machine& machine) {
  const Measured& measured = outcome.measured;
  std::vector<RunFigure> figures = contour_figures(outcome);
  const auto add = [&figures](std::string name, double value, std::string unit) {
    figures.push_back({std::move(name), value, std::move(unit)});
  };
  if (is_by_pulses(machine.control.interpolation))
    add("distance of the staircase from the path", um_from_mm(measured.path_deviation), "um");
  else if (accelerates_after(machine.control.interpolation))
    add("distance from the path", um_from_mm(measured.path_deviation), "um");
  else
    add("chord error", um_from_mm(measured.chord_error), "um");
  if (outcome.corner_deviation > 0)
    add("distance from the programmed path", um_from_mm(outcome.corner_deviation), "um");
  if (measured.rmax_target > 0) {
    add("predicted Rmax", um_from_mm(measured.rmax), "um");
    add("requested Rmax there", um_from_mm(measured.rmax_target), "um");
  }
  add("feed fluctuation, rms", 100 * measured.feed_fluctuation_rms, "%");
  for (int i = 0; i < kAxes; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    if (!machine.axes[axis].present) continue;
    const std::string of_axis = std::string(" of ") + kAxisLetters[axis];
    add("largest velocity" + of_axis, measured.velocity[i], "mm/s");
    add("largest acceleration" + of_axis, measured.acceleration[i], "mm/s2");
    if (machine.axes[axis].jerk > 0) add("largest jerk" + of_axis, measured.jerk[i], "mm/s3");
  }
  return figures;
}

std::optional<std::string> text_of(const ipr::Snapshot& snapshot) {
  std::string text, piece(65536, '\0');
  off_t at = 0;
  for (;;) {
    const ssize_t n = ::pread(snapshot.descriptor(), piece.data(), piece.size(), at);
    if (n < 0) return std::nullopt;
    if (n == 0) return text;
    text.append(piece, 0, static_cast<std::size_t>(n));
    at += n;
  }
}

/// The files that lines or diagnostics name, by number; the program itself first.
std::vector<ReportedFile> files_of(runtime::Program& program, const std::vector<std::string>& names,
                                   const std::vector<runtime::LineTime>& lines) {
  std::vector<ReportedFile> files{{program.name(), program_text(program)}};
  int last = 0;
  for (const runtime::LineTime& line : lines) last = std::max(last, line.file);
  program.called().close();
  for (int i = 1; i <= last; ++i) {
    ReportedFile& file =
        files.emplace_back(ReportedFile{names[static_cast<std::size_t>(i)], std::nullopt});
    const auto& found = program.called().find(file.name);
    if (found && *found) file.text = text_of(**found);
  }
  return files;
}

void take_figures(const runtime::Outcome& outcome, ReportedRun& run) {
  run.time = outcome.time;
  run.length = outcome.last.s;
  run.setpoints = outcome.setpoints;
  run.blocks = outcome.last.block;
  run.time_by_limit = outcome.time_by_limit;
  run.sheet = outcome.time_sheet;
  run.figures = figures_of(outcome, *run.machine);
  run.lines = outcome.line_times;
  run.origins = outcome.origins;
  run.stocks = outcome.stocks;
  if (outcome.contour && outcome.contour->cutting.instants > 0)
    run.largest_contour = outcome.contour->cutting.max;
}

}  // namespace

std::string program_text(runtime::Program& program) {
  std::string text;
  program.for_each_piece([&text](std::string_view piece) { text += piece; });
  return text;
}

Result<ReportedRun> run_program(Job& job, Terminal& terminal, Messages& messages) {
  terminal.begin("running", 0, job.program.size());
  const Machine machine = hal::without_port(job.machine);
  auto backend = hal::open_backend(machine);
  if (!backend) return tl::make_unexpected(std::move(backend.error()));
  ReportedRun run;
  run.name = job.program.name();
  run.machine = machine;
  run.machine_file = job.machine_file;
  run.period = machine.control.period;
  run.history = std::make_unique<runtime::RunHistory>(run.period, &machine);
  runtime::RunRows rows(*run.history, runtime::knows_contour(**backend));
  job.options.line_times = true;
  job.options.interpreter.stop = terminal.stop();
  const runtime::JudgedRun judged =
      runtime::run({job.program, machine, job.options, **backend, &rows, &terminal},
                   [&, show = messages.sink(job.program)](const Diagnostic& one) {
                     show(one);
                     run.diagnostics.push_back(one);
                   });
  terminal.end();
  run.history->finish();
  take_figures(judged.outcome, run);
  run.files = files_of(job.program, judged.files, run.lines);
  run.ending = judged.ending;
  run.status = judged.status;
  return run;
}

}  // namespace softcnc::app
