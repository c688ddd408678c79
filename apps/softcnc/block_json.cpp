// SPDX-License-Identifier: MIT
// JSON by hand: every text in it is one of ours, and programs have a million blocks.
#include "block_json.hpp"

#include <array>

#include "hal/number.hpp"

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
  constexpr std::array<std::string_view, 5> names{"tool", "spindle", "coolant", "stop", "end"};
  return names[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string_view BlockJson::operator()(const Block& block) {
  text_ = "{";
  number("line", block.source.line);
  number("block", block.number);
  std::visit([this](const auto& what) { write(what); }, block.what);
  text_.back() = '}';
  text_ += '\n';
  return text_;
}

void BlockJson::write(const Move& move) {
  word("kind", kind_of(move));
  vector("from", start(move.path));
  vector("to", end(move.path));
  if (!move.rapid) number("feed_mm_s", move.feed);
  std::visit([this](const auto& curve) { details(curve); }, move.path);
}

void BlockJson::write(const Dwell& dwell) {
  word("kind", "dwell");
  number("duration_s", dwell.duration);
}

void BlockJson::write(const Action& action) {
  word("kind", name(action.kind));
  if (action.code > 0) number("code", action.code);
  if (action.kind == Action::Kind::tool) number("tool", action.value);
  if (action.kind == Action::Kind::spindle) number("rpm", action.value);
}

void BlockJson::details(const Arc& arc) {
  word("plane", name(arc.plane()));
  vector("center", arc.center());
  key("ccw");
  text_ += arc.ccw() ? "true," : "false,";
  number("turns", arc.turns());
  number("radius", arc.radius());
}

void BlockJson::details(const Nurbs& nurbs) {
  const NurbsSpec& spec = nurbs.spec();
  number("degree", spec.degree);
  list("control", spec.control, [this](const AxisVector& point) { append(point); });
  list("weights", spec.weights, [this](double weight) { append(weight); });
  list("knots", spec.knots, [this](double knot) { append(knot); });
}

void BlockJson::key(std::string_view name) { (((text_ += '"') += name) += '"') += ':'; }

void BlockJson::number(std::string_view name, double value) {
  key(name);
  append(value);
  text_ += ',';
}

void BlockJson::vector(std::string_view name, const AxisVector& value) {
  key(name);
  append(value);
  text_ += ',';
}

void BlockJson::word(std::string_view name, std::string_view value) {
  key(name);
  ((text_ += '"') += value) += "\",";
}

template <typename Range, typename Append>
void BlockJson::list(std::string_view name, const Range& range, Append&& append_one) {
  key(name);
  text_ += '[';
  for (const auto& value : range) {
    append_one(value);
    text_ += ',';
  }
  text_.back() = ']';
  text_ += ',';
}

void BlockJson::append(double value) {
  char text[hal::kNumberLength];
  text_.append(text, hal::write_number(text, value));
}

void BlockJson::append(const AxisVector& value) {
  text_ += '[';
  for (const double component : value) {
    append(component);
    text_ += ',';
  }
  text_.back() = ']';
}

}  // namespace softcnc::app
