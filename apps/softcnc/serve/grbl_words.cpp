// SPDX-License-Identifier: MIT
#include "serve/grbl_words.hpp"

#include <algorithm>
#include <charconv>
#include <initializer_list>

namespace softcnc::app {
namespace {

std::string without_comments(std::string_view line) {
  std::string text;
  bool inside = false;
  for (const char c : line) {
    if (c == ';' && !inside) break;
    if (c == '(') inside = true;
    if (!inside && c != ' ' && c != '\t')
      text += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (c == ')') inside = false;
  }
  return text;
}

bool has(const std::vector<GrblWord>& words, char letter, std::initializer_list<double> numbers) {
  return std::any_of(words.begin(), words.end(), [&](const GrblWord& word) {
    return word.letter == letter &&
           std::find(numbers.begin(), numbers.end(), word.number) != numbers.end();
  });
}

}  // namespace

std::vector<GrblWord> grbl_words(std::string_view line) {
  const std::string text = without_comments(line);
  std::vector<GrblWord> words;
  for (const char *at = text.data(), *end = at + text.size(); at < end;) {
    const char letter = *at++;
    if (letter < 'A' || letter > 'Z') continue;
    double number = 0;
    if (at < end && *at == '+') ++at;
    const auto [after, error] = std::from_chars(at, end, number, std::chars_format::fixed);
    if (error != std::errc()) continue;
    words.push_back({letter, number});
    at = after;
  }
  return words;
}

bool is_blank(std::string_view line) {
  const std::string text = without_comments(line);
  return text.empty() || text == "%";
}

bool probes(const std::vector<GrblWord>& words) {
  return has(words, 'G', {38.2, 38.3, 38.4, 38.5});
}

bool ends_program(const std::vector<GrblWord>& words) { return has(words, 'M', {2, 30}); }

bool sets_offset(const std::vector<GrblWord>& words) {
  return has(words, 'G', {10, 43.1, 49, 54, 55, 56, 57, 58, 59, 92, 92.1, 92.2});
}

bool waits_for_motion(const std::vector<GrblWord>& words) {
  return has(words, 'M', {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 30}) || probes(words) ||
         sets_offset(words) || has(words, 'G', {4, 28.1, 30.1}) ||
         std::any_of(words.begin(), words.end(),
                     [](const GrblWord& word) { return word.letter == 'S'; });
}

}  // namespace softcnc::app
