// SPDX-License-Identifier: MIT
// Values of runs over their time, in a chart.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pictures/canvas.hpp"
#include "pictures/chart.hpp"
#include "pictures/legend.hpp"
#include "pictures/picture_run.hpp"

namespace softcnc::app {

/// A value over the time of a run.
struct TimeSeries {
  using Value =
      std::function<double(const runtime::HistoryNode& before, const runtime::HistoryNode& node)>;

  std::string label;
  Pen pen;
  const runtime::RunHistory* history = nullptr;
  Value value;  // NaN: none
  /// The value is that of the whole time between two nodes; otherwise that at the second node.
  bool is_step = true;
  bool in_range = true;  // the axis is long enough for it
};

struct TimePanel {
  std::string heading, label;  // the label with the unit
  std::vector<TimeSeries> series;
  const runtime::RunHistory* rapids_of = nullptr;  // whose rapids are shown as grey bands
  double least = 0;                                // how far the axis goes at least
};

/// Returns the largest value of a series within the range of its axis; 0 without values.
double largest_value(const TimeSeries& series);

/// Returns the lines of a series, px in a chart whose x is time in `second` s.
std::vector<std::vector<Spot>> series_lines(const TimeSeries& series, const Chart& chart,
                                            double second);

std::vector<LegendEntry> legend_of(const TimePanel& panel);

/// Draws a panel with its heading; `duration` in s.
void draw_panel(Canvas& canvas, const Rectangle& area, const TimePanel& panel, double duration);

/// Returns the time of the longest run, s; above 0.
double longest_time(PictureRuns runs);

}  // namespace softcnc::app
