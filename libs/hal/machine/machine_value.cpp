// SPDX-License-Identifier: MIT
// Type, range and scale of the values of a machine file.
#include "hal/machine/machine_value.hpp"

#include <algorithm>
#include <cmath>

#include "hal/files/number.hpp"
#include "hal/machine/toml_text.hpp"
#include "motion/core/spelling.hpp"

namespace softcnc::hal {
namespace {

struct TypeName {
  std::string_view operator()(double) const { return "a number"; }
  std::string_view operator()(std::int64_t) const { return "a number"; }
  std::string_view operator()(const std::string&) const { return "a string"; }
  std::string_view operator()(const std::vector<double>&) const { return "an array"; }
  std::string_view operator()(const std::vector<std::string>&) const { return "an array"; }
  std::string_view operator()(const NumberRows&) const { return "an array of arrays"; }
  std::string_view operator()(const OtherTomlValue& other) const { return other.type; }
};

Status wrong_type(const KeyRef& ref, std::string_view wanted, const FileValue& value) {
  return value_failure(Code::SC7004, path_of(ref) + " takes " + std::string(wanted) + ", not " +
                                         std::string(std::visit(TypeName{}, value)));
}

std::string range_text(const ValueRange& range) {
  return (range.or_0 ? "0, or at least " : "at least ") + number_text(range.low) + " and at most " +
         number_text(range.high);
}

Status check(const KeyRef& ref, double value, const ValueRange& range) {
  const bool within = value >= range.low && value <= range.high;  // false for NaN
  if (within || (range.or_0 && value == 0)) return {};
  return value_failure(
      Code::SC7005, path_of(ref) + " must be " + range_text(range) + ", not " + number_text(value));
}

Status store(const NumberKey& number, const KeyRef& ref, const FileValue& value, Machine& machine) {
  double file_value = 0;
  if (const auto* real = std::get_if<double>(&value))
    file_value = *real;
  else if (const auto* whole = std::get_if<std::int64_t>(&value))
    file_value = static_cast<double>(*whole);
  else
    return wrong_type(ref, "a number", value);
  if (auto checked = check(ref, file_value, number.range); !checked) return checked;
  number.place(machine, ref.index) = number.to_internal(file_value + 0.0);
  return {};
}

Status store(const WholeKey& whole, const KeyRef& ref, const FileValue& value, Machine& machine) {
  const auto* given = std::get_if<std::int64_t>(&value);
  if (!given) return wrong_type(ref, "an integer", value);
  auto checked = check(ref, static_cast<double>(*given), whole.range);
  if (checked) whole.place(machine, ref.index) = static_cast<int>(*given);
  return checked;
}

Status store(const ChoiceKey& choice, const KeyRef& ref, const FileValue& value, Machine& machine) {
  const auto* word = std::get_if<std::string>(&value);
  if (!word) return wrong_type(ref, "one of " + quoted_words(choice.words), value);
  const auto found = std::find(choice.words.begin(), choice.words.end(), *word);
  if (found == choice.words.end())
    return value_failure(Code::SC7006, path_of(ref) + " must be one of " +
                                           quoted_words(choice.words) + ", not '" + *word + "'" +
                                           did_you_mean(nearest_name(*word, choice.words)));
  choice.set(machine, static_cast<int>(found - choice.words.begin()));
  return {};
}

Status store(const TextKey& text, const KeyRef& ref, const FileValue& value, Machine& machine) {
  const auto* given = std::get_if<std::string>(&value);
  if (!given) return wrong_type(ref, "a string", value);
  text.place(machine, ref.index) = *given;
  return {};
}

Status store(const PointKey& point, const KeyRef& ref, const FileValue& value, Machine& machine) {
  const auto* given = std::get_if<std::vector<double>>(&value);
  if (!given || (!given->empty() && given->size() != kAxes))
    return wrong_type(ref, "an array of three numbers, or of none", value);
  for (const double number : *given)
    if (auto checked = check(ref, number, point.range); !checked) return checked;
  point.place(machine, ref.index) = *given;
  return {};
}

/// An empty array has no type of its own.
const NumberRows* as_rows(const FileValue& value) {
  static const NumberRows kNone;
  if (const auto* numbers = std::get_if<std::vector<double>>(&value))
    return numbers->empty() ? &kNone : nullptr;
  return std::get_if<NumberRows>(&value);
}

/// The pairs must describe a function that can be undone.
Status check(const PairsKey& pairs, const KeyRef& ref, const std::vector<PitchPoint>& points) {
  if (points.size() > pairs.most)
    return value_failure(Code::SC7052, path_of(ref) + " has " + std::to_string(points.size()) +
                                           " pairs, more than " + std::to_string(pairs.most));
  for (std::size_t i = 1; i < points.size(); ++i) {
    const PitchPoint &low = points[i - 1], &high = points[i];
    const std::string place = " at " + number_text(high.position) + " mm";
    if (!(high.position > low.position))
      return value_failure(Code::SC7052, path_of(ref) + " does not ascend" + place);
    if (std::abs(high.error - low.error) > pairs.steepest * (high.position - low.position))
      return value_failure(Code::SC7052, path_of(ref) + " changes by more than " +
                                             number_text(1e3 * pairs.steepest) + " um in a mm" +
                                             place);
  }
  return {};
}

Status store(const PairsKey& pairs, const KeyRef& ref, const FileValue& value, Machine& machine) {
  const NumberRows* rows = as_rows(value);
  const auto is_pair = [](const std::vector<double>& row) { return row.size() == 2; };
  if (!rows || !std::all_of(rows->begin(), rows->end(), is_pair))
    return wrong_type(ref, "an array of pairs of numbers", value);
  std::vector<PitchPoint> points;
  for (const auto& row : *rows) {
    if (auto checked = check(ref, row[0], pairs.position); !checked) return checked;
    if (auto checked = check(ref, row[1], pairs.range); !checked) return checked;
    points.push_back({row[0] + 0.0, pairs.to_internal(row[1] + 0.0)});
  }
  auto checked = check(pairs, ref, points);
  if (checked) pairs.place(machine, ref.index) = std::move(points);
  return checked;
}

Status store(const ListKey& list, const KeyRef& ref, const FileValue& value, Machine& machine) {
  const auto* numbers = std::get_if<std::vector<double>>(&value);
  if (numbers && numbers->empty()) {
    list.place(machine, ref.index).clear();
    return {};
  }
  const auto* texts = std::get_if<std::vector<std::string>>(&value);
  if (!texts) return wrong_type(ref, "an array of strings", value);
  if (std::find(texts->begin(), texts->end(), "") != texts->end())
    return value_failure(Code::SC7030, path_of(ref) + " names a folder by an empty string");
  list.place(machine, ref.index) = *texts;
  return {};
}

struct Allowed {
  std::string operator()(const NumberKey& number) const { return range_text(number.range); }
  std::string operator()(const WholeKey& whole) const {
    return "integer, " + range_text(whole.range);
  }
  std::string operator()(const ChoiceKey& choice) const { return quoted_words(choice.words); }
  std::string operator()(const TextKey&) const { return "a string"; }
  std::string operator()(const ListKey&) const { return "an array of strings"; }
  std::string operator()(const PointKey& point) const {
    return "three numbers, each " + range_text(point.range) + ", or none";
  }
  std::string operator()(const PairsKey& pairs) const {
    return "up to " + std::to_string(pairs.most) + " pairs of numbers, in ascending order";
  }
};

struct Spell {
  const KeyRef& ref;
  Machine& machine;

  std::string operator()(const NumberKey& number) const {
    return scaled_text(number.place(machine, ref.index), number.to_internal, number.to_file);
  }
  std::string operator()(const WholeKey& whole) const {
    return std::to_string(whole.place(machine, ref.index));
  }
  std::string operator()(const ChoiceKey& choice) const {
    return toml_string(choice.words[static_cast<std::size_t>(choice.get(machine))]);
  }
  std::string operator()(const TextKey& text) const {
    return toml_string(text.place(machine, ref.index));
  }
  std::string operator()(const PointKey& point) const {
    std::string text;
    for (const double number : point.place(machine, ref.index))
      text += (text.empty() ? "" : ", ") + number_text(number);
    return '[' + text + ']';
  }
  std::string operator()(const ListKey& list) const {
    std::string text;
    for (const std::string& one : list.place(machine, ref.index))
      text += (text.empty() ? "" : ", ") + toml_string(one);
    return '[' + text + ']';
  }
  std::string operator()(const PairsKey& pairs) const {
    std::string text;
    for (const PitchPoint& point : pairs.place(machine, ref.index))
      text += (text.empty() ? "[" : ", [") + number_text(point.position) + ", " +
              scaled_text(point.error, pairs.to_internal, pairs.to_file) + ']';
    return '[' + text + ']';
  }
};

}  // namespace

std::optional<double> as_number(const FileValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return *real;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::nullopt;
}

std::string quoted_words(std::span<const std::string_view> words) {
  std::string text;
  for (const auto word : words)
    if (!word.empty()) text += (text.empty() ? "'" : ", '") + std::string(word) + "'";
  return text;
}

Status value_failure(Code code, std::string message) {
  return tl::make_unexpected(Diagnostic{.code = code, .message = std::move(message)});
}

Status assign(const KeyRef& ref, const FileValue& value, Machine& machine) {
  return std::visit([&](const auto& kind) { return store(kind, ref, value, machine); },
                    ref.key->value);
}

std::string allowed_text(const MachineKey& key) { return std::visit(Allowed{}, key.value); }

std::string value_text(const KeyRef& ref, Machine& machine) {
  return std::visit(Spell{ref, machine}, ref.key->value);
}

}  // namespace softcnc::hal
