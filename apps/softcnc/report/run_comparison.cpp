// SPDX-License-Identifier: MIT
#include "report/run_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLines = 200;  // of the largest differences
constexpr double kLeast = 1e-6;      // s

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
  differences.resize(std::min(differences.size(), kLines));
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

}  // namespace

RunComparison compare_runs(const ReportedRun& a, const ReportedRun& b) {
  RunComparison result;
  result.names = names(a, b);
  result.times = {a.time, b.time};
  result.by_limit = {a.time_by_limit, b.time_by_limit};
  result.by_line = by_line(a, b);
  return result;
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
  return {{"time_s", comparison.times},
          {"names", comparison.names},
          {"by_limit", std::move(limits)},
          {"by_line", std::move(lines)},
          {"distance_um", 1000 * comparison.distance},
          {"distance_at", {{"t_s", comparison.distance_time}}}};
}

}  // namespace softcnc::app
