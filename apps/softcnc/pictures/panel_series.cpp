// SPDX-License-Identifier: MIT
#include "pictures/panel_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pictures/chart.hpp"

namespace softcnc::app {
namespace {

using runtime::HistoryNode;
using runtime::MotionKind;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSeriesLine = 1.3;  // px
const Colour kProgrammed{90, 96, 106}, kAcceleration{213, 94, 0}, kJerk{204, 121, 167};

/// A series of one value for each run.
void add_series(TimePanel& panel, PictureRuns runs, const std::string& label, Colour alone,
                const TimeSeries::Value& value, bool is_step) {
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool single = runs.size() == 1;
    const std::string name = single ? label : i == 0 ? "A" : "B";
    panel.series.push_back(
        {.label = name,
         .pen = {.colour = single ? alone : category_colour(i), .width = kSeriesLine},
         .history = runs[i].history,
         .value = value,
         .is_step = is_step});
  }
}

double programmed_feed(const HistoryNode&, const HistoryNode& node) {
  return node.motion == MotionKind::cutting && node.feed > 0 ? kMinute * node.feed : kNone;
}

/// Speed that counts for the length of the axis: rapids do not.
double cutting_speed(const HistoryNode&, const HistoryNode& node) {
  return node.motion == MotionKind::cutting ? kMinute * node.v : kNone;
}

double speed(const HistoryNode&, const HistoryNode& node) { return kMinute * node.v; }

/// mm/s along an axis, its mean between two nodes.
double axis_speed(const runtime::RunHistory& history, int axis, const HistoryNode& before,
                  const HistoryNode& node) {
  const double time = static_cast<double>(node.period - before.period) * history.period();
  return time > 0 ? std::abs(node.position[axis] - before.position[axis]) / time : 0;
}

TimeSeries::Value axis_value(const PictureRun& run, int axis) {
  return [&run, axis](const HistoryNode& before, const HistoryNode& node) {
    const double mm_s = axis_speed(*run.history, axis, before, node);
    return run.velocity_limits ? kPercent * mm_s / (*run.velocity_limits)[axis] : kMinute * mm_s;
  };
}

/// Of the axis that is nearest to its limit.
TimeSeries::Value fastest_axis(const PictureRun& run) {
  return [&run](const HistoryNode& before, const HistoryNode& node) {
    double most = 0;
    for (int axis = 0; axis < kAxes; ++axis)
      most = std::max(most, axis_value(run, axis)(before, node));
    return most;
  };
}

bool moves(const runtime::RunHistory& history, int axis) {
  const auto& nodes = history.nodes();
  return std::ranges::any_of(nodes, [&](const HistoryNode& node) {
    return std::abs(node.position[axis] - nodes.front().position[axis]) > 1e-6;
  });
}

TimePanel velocity_panel(PictureRuns runs) {
  const bool limits = std::ranges::all_of(
      runs, [](const PictureRun& run) { return run.velocity_limits.has_value(); });
  TimePanel panel{.heading = "Velocity of the axes",
                  .label = limits ? "velocity, % of limit" : "velocity, mm/min",
                  .series = {}};
  if (limits) panel.least = kPercent;
  if (runs.size() == 1) {
    for (int axis = 0; axis < kAxes; ++axis)
      if (moves(*runs[0].history, axis))
        panel.series.push_back(
            {.label = std::string(1, kAxisLetters[static_cast<std::size_t>(axis)]),
             .pen = {.colour = category_colour(static_cast<std::size_t>(axis)),
                     .width = kSeriesLine},
             .history = runs[0].history,
             .value = axis_value(runs[0], axis)});
    return panel;
  }
  panel.heading =
      limits ? "Velocity of the axis nearest its limit" : "Velocity of the fastest axis";
  for (std::size_t i = 0; i < runs.size(); ++i)
    panel.series.push_back({.label = i == 0 ? "A" : "B",
                            .pen = {.colour = category_colour(i), .width = kSeriesLine},
                            .history = runs[i].history,
                            .value = fastest_axis(runs[i])});
  return panel;
}

TimeSeries::Value percent_of(float HistoryNode::*use) {
  return [use](const HistoryNode&, const HistoryNode& node) {
    return kPercent * static_cast<double>(node.*use);
  };
}

TimeSeries::Value um_of(float HistoryNode::*error) {
  return [error](const HistoryNode&, const HistoryNode& node) {
    return static_cast<double>(node.*error);
  };
}

bool has_use(PictureRuns runs, float HistoryNode::*use) {
  return std::ranges::any_of(runs, [use](const PictureRun& run) {
    return std::ranges::any_of(run.history->nodes(),
                               [use](const HistoryNode& node) { return node.*use > 0; });
  });
}

void add_use(std::vector<TimePanel>& panels, PictureRuns runs, float HistoryNode::*use,
             const std::string& what, Colour colour) {
  if (!has_use(runs, use)) return;
  TimePanel panel{.heading = "Use of " + what + ", of the axis nearest its limit",
                  .label = what + ", % of limit",
                  .series = {},
                  .least = kPercent};
  add_series(panel, runs, {}, colour, percent_of(use), true);
  panels.push_back(std::move(panel));
}

void add_error(std::vector<TimePanel>& panels, PictureRuns runs, float HistoryNode::*error,
               const std::string& heading, const std::string& label) {
  const auto knows = [error](const PictureRun& run) { return run.history->knows(error); };
  if (std::ranges::none_of(runs, knows)) return;
  TimePanel panel{.heading = heading, .label = label + ", µm", .series = {}, .least = kLeastError};
  add_series(panel, runs, {}, category_colour(0), um_of(error), true);
  panels.push_back(std::move(panel));
}

}  // namespace

std::vector<TimePanel> feed_panels(PictureRuns runs) {
  TimePanel panel{.heading = "Feed", .label = "feed, mm/min", .series = {}};
  if (runs.size() == 1)
    panel.series.push_back({.label = "programmed",
                            .pen = {.colour = kProgrammed, .width = kSeriesLine, .dashed = true},
                            .history = runs[0].history,
                            .value = programmed_feed});
  add_series(panel, runs, "achieved", category_colour(0), speed, false);
  // The axis is as long as cutting moves need.
  for (TimeSeries& series : panel.series) series.in_range = series.pen.dashed;
  for (const PictureRun& run : runs)
    for (const auto& value : {programmed_feed, cutting_speed})
      panel.least =
          std::max(panel.least,
                   largest_value({.label = {}, .pen = {}, .history = run.history, .value = value}));
  if (panel.least == 0)  // rapids alone
    for (TimeSeries& series : panel.series) series.in_range = true;
  if (runs.size() == 1) panel.rapids_of = runs[0].history;
  return {panel};
}

std::vector<TimePanel> axis_panels(PictureRuns runs) {
  std::vector<TimePanel> panels{velocity_panel(runs)};
  add_use(panels, runs, &HistoryNode::acceleration_use, "acceleration", kAcceleration);
  add_use(panels, runs, &HistoryNode::jerk_use, "jerk", kJerk);
  return panels;
}

std::vector<TimePanel> error_panels(PictureRuns runs) {
  std::vector<TimePanel> panels;
  add_error(panels, runs, &HistoryNode::contour, "Contour error: the tool's distance from the path",
            "contour error");
  add_error(panels, runs, &HistoryNode::deviation, "Deviation of the path from the program",
            "deviation");
  add_error(panels, runs, &HistoryNode::chord_error, "Chord error of each period", "chord error");
  add_error(panels, runs, &HistoryNode::rmax, "Predicted roughness", "Rmax");
  return panels;
}

}  // namespace softcnc::app
