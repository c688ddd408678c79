// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "difference/difference_text.hpp"
#include "motion/core/units.hpp"
#include "motion/core/utf8.hpp"
#include "report/run_comparison.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;
using runtime::Aspect, runtime::TimePair;

constexpr int kDifferenceSchema = 1;

Json run_json(const ComparedRun& run) {
  return {
      {"file", as_utf8(run.name)},
      {"kind", name(run.kind)},
      {"time_s", run.rows.time()},
      {"length_mm", run.rows.length()},
      {"rows", run.rows.rows().size()},
      {"period_s", run.rows.period()},
      {"contour_max_um", std::isfinite(run.rows.contour()) ? Json(run.rows.contour()) : Json()}};
}

/// The name of the number of an aspect, with its unit.
const char* key_of(Aspect aspect) {
  constexpr std::array<const char*, runtime::kAspects> kKeys{
      "difference_s", "difference_mm", "difference_mm", "difference_mm_s", "rows", "rows"};
  return kKeys[static_cast<std::size_t>(aspect)];
}

Json aspect_json(Aspect aspect, const runtime::AspectDifference& own) {
  Json json{{"aspect", name(aspect)}, {"same", own.same}, {"judged", own.judged}};
  json[key_of(aspect)] = std::isfinite(own.largest) ? Json(own.largest) : Json();
  json["allowed"] = own.judged ? Json(own.allowed) : Json();
  if (runtime::is_of_rows(aspect))
    json["first_row"] = own.first_row ? Json(*own.first_row + 1) : Json();
  return json;
}

Json distance_json(const ComparedPair& pair) {
  const auto& distance = pair.difference.distance;
  if (!distance) return nullptr;
  const ComparedRun& run = distance->of_first ? pair.a : pair.b;
  const runtime::StoredRow& row = run.rows.rows()[distance->index];
  return {{"um", um_from_mm(distance->distance)},
          {"of", distance->of_first ? "a" : "b"},
          {"t_s", static_cast<double>(row.period) * run.rows.period()},
          {"line", row.line},
          {"position_mm", row.position}};
}

void put_times(Json& json, const TimePair& time) {
  json["a_s"] = time.a;
  json["b_s"] = time.b;
}

Json limits_json(const runtime::RunDifference& difference) {
  Json limits = Json::array();
  for (std::size_t i = 0; i < difference.by_limit.size(); ++i) {
    const TimePair& time = difference.by_limit[i];
    if (time.a == 0 && time.b == 0) continue;
    put_times(limits.emplace_back(Json{{"limit", kLimitNames[i]}}), time);
  }
  return limits;
}

Json lines_json(const runtime::RunDifference& difference, std::size_t most) {
  Json lines = Json::array();
  for (std::size_t i = 0; i < std::min(most, difference.by_line.size()); ++i) {
    const runtime::ComparedLine& line = difference.by_line[i];
    put_times(lines.emplace_back(Json{{"line", line.line}}), line.time);
  }
  return lines;
}

Json first_json(const ComparedPair& pair) {
  const auto aspect = pair.difference.first();
  if (!aspect) return nullptr;
  return {{"aspect", name(*aspect)},
          {"row", *pair.difference.of(*aspect).first_row + 1},
          {"text", first_difference(pair)}};
}

}  // namespace

std::string difference_json(const ComparedPair& pair, std::size_t lines) {
  const runtime::RunDifference& difference = pair.difference;
  Json json{{"schema", kDifferenceSchema},
            {"softcnc", SOFTCNC_VERSION},
            {"same", difference.same()},
            {"a", run_json(pair.a)},
            {"b", run_json(pair.b)},
            {"machine", differing_values_json(machine_differences(pair))},
            {"aspects", Json::array()},
            {"by_limit", limits_json(difference)},
            {"lines_that_differ", difference.by_line.size()},
            {"by_line", lines_json(difference, lines)},
            {"distance", distance_json(pair)},
            {"first_difference", first_json(pair)}};
  for (std::size_t i = 0; i < runtime::kAspects; ++i)
    json["aspects"].push_back(aspect_json(static_cast<Aspect>(i), difference.aspects[i]));
  return json.dump(2) + '\n';
}

}  // namespace softcnc::app
