// SPDX-License-Identifier: MIT
// The JSON form, and the choice between the forms.
#include "messages/diagnostic_document.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

Json object_of(const Diagnostic& diagnostic) {
  const Diagnostic shown = softcnc::shown(diagnostic);
  Json object = Json::object();
  if (!shown.file.empty()) object["file"] = shown.file;
  if (shown.pos.line > 0) object["line"] = shown.pos.line;
  if (shown.pos.line > 0 && shown.pos.column > 0) {
    object["column"] = shown.pos.column;
    object["end_column"] = shown.pos.column + shown.pos.length;
  }
  object["severity"] = name(shown.severity());
  object["code"] = code_name(shown.code);
  object["message"] = shown.message;
  object["help"] = help_of(shown);
  if (!shown.source_line.empty()) object["source_line"] = shown.source_line;
  for (const CallPlace& call : shown.calls)
    object["called_from"].push_back(
        {{"file", call.file}, {"line", call.line}, {"column", call.column}});
  return object;
}

class JsonDocument final : public DiagnosticDocument {
 public:
  explicit JsonDocument(Write write) : write_(std::move(write)) {}

  void add(const Diagnostic& diagnostic) override {
    write_((std::exchange(empty_, false) ? "[\n" : ",\n") + object_of(diagnostic).dump());
  }
  void finish(int) override { write_(empty_ ? "[]\n" : "\n]\n"); }

 private:
  Write write_;
  bool empty_ = true;
};

}  // namespace

std::unique_ptr<DiagnosticDocument> json_document(DiagnosticDocument::Write write) {
  return std::make_unique<JsonDocument>(std::move(write));
}

std::unique_ptr<DiagnosticDocument> make_document(DiagnosticsFormat format,
                                                  DiagnosticDocument::Write write) {
  if (format == DiagnosticsFormat::json) return json_document(std::move(write));
  if (format == DiagnosticsFormat::sarif) return sarif_document(std::move(write));
  return nullptr;
}

}  // namespace softcnc::app
