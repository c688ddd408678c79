// SPDX-License-Identifier: MIT
// The only file that knows toml++ and catches its exceptions.
#include "hal/machine/toml_reader.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <optional>

#include "hal/machine/toml_depth.hpp"

namespace softcnc::hal {
namespace {

/// Bytes before character `column` (from 1, in code points, as toml++ counts) of a line, plus 1.
int byte_column(std::string_view line, unsigned column) {
  std::size_t at = 0;
  for (unsigned seen = 1; at < line.size() && seen < column; ++seen) do
      ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U);
  return static_cast<int>(at) + 1;
}

/// Positions in a text, in bytes.
class BytePositions {
 public:
  explicit BytePositions(std::string_view text) : lines_(text) {}

  SourcePos of(const toml::source_region& region) const;

 private:
  int column(unsigned line, unsigned column) const;

  TextLines lines_;
};

int BytePositions::column(unsigned line, unsigned column) const {
  return byte_column(lines_[static_cast<int>(line)], column);
}

SourcePos BytePositions::of(const toml::source_region& region) const {
  const int first = column(region.begin.line, region.begin.column);
  const bool one_line = region.end.line == region.begin.line;
  const int end = one_line ? column(region.end.line, region.end.column) : first + 1;
  return {static_cast<int>(region.begin.line), first, std::max(1, end - first)};
}

std::optional<std::vector<double>> numbers_of(const toml::array& array) {
  std::vector<double> numbers;
  for (const auto& element : array) {
    const auto number = element.value<double>();
    if (!number || !element.is_number()) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Numbers, or arrays of numbers, or else just an array.
FileValue value_of(const toml::array& array) {
  if (auto numbers = numbers_of(array)) return *std::move(numbers);
  NumberRows rows;
  for (const auto& element : array) {
    auto row = element.is_array() ? numbers_of(*element.as_array()) : std::nullopt;
    if (!row) return OtherTomlValue{"an array"};
    rows.push_back(*std::move(row));
  }
  return rows;
}

FileValue value_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::floating_point:
      return node.as_floating_point()->get();
    case toml::node_type::integer:
      return node.as_integer()->get();
    case toml::node_type::string:
      return node.as_string()->get();
    case toml::node_type::boolean:
      return OtherTomlValue{"true or false"};
    case toml::node_type::array:
      return value_of(*node.as_array());
    case toml::node_type::table:
      return OtherTomlValue{"a table"};
    default:
      return OtherTomlValue{"a date or time"};
  }
}

void flatten(const BytePositions& places, const toml::table& table, const std::string& path,
             std::vector<TomlEntry>& entries) {
  for (const auto& [key, node] : table) {
    const std::string name = path + std::string(key.str());
    entries.push_back(
        {name, node.is_table(), value_of(node), places.of(key.source()), places.of(node.source())});
    if (const auto* inner = node.as_table()) flatten(places, *inner, name + '.', entries);
  }
}

/// The key at a place of the text, in quotes.
std::string key_at(std::string_view text, const SourcePos& pos) {
  const std::string_view line = TextLines(text)[pos.line];
  const auto begin = std::min(line.size(), static_cast<std::size_t>(pos.column) - 1);
  const auto end = line.find_first_of(" \t.=]", begin);
  return "'" + std::string(line.substr(begin, end - begin)) + "'";
}

/// What toml++ says in quotes, or what stands there.
std::string key_of(std::string_view says, std::string_view text, const SourcePos& pos) {
  const auto quote = says.find('\'');
  return quote == says.npos ? key_at(text, pos) : std::string(says.substr(quote));
}

/// toml++ reports a key given twice only in words: "... cannot redefine existing integer 'blu_um'",
/// or "... existing integer as dotted key-value pair".
Diagnostic diagnostic_of(std::string_view text, const toml::parse_error& error) {
  constexpr std::string_view kPrefix = "Error while parsing ";
  std::string_view says = error.description();
  const SourcePos pos = BytePositions(text).of(error.source());
  if (says.find("cannot redefine") != says.npos)
    return {
        .code = Code::SC7012, .pos = pos, .message = key_of(says, text, pos) + " is given twice"};
  if (says.starts_with(kPrefix)) says.remove_prefix(kPrefix.size());
  return {.code = Code::SC7002, .pos = pos, .message = "not TOML: " + std::string(says)};
}

}  // namespace

Result<std::vector<TomlEntry>> read_toml(std::string_view text) {
  if (Status flat = check_toml_depth(text); !flat)
    return tl::make_unexpected(std::move(flat.error()));
  try {
    std::vector<TomlEntry> entries;
    flatten(BytePositions(text), toml::parse(text), "", entries);
    return entries;
  } catch (const toml::parse_error& error) {
    return tl::make_unexpected(diagnostic_of(text, error));
  }
}

FileValue read_toml_value(const std::string& text) {
  if (!check_toml_depth(text)) return text;
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) return value_of(table.begin()->second);
  } catch (const toml::parse_error&) {
    // no TOML value: a string without quotes
  }
  return text;
}

TextLines::TextLines(std::string_view text) : text_(text), begins_{0} {
  for (std::size_t end = 0; (end = text.find('\n', end)) != text.npos;)
    begins_.push_back(static_cast<std::uint32_t>(++end));
}

std::string_view TextLines::operator[](int number) const noexcept {
  const auto index = static_cast<std::size_t>(number) - 1;
  if (number < 1 || index >= begins_.size()) return {};
  std::string_view line = text_.substr(begins_[index]);
  if (index + 1 < begins_.size()) line = line.substr(0, begins_[index + 1] - begins_[index] - 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace softcnc::hal
