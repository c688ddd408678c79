// SPDX-License-Identifier: MIT
#include "recording/row_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace softcnc::app {
namespace {

/// No trace of a run holds what is not finite: such a word is no number, and equals itself alone.
std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool exact(std::string_view column) {
  return column == "line" || column == "block" || column == "limit";
}

double tolerance(std::string_view column, double value) {
  if (column == "t_s") return 1e-9;
  if (column.ends_with("_mm")) return 1e-6;
  if (column.ends_with("_um")) return 1e-3;
  return 1e-6 * std::max(1.0, std::abs(value));
}

std::string difference(std::string_view a, std::string_view b) {
  const auto recorded = number(a), replayed = number(b);
  if (a == b || !recorded || !replayed) return {};
  return fmt::format("{:+.3g}", *replayed - *recorded);
}

/// A row by the names of its columns.
class ParsedRow {
 public:
  ParsedRow(const std::vector<std::string>& columns, std::string_view line)
      : columns_(columns), values_(split(line)) {
    values_.resize(columns.size());
  }
  const std::string& operator[](std::size_t column) const { return values_[column]; }
  std::string word(std::string_view column) const {
    const auto found = std::find(columns_.begin(), columns_.end(), column);
    return found == columns_.end() ? std::string() : values_[index(found)];
  }
  double value(std::string_view column) const { return number(word(column)).value_or(0); }

 private:
  std::size_t index(std::vector<std::string>::const_iterator found) const {
    return static_cast<std::size_t>(found - columns_.begin());
  }
  const std::vector<std::string>& columns_;
  std::vector<std::string> values_;
};

/// Straight from one place to the other, mm.
double apart(const ParsedRow& a, const ParsedRow& b) {
  double squares = 0;
  for (const char* axis : {"x_mm", "y_mm", "z_mm"})
    squares += std::pow(b.value(axis) - a.value(axis), 2);
  return std::sqrt(squares);
}

/// Along the path no two places are further apart than the lengths to them differ.
std::string meaning(const ParsedRow& recorded, const ParsedRow& replayed) {
  constexpr double kSame = 1e-6, kOfLength = 1e-3;  // mm; of a length
  const double far = apart(recorded, replayed);
  if (far <= kSame) return "the tool is in the same place";
  if (recorded.word("block") != replayed.word("block"))
    return fmt::format(
        "the tool is {:.4g} mm away, in another block: the motion takes a different time", far);
  const double along = replayed.value("s_mm") - recorded.value("s_mm");
  if (far <= std::abs(along) * (1 + kOfLength) + kSame)
    return fmt::format("the same path at a different time: the tool is {:.4g} mm {}",
                       std::abs(along), along > 0 ? "ahead" : "behind");
  return fmt::format("a different path, or a different part of it: the tool is {:.4g} mm away",
                     far);
}

}  // namespace

bool same_value(std::string_view column, std::string_view a, std::string_view b) {
  if (a == b) return true;
  const auto recorded = number(a), replayed = number(b);
  if (exact(column) || !recorded || !replayed) return false;
  return std::abs(*replayed - *recorded) <= tolerance(column, *recorded);
}

bool same_row(const std::vector<std::string>& columns, std::string_view a, std::string_view b) {
  if (a == b) return true;
  const auto recorded = split(a), replayed = split(b);
  if (recorded.size() != columns.size() || replayed.size() != columns.size()) return false;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!same_value(columns[i], recorded[i], replayed[i])) return false;
  return true;
}

std::string in_words(const std::vector<std::string>& columns, std::string_view recorded,
                     std::string_view replayed) {
  const ParsedRow a(columns, recorded), b(columns, replayed);
  std::string text, others;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (same_value(columns[i], a[i], b[i])) continue;
    if (text.empty())
      text = fmt::format("at {} s, line {}, {} is {} in the recording and {} here", a.word("t_s"),
                         a.word("line"), columns[i], a[i], b[i]);
    else
      others += (others.empty() ? "" : ", ") + columns[i];
  }
  if (!others.empty()) text += "; " + others + " differ as well";
  return text + "; " + meaning(a, b);
}

std::string side_by_side(const std::vector<std::string>& columns, std::string_view recorded,
                         std::string_view replayed) {
  auto a = split(recorded), b = split(replayed);
  a.resize(columns.size());
  b.resize(columns.size());
  std::string text =
      fmt::format("  {:<14} {:>24} {:>24}  {}\n", "column", "recorded", "replayed", "difference");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const bool same = same_value(columns[i], a[i], b[i]);
    std::string line = fmt::format("{} {:<14} {:>24} {:>24}  {}", same ? ' ' : '!', columns[i],
                                   a[i], b[i], difference(a[i], b[i]));
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> values;
  while (!line.empty()) {
    const std::size_t comma = line.find(',');
    values.emplace_back(line.substr(0, comma));
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
  }
  return values;
}

}  // namespace softcnc::app
