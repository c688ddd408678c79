// SPDX-License-Identifier: MIT
#include "settings/tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "motion/core/spelling.hpp"
#include "motion/core/units.hpp"

namespace softcnc::app {
namespace {

using runtime::Aspect, runtime::Margin;

constexpr double kOnePercent = 0.01;

struct Unit {
  std::string_view name;
  double size;  // in s, mm or mm/s; of a value, for %
};
constexpr Unit kTimeUnits[] = {
    {"s", 1}, {"ms", s_from_ms(1)}, {"us", s_from_ns(1000)}, {"%", kOnePercent}};
constexpr Unit kLengths[] = {{"mm", 1}, {"um", mm_from_um(1)}};
constexpr Unit kSpeeds[] = {{"mm/s", 1}, {"mm/min", mm_s_from_mm_min(1)}, {"%", kOnePercent}};

std::span<const Unit> units_of(Aspect aspect) {
  if (aspect == Aspect::time) return kTimeUnits;
  if (aspect == Aspect::speed) return kSpeeds;
  return kLengths;
}

std::string list_of(std::span<const Unit> units) {
  std::string list;
  for (const Unit& unit : units) list += (list.empty() ? "" : ", ") + std::string(unit.name);
  return list;
}

/// Reads a number with one of the units.
std::optional<Margin> read_margin(std::string_view text, std::span<const Unit> units) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || !std::isfinite(number) || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const auto unit = std::find_if(units.begin(), units.end(),
                                 [&](const Unit& known) { return known.name == text; });
  if (unit == units.end()) return std::nullopt;
  const double value = number * unit->size;
  return unit->name == "%" ? Margin{0, value} : Margin{value, 0};
}

}  // namespace

std::string Tolerance::set(Aspect aspect, std::string_view value) {
  const auto margin = read_margin(value, units_of(aspect));
  if (!margin)
    return fmt::format("'{}' is no tolerance of {}, which is a number of {}", value, name(aspect),
                       list_of(units_of(aspect)));
  if (!std::exchange(named_, true))
    for (Margin& other : margins_) other.judged = false;
  margins_[static_cast<std::size_t>(aspect)] = *margin;
  return {};
}

std::string Tolerance::add_one(std::string_view word) {
  const auto equals = word.find('=');
  if (equals == word.npos) {
    const std::string wrong = set(Aspect::path, word);
    if (wrong.empty()) return set(Aspect::position, word);
    return fmt::format("'{}' is neither a length nor ASPECT=VALUE", word);
  }
  constexpr Aspect kWithValue[] = {Aspect::time, Aspect::path, Aspect::position, Aspect::speed};
  std::vector<std::string_view> known;
  for (const Aspect aspect : kWithValue) {
    known.push_back(name(aspect));
    if (name(aspect) == word.substr(0, equals)) return set(aspect, word.substr(equals + 1));
  }
  const std::string asked(word.substr(0, equals));
  return fmt::format("'{}' is not one of {}{}", asked, fmt::join(known, ", "),
                     did_you_mean(nearest_name(asked, known)));
}

std::string Tolerance::add(std::string_view list) {
  for (;;) {
    const auto comma = list.find(',');
    if (std::string wrong = add_one(list.substr(0, comma)); !wrong.empty()) return wrong;
    if (comma == list.npos) return {};
    list.remove_prefix(comma + 1);
  }
}

}  // namespace softcnc::app
