// SPDX-License-Identifier: MIT
// The only file that knows toml++ and catches its exceptions.
#include "hal/toml_reader.hpp"

#include <toml++/toml.h>

#include <algorithm>

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

SourcePos place(std::string_view text, const toml::source_region& region) {
  const int line = static_cast<int>(region.begin.line);
  const std::string content = text_line(text, line);
  const int first = byte_column(content, region.begin.column);
  const bool one_line = region.end.line == region.begin.line;
  const int end = one_line ? byte_column(content, region.end.column) : first + 1;
  return {line, first, std::max(1, end - first)};
}

/// Numbers, or else just an array.
FileValue value_of(const toml::array& array) {
  std::vector<double> numbers;
  for (const auto& element : array) {
    const auto number = element.value<double>();
    if (!number || !element.is_number()) return OtherValue{"an array"};
    numbers.push_back(*number);
  }
  return numbers;
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
      return OtherValue{"true or false"};
    case toml::node_type::array:
      return value_of(*node.as_array());
    case toml::node_type::table:
      return OtherValue{"a table"};
    default:
      return OtherValue{"a date or time"};
  }
}

void flatten(std::string_view text, const toml::table& table, const std::string& path,
             std::vector<TomlEntry>& entries) {
  for (const auto& [key, node] : table) {
    const std::string name = path + std::string(key.str());
    entries.push_back({name, node.is_table(), value_of(node), place(text, key.source()),
                       place(text, node.source())});
    if (const auto* inner = node.as_table()) flatten(text, *inner, name + '.', entries);
  }
}

/// The key at a place of the text, in quotes.
std::string key_at(std::string_view text, const SourcePos& pos) {
  const std::string line = text_line(text, pos.line);
  const auto begin = std::min(line.size(), static_cast<std::size_t>(pos.column) - 1);
  const auto end = line.find_first_of(" \t.=]", begin);
  return "'" + line.substr(begin, end - begin) + "'";
}

/// What toml++ says in quotes, or what stands there.
std::string key_of(std::string_view says, std::string_view text, const SourcePos& pos) {
  const auto quote = says.find('\'');
  return quote == says.npos ? key_at(text, pos) : std::string(says.substr(quote));
}

/// toml++ tells a key given twice only in words: "... cannot redefine existing integer 'blu_um'",
/// or "... existing integer as dotted key-value pair".
Diagnostic diagnostic_of(std::string_view text, const toml::parse_error& error) {
  constexpr std::string_view kPrefix = "Error while parsing ";
  std::string_view says = error.description();
  const SourcePos pos = place(text, error.source());
  if (says.find("cannot redefine") != says.npos)
    return {Code::SC7012, pos, key_of(says, text, pos) + " is given twice", {}, {}};
  if (says.starts_with(kPrefix)) says.remove_prefix(kPrefix.size());
  return {Code::SC7002, pos, "not TOML: " + std::string(says), {}, {}};
}

}  // namespace

Result<std::vector<TomlEntry>> read_toml(std::string_view text) {
  try {
    std::vector<TomlEntry> entries;
    flatten(text, toml::parse(text), "", entries);
    return entries;
  } catch (const toml::parse_error& error) {
    return tl::make_unexpected(diagnostic_of(text, error));
  }
}

FileValue read_toml_value(const std::string& text) {
  try {
    const toml::table table = toml::parse("value = " + text);
    if (table.size() == 1) return value_of(table.begin()->second);
  } catch (const toml::parse_error&) {
    // no TOML value: a string without quotes
  }
  return text;
}

std::string text_line(std::string_view text, int line) {
  for (int i = 1; i < line; ++i) {
    const auto end = text.find('\n');
    if (end == text.npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return std::string(text);
}

}  // namespace softcnc::hal
