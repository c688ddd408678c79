// SPDX-License-Identifier: MIT
#include "recording/recording_meta.hpp"

#include <nlohmann/json.hpp>
#include <set>

#include "hal/files/hash.hpp"
#include "hal/files/number.hpp"

namespace softcnc::app {
namespace {

using Json = nlohmann::ordered_json;

tl::unexpected<Diagnostic> error(Code code, std::string message) {
  return tl::make_unexpected(Diagnostic{.code = code, .message = std::move(message)});
}

constexpr int kFirstSchema = 1;  // without a hash

std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string hash_of_rest(Json json) {
  json.erase("hash");
  return hal::hash_hex(dumped(json));
}

/// Whether brackets outside of strings lie too deep: what copies or writes JSON calls itself once a
/// level.
bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool within_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') within_string = !within_string;
    if (c == '\\' && within_string) ++i;
    if (within_string) continue;
    if (c == '[' || c == '{') ++depth;
    if (c == ']' || c == '}') --depth;
    if (depth > kMaxMetaDepth) return true;
  }
  return false;
}

/// A count as it stands there: a number with a point, or too large, is none.
Result<std::int64_t> read_rows(const Json& trace) {
  const Json& rows = trace.at("rows");
  const bool whole = rows.is_number_unsigned() || rows.is_number_integer();
  const std::int64_t count = whole ? rows.get<std::int64_t>() : -1;
  if (count >= 0) return count;
  return error(Code::SC6021, "its meta.json has an invalid number of rows: " + rows.dump());
}

Result<double> read_override(const Json& options) {
  const double feed_override = options.at("feed_override");
  if (feed_override > 0 && feed_override <= runtime::kLargestOverride) return feed_override;
  return error(Code::SC6021,
               "its meta.json has an invalid feed override: " + options.at("feed_override").dump());
}

/// Each file is read once.
Result<std::vector<CalledFile>> read_called(const Json& json) {
  std::vector<CalledFile> called;
  std::set<std::string> names;
  for (const Json& file : json.value("called", Json::array())) {
    called.push_back({file.at("name"), file.at("hash"), {}});
    if (!names.insert(called.back().name).second)
      return error(Code::SC6021, "names a called file twice: '" + called.back().name + "'");
  }
  return called;
}

/// Recordings made before there were dialects name none.
Status read_dialect(const Json& options, ipr::InterpreterOptions& to) {
  const std::string word = options.value("dialect", std::string(name(ipr::Dialect::linuxcnc)));
  to.guess_dialect = word == ipr::kGuessed;
  if (to.guess_dialect) return {};
  for (const ipr::Dialect dialect : ipr::kAllDialects) {
    if (word != name(dialect)) continue;
    to.dialect = dialect;
    return {};
  }
  return error(Code::SC6022, "was made in a dialect this version does not know: '" + word + "'");
}

std::string_view dialect_word(const ipr::InterpreterOptions& options) {
  return options.guess_dialect ? ipr::kGuessed : name(options.dialect);
}

/// The same for formats.
Result<ipr::Format> read_format(const Json& options) {
  using ipr::Format;
  const std::string word = options.value("format", std::string(name(Format::automatic)));
  for (const Format format : {Format::automatic, Format::gcode, Format::commands})
    if (word == name(format)) return format;
  return error(Code::SC6022, "was made in a format this version does not know: '" + word + "'");
}

Result<std::vector<runtime::FeedEvent>> read_events(const Json& options) {
  std::vector<runtime::FeedEvent> events;
  for (const std::string text : options.value("at", Json::array())) {
    const auto event = runtime::parse_event(text);
    if (!event) return error(Code::SC6022, "has an unknown feed event: '" + text + "'");
    events.push_back(*event);
  }
  runtime::sort_events(events);
  return events;
}

Result<std::vector<ipr::Definition>> read_definitions(const Json& options) {
  std::vector<ipr::Definition> definitions;
  for (const std::string text : options.value("define", Json::array())) {
    auto definition = ipr::parse_definition(text);
    if (!definition) return error(Code::SC6021, "has an invalid definition: '" + text + "'");
    definitions.push_back(*std::move(definition));
  }
  return definitions;
}

Result<RecordingMeta> read(const Json& json) {
  const Json& options = json.at("options");
  ipr::InterpreterOptions interpreter;
  if (const auto known = read_dialect(options, interpreter); !known)
    return tl::make_unexpected(known.error());
  const auto format = read_format(options);
  if (!format) return tl::make_unexpected(format.error());
  auto events = read_events(options);
  if (!events) return tl::make_unexpected(std::move(events.error()));
  const auto rows = read_rows(json.at("trace"));
  if (!rows) return tl::make_unexpected(rows.error());
  const auto feed_override = read_override(options);
  if (!feed_override) return tl::make_unexpected(feed_override.error());
  auto called = read_called(json);
  if (!called) return tl::make_unexpected(std::move(called.error()));
  RecordingMeta meta{json.at("program").at("name"),
                     json.at("program").at("hash"),
                     json.at("machine").at("hash"),
                     json.at("trace").at("hash"),
                     json.contains("state") ? json.at("state").at("hash") : Json(""),
                     *rows,
                     std::move(*called),
                     {}};
  meta.options.feed_override = *feed_override;
  meta.options.events = std::move(*events);
  meta.options.interpreter = interpreter;
  meta.options.interpreter.block_skip = options.at("block_skip");
  meta.options.interpreter.optional_stop = options.at("optional_stop");
  meta.options.single_block = options.value("single_block", false);
  meta.options.interpreter.format = *format;
  auto definitions = read_definitions(options);
  if (!definitions) return tl::make_unexpected(std::move(definitions.error()));
  meta.options.interpreter.definitions = std::move(*definitions);
  return meta;
}

/// Where the machine stood, for people; state.toml is what a replay begins with.
Json start_json(const MachineState& state) {
  const AxisVector place = state.place();
  Json start{{"position_mm", {place.x(), place.y(), place.z()}}, {"tool", nullptr}};
  if (state.loaded_tool) start["tool"] = *state.loaded_tool;
  return start;
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
              {"dialect", dialect_word(meta.options.interpreter)},
              {"format", name(meta.options.interpreter.format)}}},
            {"start", start_json(meta.options.state)}};
  if (meta.options.single_block) json["options"]["single_block"] = true;
  for (const runtime::FeedEvent& event : meta.options.events)
    json["options"]["at"].push_back(runtime::event_text(event));
  for (const ipr::Definition& definition : meta.options.interpreter.definitions)
    json["options"]["define"].push_back(definition.name + '=' + hal::number_text(definition.value));
  for (const CalledFile& file : meta.called)
    json["called"].push_back({{"name", file.name}, {"hash", file.hash}});
  return sealed_meta(dumped(json));
}

std::string sealed_meta(const std::string& text) {
  Json json = is_too_deep(text) ? Json() : Json::parse(text, nullptr, false);
  if (!json.is_object()) return text;
  const std::string hash = hash_of_rest(json);
  json.erase("hash");
  json["hash"] = hash;
  return dumped(json);
}

Result<RecordingMeta> parse_meta(const std::string& text) {
  if (is_too_deep(text))
    return error(Code::SC6021, "its meta.json is nested deeper than " +
                                   std::to_string(kMaxMetaDepth) + " levels");
  try {
    const Json json = Json::parse(text);
    const Json& given = json.at("schema");
    const std::int64_t schema = given.is_number_integer() ? given.get<std::int64_t>() : 0;
    if (schema < kFirstSchema || schema > kRecordingSchema)
      return error(Code::SC6022, "is a recording of schema " + std::to_string(schema) +
                                     "; this version replays schemas " +
                                     std::to_string(kFirstSchema) + " to " +
                                     std::to_string(kRecordingSchema));
    if (schema > kFirstSchema && json.at("hash") != hash_of_rest(json))
      return error(Code::SC6021, "its meta.json is not what was recorded: the hash differs");
    return read(json);
  } catch (const Json::exception& broken) {
    return error(Code::SC6021, std::string("its meta.json is invalid: ") + broken.what());
  }
}

}  // namespace softcnc::app
