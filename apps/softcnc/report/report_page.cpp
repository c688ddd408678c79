// SPDX-License-Identifier: MIT
#include "report/report_page.hpp"

#include <nlohmann/json.hpp>
#include <string_view>

#include "report/page.hpp"
#include "report/run_comparison.hpp"
#include "report/run_json.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPageSchema = 1;
constexpr std::string_view kPlace = "<!--softcnc-report-->";

/// Within a script element nothing may look like its end.
std::string script_text(const Json& json) {
  std::string text;
  for (const char letter : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (letter == '<')
      text += "\\u003c";
    else
      text += letter;
  return text;
}

std::string element(std::string_view type, std::string_view id, std::string_view text) {
  std::string element = "<script type=\"";
  element.append(type).append("\" id=\"").append(id).append("\">");
  return element.append(text).append("</script>\n");
}

Result<std::string> data_elements(std::span<const ReportedRun> runs,
                                  const std::optional<WhatIf>& what_if) {
  PackedData data;
  Json report{{"schema", kPageSchema}, {"softcnc", SOFTCNC_VERSION}, {"runs", Json::array()}};
  for (const ReportedRun& run : runs) report["runs"].push_back(run_json(run, data));
  if (runs.size() == 2) {
    const auto comparison = compare_runs(runs[0], runs[1]);
    if (!comparison) return tl::make_unexpected(comparison.error());
    report["comparison"] = comparison_json(*comparison);
  }
  if (what_if) report["what_if"] = what_if_json(*what_if);
  return element("application/json", "softcnc-report", script_text(report)) +
         element("text/plain", "softcnc-data", data.base64());
}

}  // namespace

Result<std::string> report_page(std::span<const ReportedRun> runs,
                                const std::optional<WhatIf>& what_if) {
  const auto data = data_elements(runs, what_if);
  if (!data) return data;
  std::string page;
  for (const std::string_view piece : page_pieces()) page += piece;
  const std::size_t place = page.find(kPlace);
  return page.replace(place, kPlace.size(), *data);
}

}  // namespace softcnc::app
