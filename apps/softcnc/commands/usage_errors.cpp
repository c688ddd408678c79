// SPDX-License-Identifier: MIT
#include "commands/usage_errors.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace softcnc::app {
namespace {

/// '%' stands for any text, which "$1", "$2" ... repeat.
struct Phrase {
  std::string_view of_parser, own;
};

constexpr Phrase kPhrases[] = {
    {"%: At Most 1 required but received %", "$1: one is taken, and $2 are given"},
    {"%: At Most % required but received %", "$1: at most $2 are taken, and $3 are given"},
    {"%: At least % required but received %", "$1: $2 are needed, and $3 is given"},
    {"%: 1 required % missing", "$1 needs $2"},
    {"%: % required % missing", "$1 needs $2 of $3"},
    {"%: Value % not in range % to %", "$1: '$2' is not a number from $3 to $4"},
    {"Could not convert: % = %", "$1: '$2' is not a number"},
    {"% is required", "$1 is missing"},
    {"% excludes %", "$1 and $2 exclude each other"},
    {"% requires %", "$1 needs $2 beside it"},
    {"The following argument was not expected: %", "'$1' is one word too many"},
    {"The following arguments were not expected: %", "these words are too many: $1"},
    {"%: Directory does not exist: %", "$1: there is no folder '$2'"},
    {"%: Directory is actually a file: %", "$1: '$2' is a file, not a folder"},
};

/// Returns what stands for each '%'; nothing where the text is another one.
std::optional<std::vector<std::string_view>> parts_of(std::string_view text,
                                                      std::string_view pattern) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t mark = pattern.find('%');
    const std::string_view fixed = pattern.substr(0, mark);
    if (!text.starts_with(fixed)) return std::nullopt;
    text.remove_prefix(fixed.size());
    if (mark == std::string_view::npos) break;
    pattern.remove_prefix(mark + 1);
    const std::string_view next = pattern.substr(0, pattern.find('%'));
    const std::size_t end = next.empty() ? text.size() : text.find(next);
    if (end == std::string_view::npos) return std::nullopt;
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return text.empty() ? std::optional(std::move(parts)) : std::nullopt;
}

std::string filled(std::string_view own, const std::vector<std::string_view>& parts) {
  std::string text;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i] != '$')
      text += own[i];
    else
      text += parts[static_cast<std::size_t>(own[++i] - '1')];
  }
  return text;
}

}  // namespace

std::string usage_error(const std::string& of_parser) {
  for (const Phrase& phrase : kPhrases)
    if (const auto parts = parts_of(of_parser, phrase.of_parser)) return filled(phrase.own, *parts);
  return of_parser;
}

}  // namespace softcnc::app
