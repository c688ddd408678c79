// SPDX-License-Identifier: MIT
#include "output/time_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hal/files/axis_name.hpp"
#include "messages/duration_text.hpp"
#include "motion/core/units.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

/// "at a corner", "for a dwell", ...
std::string_view reason(runtime::RestCause cause, std::int64_t count) {
  constexpr std::array<std::string_view, runtime::kRestCauses> reasons{
      "at corners",      "for dwells",      "for tools",
      "for the spindle", "for the coolant", "at stops",
      "at outputs",      "on hold",         "where no faster plan was found"};
  constexpr std::array<std::string_view, runtime::kRestCauses> reasons_of_one{
      "at a corner",     "for a dwell",     "for a tool",
      "for the spindle", "for the coolant", "at a stop",
      "at an output",    "on hold",         "where no faster plan was found"};
  return (count == 1 ? reasons_of_one : reasons)[static_cast<std::size_t>(cause)];
}

/// Calls take(cause, count) for those that there were.
template <typename Take>
void for_each_cause(const runtime::TimeSheet& sheet, Take&& take) {
  for (std::size_t i = 0; i < runtime::kRestCauses; ++i) {
    const auto cause = static_cast<runtime::RestCause>(i);
    if (sheet.rests_by(cause) > 0) take(cause, sheet.rests_by(cause));
  }
}

std::string rests_text(const runtime::TimeSheet& sheet) {
  std::string text;
  for_each_cause(sheet, [&](runtime::RestCause cause, std::int64_t count) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, reason(cause, count));
  });
  return text;
}

std::string tool_text(int tool) { return tool == 0 ? "no tool" : fmt::format("T{}", tool); }

/// What they cost: by the second plan where there is one.
double seconds_of_corners(const runtime::TimeSheet& sheet) {
  return sheet.corner_cost ? sheet.corner_cost->seconds : sheet.corners.seconds;
}

Json rests_json(const runtime::TimeSheet& sheet) {
  Json rests{{"count", sheet.corners.count}, {"seconds", seconds_of_corners(sheet)}};
  if (sheet.corner_cost) rests["corner_tolerance_um"] = um_from_mm(sheet.corner_cost->tolerance);
  return rests;
}

Json sheet_json(const runtime::TimeSheet& sheet) {
  Json tools = Json::array();
  for (const runtime::ToolTime& one : sheet.tools)
    tools.push_back({{"tool", one.tool},
                     {"cutting_s", one.cutting},
                     {"rapid_s", one.rapid},
                     {"dwell_s", one.dwell},
                     {"rest_s", one.rest}});
  Json rests = Json::object();
  for_each_cause(sheet, [&](runtime::RestCause cause, std::int64_t count) {
    rests[std::string(name(cause))] = count;
  });
  return {{"tools", tools}, {"rests", rests}};
}

Json lines_json(const std::vector<runtime::WorstLine>& lines) {
  Json list = Json::array();
  for (const runtime::WorstLine& one : lines) {
    Json line{{"line", one.line}, {"lost_s", one.lost}, {"limit", name(one.limit)}};
    if (!one.file.empty()) line["file"] = one.file;
    list.push_back(std::move(line));
  }
  return list;
}

Json causes_json(const std::vector<runtime::LossCause>& causes) {
  Json list = Json::array();
  for (const runtime::LossCause& one : causes) {
    Json cause{{"cause", name(one.kind)}, {"count", one.count}, {"lost_s", one.lost}};
    if (one.kind == runtime::LossKind::curve) cause["limit"] = name(one.limit);
    if (one.axis >= 0) {
      cause["axis"] = hal::axis_name(one.axis);
      cause["from_mm"] = one.from;
      cause["to_mm"] = one.to;
    }
    list.push_back(std::move(cause));
  }
  return list;
}

/// "reversals of X at X 0 and X 100", "moves, limited by chord", ...
std::string cause_text(const runtime::LossCause& cause) {
  const bool one = cause.count == 1;
  if (cause.kind == runtime::LossKind::rest)
    return one ? "start or end at rest" : "starts and ends at rest";
  if (cause.kind == runtime::LossKind::curve)
    return fmt::format("{}, limited by {}", one ? "move" : "moves", name(cause.limit));
  const char axis = kAxisLetters[static_cast<std::size_t>(cause.axis)];
  const std::string what = fmt::format("{}{} of {}", name(cause.kind), one ? "" : "s", axis);
  if (cause.from == cause.to) return fmt::format("{} at {} {:.6g}", what, axis, cause.from);
  return fmt::format("{} {} {} {:.6g} and {} {:.6g}", what, cause.only_ends ? "at" : "between",
                     axis, cause.from, axis, cause.to);
}

constexpr std::size_t kShownCauses = 10;

std::string causes_text(const std::vector<runtime::LossCause>& causes) {
  std::string text = fmt::format("\n  {:>12}{:>14}   {}", "times", "lost", "because of");
  for (std::size_t i = 0; i < std::min(causes.size(), kShownCauses) && causes[i].lost > 0; ++i)
    text += fmt::format("\n  {:>12}{:>12.4f} s   {}", causes[i].count, causes[i].lost,
                        cause_text(causes[i]));
  return text;
}

}  // namespace

std::string stops_line(const runtime::TimeSheet& sheet) {
  const std::string rests = rests_text(sheet);
  return rests.empty() ? rests : "\n  stops          " + rests;
}

std::string time_sheet_text(const runtime::TimeSheet& sheet) {
  std::string text =
      fmt::format("  {:<10}{:>14}{:>14}{:>14}{:>14}", "tool", "cutting", "rapid", "dwell", "rest");
  for (const runtime::ToolTime& one : sheet.tools)
    text += fmt::format("\n  {:<10}{:>14}{:>14}{:>14}{:>14}", tool_text(one.tool),
                        duration_text(one.cutting), duration_text(one.rapid),
                        duration_text(one.dwell), duration_text(one.rest));
  return text + stops_line(sheet);
}

std::string losses_text(const runtime::Outcome& outcome) {
  const std::vector<runtime::WorstLine>& lines = outcome.worst_lines;
  if (lines.empty()) return "  no line loses time against its feed";
  std::string text = fmt::format("  {:>12}{:>14}   {}", "line", "lost", "limited by");
  for (const runtime::WorstLine& one : lines) {
    const std::string place = one.file.empty() ? std::string() : one.file + ":";
    text += fmt::format("\n  {:>12}{:>12.4f} s   {}", place + std::to_string(one.line), one.lost,
                        name(one.limit));
  }
  return text + causes_text(outcome.loss_causes);
}

void add_times(Json& report, const runtime::Outcome& outcome) {
  report["rests"] = rests_json(outcome.time_sheet);
  report["time_sheet"] = sheet_json(outcome.time_sheet);
  report["worst_lines"] = lines_json(outcome.worst_lines);
  report["loss_causes"] = causes_json(outcome.loss_causes);
}

}  // namespace softcnc::app
