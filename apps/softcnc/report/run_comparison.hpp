// SPDX-License-Identifier: MIT
// Two runs beside one another: the difference of their times, and how far their paths are apart.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hal/machine/machine_file.hpp"
#include "input/reported_run.hpp"

namespace softcnc::app {

struct LineDifference {
  std::string file;
  int line = 0;
  double a = 0, b = 0;  // s
};

struct RunComparison {
  std::array<std::string, 2> names;
  std::array<double, 2> times{};
  std::array<std::array<double, kLimits>, 2> by_limit{};
  std::array<std::optional<double>, 2> contour;  // mm, largest; nothing: unknown
  std::vector<hal::DifferingValue> machine;      // the values that differ, where both are known
  std::vector<LineDifference> by_line;           // the largest difference first
  double distance = 0;                           // mm: of a node from the other path, largest
  double distance_error = 0;  // mm: what the thinning of both may have made of none
  double distance_time = 0;   // s, and
  int distance_run = 0;       // of which run: 0, 1
};

/// Compares two runs. Errors: SC6003.
Result<RunComparison> compare_runs(const ReportedRun& a, const ReportedRun& b);
/// A list of `key`, `a` and `b`.
nlohmann::ordered_json differing_values_json(std::span<const hal::DifferingValue> values);
nlohmann::ordered_json comparison_json(const RunComparison& comparison);

}  // namespace softcnc::app
