// SPDX-License-Identifier: MIT
#include "ipr/expressions/definition.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::size_t kMostNameDigits = 9;

/// Without blanks, and in lower case.
std::string plain(std::string_view text) {
  std::string name;
  for (const char c : text)
    if (c != ' ' && c != '\t') name += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

/// What stands in #<...>, or after '#', or alone.
std::string bare(std::string name) {
  if (!name.starts_with('#')) return name;
  name.erase(0, 1);
  if (name.starts_with('<') && name.ends_with('>')) return name.substr(1, name.size() - 2);
  return name;
}

bool is_name(std::string_view name) {
  if (name.starts_with('_'))
    return name.size() > 1 && name.find_first_of("<>#()") == std::string_view::npos;
  return !name.empty() && name.size() <= kMostNameDigits && name.front() != '0' &&
         std::all_of(name.begin(), name.end(), is_digit);
}

std::optional<double> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  const bool whole = read.ec == std::errc() && read.ptr == end && std::isfinite(value);
  return whole && !text.empty() ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<Definition> parse_definition(std::string_view text) {
  const auto equals = text.rfind('=');
  if (equals == std::string_view::npos) return std::nullopt;
  std::string name = bare(plain(text.substr(0, equals)));
  const auto value = number_of(plain(text.substr(equals + 1)));
  if (!is_name(name) || !value) return std::nullopt;
  return Definition{std::move(name), *value};
}

std::string shown_name(const Definition& definition) {
  return definition.name.starts_with('_') ? "#<" + definition.name + ">" : "#" + definition.name;
}

}  // namespace softcnc::ipr
