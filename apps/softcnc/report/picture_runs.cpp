// SPDX-License-Identifier: MIT
#include "report/picture_runs.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>

namespace softcnc::app {
namespace {

std::string remark(Ending ending) {
  switch (ending) {
    case Ending::stopped:
      return "(stopped)";
    case Ending::alarm:
      return "(ended by an alarm)";
    case Ending::error:
      return "(ended by an error)";
    default:
      return {};
  }
}

std::vector<LostLine> lost_lines(const ReportedRun& run) {
  std::vector<LostLine> lost;
  for (const runtime::LineTime& line : worst_lines(run, kWorstLines)) {
    const auto file = static_cast<std::size_t>(line.file);
    const bool called = line.file > 0 && file < run.files.size();
    lost.push_back({called ? fmt::format("{}:{}", run.files[file].name, line.line)
                           : fmt::format("line {}", line.line),
                    line.lost, line.limit});
  }
  return lost;
}

/// An axis without a limit is as far from it as can be.
AxisVector velocity_limits(const Machine& machine) {
  AxisVector limits = AxisVector::Constant(std::numeric_limits<double>::infinity());
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (axis.present && axis.velocity > 0) limits[i] = axis.velocity;
  }
  return limits;
}

PictureRun picture_run(const ReportedRun& run) {
  PictureRun picture{.history = run.history.get(),
                     .program = run.name,
                     .machine = {},
                     .remark = remark(run.ending),
                     .time = run.time,
                     .length = run.length,
                     .time_by_limit = run.time_by_limit,
                     .worst_lines = lost_lines(run),
                     .velocity_limits = {}};
  if (run.machine) {
    picture.machine = run.machine->name;
    picture.velocity_limits = velocity_limits(*run.machine);
  }
  return picture;
}

}  // namespace

std::vector<PictureRun> picture_runs(std::span<const ReportedRun> runs) {
  std::vector<PictureRun> pictures;
  for (const ReportedRun& run : runs) pictures.push_back(picture_run(run));
  return pictures;
}

}  // namespace softcnc::app
