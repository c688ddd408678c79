// SPDX-License-Identifier: MIT
// SARIF 2.1.0: the Static Analysis Results Interchange Format of OASIS.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "messages/diagnostic_document.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSarifSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

Json text(std::string_view says) { return {{"text", says}}; }

/// SARIF asks for sentences.
std::string sentence(std::string_view words) {
  std::string says(words);
  if (!says.empty() && says[0] >= 'a' && says[0] <= 'z')
    says[0] = static_cast<char>(says[0] - 'a' + 'A');
  return says + '.';
}

Json rule_of(const CodeInfo& info) {
  return {{"id", code_name(info.code)},
          {"shortDescription", text(sentence(info.title))},
          {"help", text(sentence(info.help))},
          {"defaultConfiguration", {{"level", name(info.severity)}}}};
}

Json rules() {
  Json list = Json::array();
  for (const CodeInfo& info : code_table()) list.push_back(rule_of(info));
  return list;
}

std::ptrdiff_t rule_index(Code code) { return &code_info(code) - code_table().data(); }

Json region_of(const SourcePos& pos) {
  Json region{{"startLine", pos.line}};
  if (pos.column > 0) {
    region["startColumn"] = pos.column;
    region["endColumn"] = pos.column + pos.length;
  }
  return region;
}

Json location_of(const Diagnostic& shown, const std::string& file) {
  Json place{{"artifactLocation", {{"uri", uri_of(file)}}}};
  if (shown.pos.line > 0) {
    place["region"] = region_of(shown.pos);
    if (!shown.source_line.empty())
      place["contextRegion"] = {{"startLine", shown.pos.line},
                                {"snippet", text(shown.source_line)}};
  }
  return {{"physicalLocation", place}};
}

/// The calls that led to the place, the last one first.
Json related_locations(const Diagnostic& diagnostic) {
  Json list = Json::array();
  for (const CallPlace& call : diagnostic.calls) {
    const Json region{{"startLine", call.line}, {"startColumn", call.column}};
    list.push_back({{"physicalLocation",
                     {{"artifactLocation", {{"uri", uri_of(call.file)}}}, {"region", region}}},
                    {"message", text("called from here")}});
  }
  return list;
}

Json result_of(const Diagnostic& diagnostic) {
  const Diagnostic shown = softcnc::shown(diagnostic);
  Json result{{"ruleId", code_name(shown.code)},
              {"ruleIndex", rule_index(shown.code)},
              {"level", name(shown.severity())},
              {"message", text(shown.message)}};
  if (!diagnostic.file.empty())
    result["locations"] = Json::array({location_of(shown, diagnostic.file)});
  if (!diagnostic.calls.empty()) result["relatedLocations"] = related_locations(diagnostic);
  return result;
}

/// Whether the tool did its work, whatever it found: wrong usage, files and signals are not that.
bool has_worked(int status) { return status <= 1 || status == 3 || status == 4; }

class SarifDocument final : public DiagnosticDocument {
 public:
  explicit SarifDocument(Write write) : write_(std::move(write)) {}

  void add(const Diagnostic& diagnostic) override {
    begin();
    write_((std::exchange(empty_, false) ? "\n" : ",\n") + result_of(diagnostic).dump());
  }

  void finish(int status) override {
    begin();
    const Json invocation{{"executionSuccessful", has_worked(status)}, {"exitCode", status}};
    write_((empty_ ? "" : "\n") + std::string("],\n\"invocations\":[") + invocation.dump() +
           "]}]}\n");
  }

 private:
  void begin() {
    if (std::exchange(begun_, true)) return;
    const Json driver{{"name", "softcnc"}, {"version", SOFTCNC_VERSION}, {"rules", rules()}};
    write_("{\"$schema\":" + Json(kSarifSchema).dump() + ",\"version\":\"2.1.0\",\"runs\":[{\n" +
           "\"tool\":{\"driver\":" + driver.dump() + "},\n" +
           "\"columnKind\":\"unicodeCodePoints\",\n\"results\":[");
  }

  Write write_;
  bool begun_ = false, empty_ = true;
};

bool is_plain(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

}  // namespace

std::unique_ptr<DiagnosticDocument> sarif_document(DiagnosticDocument::Write write) {
  return std::make_unique<SarifDocument>(std::move(write));
}

std::string uri_of(std::string_view file) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string uri = file.starts_with('/') ? "file://" : "";
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_plain(c))
      uri += c;
    else
      ((uri += '%') += kDigits[byte >> 4U]) += kDigits[byte & 15U];
  }
  return uri;
}

}  // namespace softcnc::app
