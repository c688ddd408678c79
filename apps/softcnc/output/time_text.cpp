// SPDX-License-Identifier: MIT
#include "output/time_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

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

std::string worst_lines_text(const std::vector<runtime::WorstLine>& lines) {
  if (lines.empty()) return "  no line loses time against its feed";
  std::string text = fmt::format("  {:>12}{:>14}   {}", "line", "lost", "limited by");
  for (const runtime::WorstLine& one : lines) {
    const std::string place = one.file.empty() ? std::string() : one.file + ":";
    text += fmt::format("\n  {:>12}{:>12.4f} s   {}", place + std::to_string(one.line), one.lost,
                        name(one.limit));
  }
  return text;
}

void add_times(Json& report, const runtime::Outcome& outcome) {
  report["rests"] = rests_json(outcome.time_sheet);
  report["time_sheet"] = sheet_json(outcome.time_sheet);
  report["worst_lines"] = lines_json(outcome.worst_lines);
}

}  // namespace softcnc::app
