// SPDX-License-Identifier: MIT
// JSON by hand: nearly every text in it is one of ours, and programs have a million blocks.
#include "output/block_json.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "motion/core/units.hpp"

namespace softcnc::app {
namespace {

std::string_view kind_of(const Move& move) {
  if (std::holds_alternative<Arc>(move.path)) return "arc";
  if (std::holds_alternative<Nurbs>(move.path)) return "nurbs";
  return move.rapid ? "rapid" : "feed";
}

std::string_view name(Plane plane) {
  constexpr std::array<std::string_view, 3> names{"XY", "ZX", "YZ"};
  return names[static_cast<std::size_t>(plane)];
}

std::string_view name(Action::Kind kind) {
  constexpr std::array<std::string_view, 7> names{"tool", "spindle", "coolant", "stop",
                                                  "end",  "output",  "probe"};
  return names[static_cast<std::size_t>(kind)];
}

/// What an M code of the machine switches, by the code that it stands for.
std::string_view coolant_of(int code) {
  constexpr int kMist = 7, kFlood = 8;
  return code == kMist ? "mist" : code == kFlood ? "flood" : "off";
}

/// Without what the way through mm has rounded.
double as_written(double um) {
  constexpr double kDigits = 1e9;
  return std::round(um * kDigits) / kDigits;
}

}  // namespace

std::string_view BlockJson::operator()(const Block& block, const std::string& file) {
  text_.clear();
  text_.add('{');
  value("\"line\":", block.source.line);
  if (block.source.file != 0) name_file(file);
  value("\"block\":", block.number);
  std::visit([this](const auto& what) { write(what); }, block.what);
  text_.back() = '}';
  text_.add('\n');
  return text_.text();
}

/// The only text that is not ours.
void BlockJson::name_file(const std::string& file) {
  using Json = nlohmann::json;
  if (file != file_ || file_text_.empty()) {
    file_ = file;
    file_text_ = Json(file).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  text_.add("\"file\":");
  text_.add(file_text_);
  text_.add(',');
}

void BlockJson::write(const Move& move) {
  word("\"kind\":", kind_of(move));
  place("\"from\":", start(move.path));
  place("\"to\":", end(move.path));
  if (!move.rapid) value("\"feed_mm_s\":", move.feed);
  if (!move.rapid && !move.feed_override) text_.add("\"feed_override\":false,");
  if (!move.rapid && !move.speed_override) text_.add("\"speed_override\":false,");
  std::visit([this](const auto& curve) { details(curve); }, move.path);
  if (move.surface) write(*move.surface);
}

void BlockJson::write(const Dwell& dwell) {
  word("\"kind\":", "dwell");
  value("\"duration_s\":", dwell.duration);
}

void BlockJson::write(const Action& action) {
  word("\"kind\":", name(action.kind));
  if (action.code > 0) value("\"code\":", action.code);
  if (action.kind == Action::Kind::tool) value("\"tool\":", action.value);
  if (action.kind == Action::Kind::spindle) value("\"rpm\":", action.value);
  if (action.kind == Action::Kind::coolant && action.value > 0)
    word("\"coolant\":", coolant_of(static_cast<int>(action.value)));
  if (action.kind == Action::Kind::output) write_output(action);
}

void BlockJson::write_output(const Action& action) {
  const OutputPort& port = action.port;
  if (outputs_ != nullptr)
    if (const auto named = find_port(*outputs_, port.kind, port.number); named != outputs_->end())
      word("\"output\":", named->first);
  word("\"signal\":", name(port.kind));
  value("\"number\":", port.number);
  value("\"value\":", action.value);
}

void BlockJson::details(const Arc& arc) {
  word("\"plane\":", name(arc.plane()));
  value("\"center\":", arc.center());
  text_.add("\"ccw\":");
  text_.add(arc.ccw() ? "true," : "false,");
  value("\"turns\":", arc.turns());
  value("\"radius\":", arc.radius());
}

void BlockJson::details(const Nurbs& nurbs) {
  const NurbsSpec& spec = nurbs.spec();
  value("\"degree\":", spec.degree);
  list("\"control\":", spec.control);
  list("\"weights\":", spec.weights);
  list("\"knots\":", spec.knots);
}

template <typename Key, typename Value>
void BlockJson::value(const Key& key, const Value& value) {
  text_.add(key);
  add(value);
  text_.add(',');
}

void BlockJson::write(const Surface& surface) {
  text_.add("\"surface\":{");
  value("\"tool_radius_mm\":", surface.tool_radius);
  value("\"pick_feed_mm\":", surface.pick_feed);
  value("\"rmax_um\":", as_written(um_from_mm(surface.rmax)));
  value("\"teeth\":", surface.teeth);
  if (surface.transverse_curvature != 0)
    value("\"radius_across_mm\":", as_written(1 / surface.transverse_curvature));
  if (surface.slope_across != 0)
    value("\"slope_across_deg\":", as_written(deg_from_rad(surface.slope_across)));
  text_.back() = '}';
  text_.add(',');
}

[[gnu::hot]] void BlockJson::word(std::string_view key, std::string_view value) {
  text_.add(key);
  text_.add('"');
  text_.add(value);
  text_.add("\",");
}

/// Most moves begin in the place where the one before has ended: its text stands ready.
template <typename Key>
void BlockJson::place(const Key& key, const AxisVector& value) {
  text_.add(key);
  if (value == last_ && last_text_.size() > 0) {
    text_.add(last_text_.text());
  } else {
    const std::size_t begin = text_.size();
    add(value);
    last_text_.clear();
    last_text_.add(text_.text().substr(begin));
    last_ = value;
  }
  text_.add(',');
}

template <typename Key, typename Range>
void BlockJson::list(const Key& key, const Range& range) {
  text_.add(key);
  text_.add('[');
  for (const auto& value : range) {
    add(value);
    text_.add(',');
  }
  text_.back() = ']';
  text_.add(',');
}

[[gnu::hot]] void BlockJson::add(const AxisVector& value) {
  text_.add('[');
  for (const double component : value) {
    text_.add(component);
    text_.add(',');
  }
  text_.back() = ']';
}

}  // namespace softcnc::app
