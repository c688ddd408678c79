// SPDX-License-Identifier: MIT
#include "recording_meta.hpp"

#include <nlohmann/json.hpp>

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

tl::unexpected<Diagnostic> error(Code code, std::string message) {
  return tl::make_unexpected(Diagnostic{code, {}, std::move(message), {}, {}});
}

/// Recordings made before there were dialects name none.
Result<ipr::Dialect> read_dialect(const Json& options) {
  const std::string word = options.value("dialect", std::string(name(ipr::Dialect::linuxcnc)));
  for (const ipr::Dialect dialect : {ipr::Dialect::linuxcnc, ipr::Dialect::fanuc})
    if (word == name(dialect)) return dialect;
  return error(Code::SC6022, "was made in a dialect this version does not know: '" + word + "'");
}

/// The same for formats.
Result<ipr::Format> read_format(const Json& options) {
  using ipr::Format;
  const std::string word = options.value("format", std::string(name(Format::automatic)));
  for (const Format format : {Format::automatic, Format::gcode, Format::commands})
    if (word == name(format)) return format;
  return error(Code::SC6022, "was made of a format this version does not know: '" + word + "'");
}

Result<std::vector<FeedEvent>> read_events(const Json& options) {
  std::vector<FeedEvent> events;
  for (const std::string text : options.value("at", Json::array())) {
    const auto event = parse_event(text);
    if (!event)
      return error(Code::SC6022, "asks at some moment for what is not known: '" + text + "'");
    events.push_back(*event);
  }
  sort_events(events);
  return events;
}

Result<RecordingMeta> read(const Json& json) {
  const Json& options = json.at("options");
  const auto dialect = read_dialect(options);
  if (!dialect) return tl::make_unexpected(dialect.error());
  const auto format = read_format(options);
  if (!format) return tl::make_unexpected(format.error());
  auto events = read_events(options);
  if (!events) return tl::make_unexpected(std::move(events.error()));
  RecordingMeta meta{json.at("program").at("name"),
                     json.at("program").at("hash"),
                     json.at("machine").at("hash"),
                     json.at("trace").at("hash"),
                     json.contains("state") ? json.at("state").at("hash") : Json(""),
                     json.at("trace").at("rows"),
                     {},
                     {}};
  for (const Json& file : json.value("called", Json::array()))
    meta.called.push_back({file.at("name"), file.at("hash")});
  meta.options.feed_override = options.at("feed_override");
  meta.options.events = std::move(*events);
  meta.options.interpreter.block_skip = options.at("block_skip");
  meta.options.interpreter.optional_stop = options.at("optional_stop");
  meta.options.single_block = options.value("single_block", false);
  meta.options.interpreter.dialect = *dialect;
  meta.options.interpreter.format = *format;
  return meta;
}

}  // namespace

std::string meta_json(const RecordingMeta& meta) {
  Json json{{"schema", kRecordingSchema},
            {"softcnc", SOFTCNC_VERSION},
            {"program", {{"name", meta.program_name}, {"hash", meta.program_hash}}},
            {"machine", {{"hash", meta.machine_hash}}},
            {"state", {{"hash", meta.state_hash}}},
            {"trace", {{"hash", meta.trace_hash}, {"rows", meta.rows}}},
            {"options",
             {{"feed_override", meta.options.feed_override},
              {"block_skip", meta.options.interpreter.block_skip},
              {"optional_stop", meta.options.interpreter.optional_stop},
              {"dialect", name(meta.options.interpreter.dialect)},
              {"format", name(meta.options.interpreter.format)}}},
            {"start", {{"position_mm", {0, 0, 0}}, {"tool", nullptr}}}};
  if (meta.options.single_block) json["options"]["single_block"] = true;
  for (const FeedEvent& event : meta.options.events)
    json["options"]["at"].push_back(event_text(event));
  for (const CalledFile& file : meta.called)
    json["called"].push_back({{"name", file.name}, {"hash", file.hash}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Result<RecordingMeta> parse_meta(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    if (const int schema = json.at("schema"); schema != kRecordingSchema)
      return error(Code::SC6022, "is a recording of schema " + std::to_string(schema) +
                                     "; this version replays schema " +
                                     std::to_string(kRecordingSchema));
    return read(json);
  } catch (const Json::exception& broken) {
    return error(Code::SC6021, std::string("has a meta.json that says: ") + broken.what());
  }
}

}  // namespace softcnc::app
