// SPDX-License-Identifier: MIT
#include "recording_meta.hpp"

#include <nlohmann/json.hpp>

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

RecordingMeta read(const Json& json) {
  const Json& options = json.at("options");
  return {json.at("program").at("name"),
          json.at("program").at("hash"),
          json.at("machine").at("hash"),
          json.at("trace").at("hash"),
          json.at("trace").at("rows"),
          {options.at("feed_override"), {options.at("block_skip"), options.at("optional_stop")}}};
}

}  // namespace

std::string meta_json(const RecordingMeta& meta) {
  const Json json{
      {"schema", kRecordingSchema},
      {"softcnc", SOFTCNC_VERSION},
      {"program", {{"name", meta.program_name}, {"hash", meta.program_hash}}},
      {"machine", {{"hash", meta.machine_hash}}},
      {"trace", {{"hash", meta.trace_hash}, {"rows", meta.rows}}},
      {"options",
       {{"feed_override", meta.options.feed_override},
        {"block_skip", meta.options.interpreter.block_skip},
        {"optional_stop", meta.options.interpreter.optional_stop}}},
      {"start", {{"position_mm", {0, 0, 0}}, {"tool", nullptr}, {"offsets_mm", {0, 0, 0}}}}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<RecordingMeta> parse_meta(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    if (const int schema = json.at("schema"); schema != kRecordingSchema)
      return tl::make_unexpected(Diagnostic{Code::SC6022,
                                            {},
                                            "is a recording of schema " + std::to_string(schema) +
                                                "; this version replays schema " +
                                                std::to_string(kRecordingSchema),
                                            {},
                                            {}});
    return read(json);
  } catch (const Json::exception& error) {
    return tl::make_unexpected(Diagnostic{
        Code::SC6021, {}, std::string("has a meta.json that says: ") + error.what(), {}, {}});
  }
}

}  // namespace softcnc::app
