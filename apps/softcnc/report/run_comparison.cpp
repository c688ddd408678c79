// SPDX-License-Identifier: MIT
#include "report/run_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "motion/core/units.hpp"
#include "runtime/difference/path_distance.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostDifferences = 200;  // of the largest differences
constexpr double kLeast = 1e-6;                // s

std::string file_name(const ReportedRun& run, int file) {
  const auto index = static_cast<std::size_t>(file);
  return index < run.files.size() ? run.files[index].name : run.name;
}

/// The program itself is the same file in both, whatever its name.
std::vector<LineDifference> by_line(const ReportedRun& a, const ReportedRun& b) {
  std::map<std::pair<std::string, int>, LineDifference> lines;
  const auto add = [&lines](const ReportedRun& run, double LineDifference::*seconds) {
    for (const runtime::LineTime& line : run.lines) {
      const std::string file = line.file == 0 ? std::string() : file_name(run, line.file);
      LineDifference& both = lines[{file, line.line}];
      both.line = line.line;
      both.file = file;
      both.*seconds += line.seconds;
    }
  };
  add(a, &LineDifference::a);
  add(b, &LineDifference::b);
  std::vector<LineDifference> differences;
  for (auto& [place, line] : lines)
    if (std::abs(line.b - line.a) > kLeast) differences.push_back(std::move(line));
  std::stable_sort(differences.begin(), differences.end(),
                   [](const LineDifference& x, const LineDifference& y) {
                     return std::abs(x.b - x.a) > std::abs(y.b - y.a);
                   });
  differences.resize(std::min(differences.size(), kMostDifferences));
  for (LineDifference& line : differences)
    if (line.file.empty()) line.file = a.name;
  return differences;
}

/// What tells one run from the other.
std::array<std::string, 2> names(const ReportedRun& a, const ReportedRun& b) {
  std::array<std::string, 2> names{a.name, b.name};
  const auto add = [&names](const std::string& of_a, const std::string& of_b) {
    if (names[0] != names[1]) return;
    names[0] += of_a;
    names[1] += of_b;
  };
  if (!a.machine || !b.machine) return names;
  add(" on " + a.machine->name, " on " + b.machine->name);
  add(fmt::format(" by {}", name(a.machine->control.interpolation)),
      fmt::format(" by {}", name(b.machine->control.interpolation)));
  add(" (A)", " (B)");
  return names;
}

/// The nodes of a run as rows.
Status fill(runtime::RowStore& rows, const ReportedRun& run) {
  for (const runtime::HistoryNode& node : run.history->nodes()) {
    runtime::RunRow row;
    row.period = node.period;
    row.position = node.position;
    rows.take(row);
  }
  return rows.finish(run.period);
}

/// The distance of the paths, as far as the nodes show them.
Status measure_distance(const ReportedRun& a, const ReportedRun& b, RunComparison& result) {
  runtime::RowStore first, second;
  if (Status filled = fill(first, a); !filled) return filled;
  if (Status filled = fill(second, b); !filled) return filled;
  result.distance_error =
      std::sqrt(kAxes) * (a.history->position_error() + b.history->position_error());
  const auto distance = runtime::largest_distance(first, second);
  if (!distance) return {};
  const std::size_t run = distance->of_first ? 0 : 1;
  const auto& nodes = (run == 0 ? a : b).history->nodes();
  result.distance = distance->distance;
  result.distance_run = static_cast<int>(run);
  result.distance_time =
      (run == 0 ? a : b).period * static_cast<double>(nodes[distance->index].period);
  return {};
}

/// The largest contour errors, um; null where one is not known.
Json contour_json(const RunComparison& comparison) {
  Json list = Json::array();
  for (const std::optional<double>& mm : comparison.contour)
    list.push_back(mm ? Json(um_from_mm(*mm)) : Json());
  return list;
}

}  // namespace

Result<RunComparison> compare_runs(const ReportedRun& a, const ReportedRun& b) {
  RunComparison result;
  result.names = names(a, b);
  result.times = {a.time, b.time};
  result.by_limit = {a.time_by_limit, b.time_by_limit};
  result.contour = {a.largest_contour, b.largest_contour};
  if (a.machine && b.machine) result.machine = hal::differing_values(*a.machine, *b.machine);
  result.by_line = by_line(a, b);
  if (Status measured = measure_distance(a, b, result); !measured)
    return tl::make_unexpected(std::move(measured.error()));
  return result;
}

Json differing_values_json(std::span<const hal::DifferingValue> values) {
  Json list = Json::array();
  for (const hal::DifferingValue& value : values)
    list.push_back({{"key", value.key}, {"a", value.a}, {"b", value.b}});
  return list;
}

Json comparison_json(const RunComparison& comparison) {
  Json limits = Json::array(), lines = Json::array();
  for (std::size_t i = 0; i < kLimitNames.size(); ++i)
    if (comparison.by_limit[0][i] > 0 || comparison.by_limit[1][i] > 0)
      limits.push_back({{"limit", kLimitNames[i]},
                        {"a_s", comparison.by_limit[0][i]},
                        {"b_s", comparison.by_limit[1][i]}});
  for (const LineDifference& line : comparison.by_line)
    lines.push_back({{"file", line.file}, {"line", line.line}, {"a_s", line.a}, {"b_s", line.b}});
  Json json = {
      {"time_s", comparison.times},
      {"names", comparison.names},
      {"by_limit", std::move(limits)},
      {"by_line", std::move(lines)},
      {"distance_um", um_from_mm(comparison.distance)},
      {"distance_error_um", um_from_mm(comparison.distance_error)},
      {"distance_at", {{"t_s", comparison.distance_time}, {"run", comparison.distance_run}}}};
  if (!comparison.machine.empty()) json["machine"] = differing_values_json(comparison.machine);
  if (comparison.contour[0] || comparison.contour[1]) json["contour_um"] = contour_json(comparison);
  return json;
}

}  // namespace softcnc::app
