// SPDX-License-Identifier: MIT
#include "replay/replay_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "motion/core/utf8.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kReplaySchema = 1;

std::int64_t count(const std::vector<ReplayResult>& results, ReplayEnd end) {
  return std::count_if(results.begin(), results.end(),
                       [end](const ReplayResult& result) { return result.end == end; });
}

Json result_json(const ReplayResult& result) {
  Json json{{"file", as_utf8(result.name)},
            {"result", name(result.end)},
            {"rows", result.rows},
            {"seconds", result.seconds}};
  if (!result.code.empty()) json["code"] = result.code;
  if (!result.message.empty()) json["message"] = as_utf8(result.message);
  if (!result.table.empty()) json["difference"] = as_utf8(result.table);
  return json;
}

TestResult test_result(ReplayEnd end) {
  if (end == ReplayEnd::differs) return TestResult::failed;
  return end == ReplayEnd::error ? TestResult::error : TestResult::passed;
}

}  // namespace

std::string replay_summary(const std::vector<ReplayResult>& results) {
  const std::int64_t agree = count(results, ReplayEnd::agrees);
  std::string text = fmt::format("{} of {} recording{} agree{}", agree, results.size(),
                                 results.size() == 1 ? "" : "s", agree == 1 ? "s" : "");
  if (const auto differ = count(results, ReplayEnd::differs); differ > 0)
    text += fmt::format("; {} differ{}", differ, differ == 1 ? "s" : "");
  if (const auto blessed = count(results, ReplayEnd::blessed); blessed > 0)
    text += fmt::format("; {} differed and {} made again", blessed, blessed == 1 ? "is" : "are");
  if (const auto errors = count(results, ReplayEnd::error); errors > 0)
    text += fmt::format("; {} could not be replayed", errors);
  return text;
}

std::string replay_json(const std::vector<ReplayResult>& results) {
  Json json{{"schema", kReplaySchema},
            {"softcnc", SOFTCNC_VERSION},
            {"agree", count(results, ReplayEnd::agrees)},
            {"differ", count(results, ReplayEnd::differs)},
            {"blessed", count(results, ReplayEnd::blessed)},
            {"errors", count(results, ReplayEnd::error)},
            {"recordings", Json::array()}};
  for (const ReplayResult& result : results) json["recordings"].push_back(result_json(result));
  return json.dump(2) + '\n';
}

std::vector<TestCase> replay_cases(const std::vector<ReplayResult>& results) {
  std::vector<TestCase> cases;
  for (const ReplayResult& result : results)
    cases.push_back({result.name, test_result(result.end), result.message, result.code,
                     result.end == ReplayEnd::blessed ? "blessed: " + result.message : result.table,
                     result.seconds});
  return cases;
}

}  // namespace softcnc::app
