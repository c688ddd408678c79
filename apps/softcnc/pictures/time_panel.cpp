// SPDX-License-Identifier: MIT
#include "pictures/time_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pictures/chart.hpp"
#include "pictures/line_thinning.hpp"

namespace softcnc::app {
namespace {

using runtime::HistoryNode;
using runtime::MotionKind;

constexpr double kAbove = 1.06;  // of the largest value, the end of the axis
constexpr double kApart = 0.5;   // px between columns of a line
const Colour kRapidBand{238, 239, 242};

/// Calls take(before, node) for all that follows the first node.
template <typename Take>
void each_interval(const runtime::RunHistory& history, Take&& take) {
  const auto& nodes = history.nodes();
  for (std::size_t i = 1; i < nodes.size(); ++i) take(nodes[i - 1], nodes[i]);
}

double time_of(const runtime::RunHistory& history, const HistoryNode& node) {
  return static_cast<double>(node.period) * history.period();
}

/// Bands of rapids that lie within a px of one another are one.
void draw_rapids(Canvas& canvas, const Chart& chart, const runtime::RunHistory& history,
                 double second) {
  double from = 0, to = 0;
  const auto draw = [&] {
    if (to > from)
      canvas.fill({from, chart.inner().y, to - from, chart.inner().height}, kRapidBand);
  };
  each_interval(history, [&](const HistoryNode& before, const HistoryNode& node) {
    if (node.motion != MotionKind::rapid) return;
    const double begin = chart.x_at(time_of(history, before) / second);
    const double end = chart.x_at(time_of(history, node) / second);
    if (begin > to + 1) {
      draw();
      from = begin;
    }
    to = end;
  });
  draw();
}

}  // namespace

double longest_time(PictureRuns runs) {
  double longest = 0;
  for (const PictureRun& run : runs) {
    longest = std::max(longest, run.time);
    if (const auto& nodes = run.history->nodes(); !nodes.empty())
      longest = std::max(longest, time_of(*run.history, nodes.back()));
  }
  return longest > 0 ? longest : 1;
}

double largest_value(const TimeSeries& series) {
  double largest = 0;
  each_interval(*series.history, [&](const HistoryNode& before, const HistoryNode& node) {
    if (!series.in_range) return;
    const double value = series.value(before, node);
    if (value > largest) largest = value;
  });
  return largest;
}

std::vector<std::vector<Spot>> series_lines(const TimeSeries& series, const Chart& chart,
                                            double second) {
  std::vector<std::vector<Spot>> lines;
  LineThinning line(kApart);
  bool open = false;
  const auto end_line = [&] {
    if (open) lines.push_back(line.take());
    open = false;
  };
  each_interval(*series.history, [&](const HistoryNode& before, const HistoryNode& node) {
    const double value = series.value(before, node);
    if (std::isnan(value)) return end_line();
    const double begin = time_of(*series.history, before) / second;
    const double end = time_of(*series.history, node) / second;
    if (series.is_step || !open)
      line.add(chart.at(begin, series.is_step ? value : series.value(before, before)));
    line.add(chart.at(end, value));
    open = true;
  });
  end_line();
  return lines;
}

std::vector<LegendEntry> legend_of(const TimePanel& panel) {
  std::vector<LegendEntry> entries;
  for (const TimeSeries& series : panel.series)
    if (!series.label.empty())
      entries.push_back({series.label, series.pen.colour, series.pen.dashed});
  if (panel.rapids_of != nullptr) {
    const auto& nodes = panel.rapids_of->nodes();
    if (std::ranges::any_of(
            nodes, [](const HistoryNode& node) { return node.motion == MotionKind::rapid; }))
      entries.push_back({"rapid", kRapidBand});
  }
  return entries;
}

void draw_panel(Canvas& canvas, const Rectangle& area, const TimePanel& panel, double duration) {
  const std::vector<LegendEntry> legend = legend_of(panel);
  const double head = kHeadingLine * heading_lines(canvas, panel.heading, legend, area.width);
  draw_heading(canvas, {area.x, area.y}, panel.heading, legend, area.width);
  const Rectangle inner{area.x + kAxisLeft, area.y + head + 4, area.width - kAxisLeft - kRight,
                        area.height - head - 4 - kAxisBelow};
  double largest = panel.least;
  for (const TimeSeries& series : panel.series) largest = std::max(largest, largest_value(series));
  const TimeUnit unit = time_unit(duration);
  const Chart chart(inner, {fmt::format("time, {}", unit.name), 0, duration / unit.seconds},
                    {panel.label, 0, largest > 0 ? kAbove * largest : 1});
  if (panel.rapids_of != nullptr) draw_rapids(canvas, chart, *panel.rapids_of, unit.seconds);
  chart.draw_grid(canvas);
  canvas.clip(inner);
  for (const TimeSeries& series : panel.series)
    for (const auto& line : series_lines(series, chart, unit.seconds))
      canvas.line(straightened(line, kStraight), series.pen);
  canvas.unclip();
  chart.draw_axes(canvas);
}

}  // namespace softcnc::app
