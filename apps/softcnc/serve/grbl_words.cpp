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

GrblWords read_words(std::string_view text) {
  GrblWords read;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end;) {
    const char letter = *at++;
    const char* number_at = at < end && *at == '+' ? at + 1 : at;
    const bool begins = number_at < end && (*number_at == '-' || *number_at == '.' ||
                                            (*number_at >= '0' && *number_at <= '9'));
    double number = 0;
    const auto [after, error] = std::from_chars(number_at, end, number, std::chars_format::fixed);
    const bool is_word = letter >= 'A' && letter <= 'Z' && begins && error == std::errc();
    read.is_all = read.is_all && is_word;
    if (!is_word) continue;
    read.words.push_back({letter, number});
    at = after;
  }
  return read;
}

std::vector<GrblWord> grbl_words(std::string_view line) {
  return read_words(without_comments(line)).words;
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
