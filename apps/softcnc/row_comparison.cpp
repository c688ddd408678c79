// SPDX-License-Identifier: MIT
#include "row_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace softcnc::app {
namespace {

std::optional<double> number(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
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
