// SPDX-License-Identifier: MIT
// The result of a run.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ipo/planner/planner.hpp"
#include "ipr/parser/library.hpp"
#include "motion/model/cycle.hpp"
#include "motion/model/machine_state.hpp"
#include "motion/model/setpoint.hpp"
#include "motion/model/stock_outline.hpp"
#include "motion/verification/contour_report.hpp"
#include "motion/verification/programmed_path.hpp"
#include "motion/verification/verify.hpp"
#include "runtime/figures/loss_causes.hpp"
#include "runtime/figures/surface_notes.hpp"
#include "runtime/figures/time_sheet.hpp"
#include "runtime/figures/worst_lines.hpp"
#include "runtime/sinks/curve_columns.hpp"

namespace softcnc::runtime {

/// The result of a run. CPU times are those of this thread.
struct Outcome {
  enum class End : std::uint8_t { done, stopped, alarm, broken_off };
  struct Cpu {
    double planning = 0, cycle = 0, verification = 0, output = 0;  // s
  };

  End end = End::done;
  Setpoint last;
  Feedback feedback;
  std::int64_t setpoints = 0;
  double time = 0;  // s: Channel::time()
  std::array<double, kLimits> time_by_limit{};
  TimeSheet time_sheet;
  std::vector<WorstLine> worst_lines;  // as many as are asked for
  std::vector<LossCause> loss_causes;  // where lines are asked for, the worst first
  std::vector<LineTime> line_times;    // where they are asked for
  Measured measured;
  double corner_deviation = 0;          // mm: of rounded corners from the programmed path, largest;
  ProgrammedPath::Deviation deviation;  // and that which comes nearest to what is allowed
  std::optional<ContourReport> contour;  // where the backend knows where the axes are
  SurfaceNotes surface;
  std::vector<ColumnFigures> columns;  // of the curve columns of the rows
  std::size_t events_left = 0;         // of the script: their moments were never reached
  MachineState state;                  // where the machine rests, if ChannelOptions::keeps_state
  std::map<int, AxisVector> origins;   // of work systems: Feeder::origins()
  std::vector<StockOutline> stocks;    // that the program states
  ipo::PlannerCounts planner;
  std::vector<ipr::FoundFile> called_files;
  std::set<std::string> missing_files;  // paths under which calls have found no file
  Cpu cpu;
};

}  // namespace softcnc::runtime
