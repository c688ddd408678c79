// SPDX-License-Identifier: MIT
#include "report/what_if.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hal/files/axis_name.hpp"
#include "messages/duration_text.hpp"
#include "runtime/check/planned_times.hpp"

namespace softcnc::app {
namespace {

struct AxisLimit {
  const char* name;
  double Axis::*value;
};
constexpr AxisLimit kLimits[] = {{"velocity", &Axis::velocity},
                                 {"acceleration", &Axis::acceleration},
                                 {"jerk", &Axis::jerk}};  // 0: none

}  // namespace

std::optional<WhatIf> what_if(Job& job, Terminal& terminal) {
  const auto time_on = [&](const Machine& machine) -> std::optional<double> {
    const auto times = runtime::plan_times(job.program, machine, job.options, &terminal);
    if (!times) return std::nullopt;
    return times->time;
  };
  const auto time = time_on(job.machine);
  if (!time) return std::nullopt;
  WhatIf result{*time, {}};
  for (int i = 0; i < kAxes; ++i) {
    for (const AxisLimit& limit : kLimits) {
      Machine machine = job.machine;
      Axis& axis = machine.axes[static_cast<std::size_t>(i)];
      if (!axis.present || !(axis.*limit.value > 0)) continue;
      axis.*limit.value *= WhatIf::kFactor;
      const auto raised = time_on(machine);
      if (!raised) return std::nullopt;
      result.changes.push_back({hal::axis_name(i), limit.name, *raised});
    }
  }
  std::stable_sort(result.changes.begin(), result.changes.end(),
                   [](const RaisedLimit& a, const RaisedLimit& b) { return a.time < b.time; });
  return result;
}

nlohmann::ordered_json what_if_json(const WhatIf& what_if) {
  auto rows = nlohmann::ordered_json::array();
  for (const RaisedLimit& change : what_if.changes)
    rows.push_back({{"axis", change.axis},
                    {"limit", change.limit},
                    {"factor", WhatIf::kFactor},
                    {"time_s", change.time},
                    {"won_s", what_if.time - change.time}});
  return {{"time_s", what_if.time}, {"rows", std::move(rows)}};
}

std::string what_if_text(const WhatIf& what_if) {
  std::string text =
      fmt::format("  with one limit 50 % higher, of {}", duration_text(what_if.time));
  for (const RaisedLimit& change : what_if.changes)
    text += fmt::format("\n  {:<14} {}  {:>11} less", change.limit + " of", change.axis,
                        duration_text(std::max(what_if.time - change.time, 0.0)));
  return text;
}

}  // namespace softcnc::app
