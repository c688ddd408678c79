// SPDX-License-Identifier: MIT
// A run that is to be shown: its history, and the figures around it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "job/job.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/stock_outline.hpp"
#include "runtime/history/run_history.hpp"
#include "surface/roughness_map.hpp"

namespace softcnc::app {

/// Of a run, that pictures and pages show.
inline constexpr std::size_t kWorstLines = 10;

/// Where a run comes from: its program is run, or its rows have been written down.
enum class InputKind : std::uint8_t { program, trace, recording };

/// Returns the kind by the suffix: .rec; .csv and .npz, also with .zst; all else is a program.
InputKind input_kind(const std::string& file);
std::string_view name(InputKind kind) noexcept;

/// Returns whether a run is compared with one on another machine: B.toml, or "builtin".
bool names_machine(std::string_view compared) noexcept;

/// A file of a run, with its text where that is known.
struct ReportedFile {
  std::string name;
  std::optional<std::string> text;
};

/// A figure of a run, for a person.
struct RunFigure {
  std::string name;
  double value = 0;
  std::string unit;
};

/// A simulated surface, thinned out to what a page can show.
struct ReportedSurface {
  surface::StockGrid grid;
  int every = 1;               // of the grid's points that are kept along each side
  int columns = 0, rows = 0;   // of `heights`
  std::vector<float> heights;  // mm above the corner of the stock, row by row
  int region_columns = 0, region_rows = 0;
  double region = 0;                 // mm along a side
  std::vector<float> rmax, targets;  // um by region; NaN: unknown, and nothing is asked for
  surface::TargetFigures judged;
};

struct ReportedRun {
  InputKind kind = InputKind::program;
  std::string name;                // of the program, or of the trace
  std::optional<Machine> machine;  // where it is known
  std::string machine_file;        // that stands beside the program; empty: another one
  Ending ending = Ending::error;
  int status = 0;               // exit status
  double period = 0.001;        // s
  double time = 0, length = 0;  // s, mm
  std::int64_t setpoints = 0;
  int blocks = 0;
  std::array<double, kLimits> time_by_limit{};  // s
  runtime::TimeSheet sheet;
  std::vector<RunFigure> figures;         // the most important one first
  std::optional<double> largest_contour;  // mm, on cutting moves
  std::map<int, AxisVector> origins;      // mm, of work systems, by their index
  std::vector<StockOutline> stocks;
  std::vector<runtime::LineTime> lines;  // in the order of files and lines
  std::vector<ReportedFile> files;       // by number; 0: the program itself
  std::vector<Diagnostic> diagnostics;
  std::unique_ptr<runtime::RunHistory> history;
  std::optional<ReportedSurface> surface;
};

/// Returns the lines that lose most, at most `count`, the worst first.
std::vector<runtime::LineTime> worst_lines(const ReportedRun& run, std::size_t count);

}  // namespace softcnc::app
