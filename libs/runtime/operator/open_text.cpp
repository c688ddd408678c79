// SPDX-License-Identifier: MIT
#include "runtime/operator/open_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

namespace softcnc::runtime {
namespace {

/// A line in lower case without blanks, comments and line number.
std::string bare(std::string_view line) {
  std::string text;
  int depth = 0;
  for (const char c : line) {
    if (c == ';' && depth == 0) break;
    if (c == '(') ++depth;
    const bool counts = depth == 0 && c != ' ' && c != '\t' && c != '\r' && c != '\n';
    if (counts) text += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (c == ')' && depth > 0) --depth;
  }
  if (text.empty() || text.front() != 'n') return text;
  const std::size_t end = text.find_first_not_of("0123456789", 1);
  return end == std::string::npos ? "" : text.substr(end);
}

/// The length of "o100" or "o<name>" at the beginning; 0 if there is none.
std::size_t label_length(std::string_view text) {
  if (text.size() < 2 || text.front() != 'o') return 0;
  if (text[1] == '<') {
    const std::size_t end = text.find('>');
    return end == std::string_view::npos ? 0 : end + 1;
  }
  const std::size_t end = std::min(text.find_first_not_of("0123456789", 1), text.size());
  return end > 1 ? end : 0;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::any_of(words.begin(), words.end(),
                     [word](std::string_view one) { return word.starts_with(one); });
}

/// The number behind the last `word` of a line of WHILE, DO and END; empty if there is none.
std::string number_after(std::string_view text, std::string_view word) {
  const std::size_t at = text.rfind(word);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = text.substr(at + word.size());
  return std::string(rest.substr(0, rest.find_first_not_of("0123456789")));
}

}  // namespace

void OpenText::close(const std::string& label) {
  if (!open_.empty() && open_.back().label == label) open_.pop_back();
}

/// O words of LinuxCNC, and WHILE, DO and END of FANUC's macros.
void OpenText::take(std::string_view line) {
  const std::string text = bare(line);
  if (const std::size_t length = label_length(text); length > 0) {
    const std::string label = text.substr(0, length);
    const std::string_view word = std::string_view(text).substr(length);
    const bool ends_do = word.starts_with("while") && !open_.empty() && open_.back().is_do &&
                         open_.back().label == label;
    if (is_one_of(word, {"end"}) || ends_do)
      close(label);
    else if (is_one_of(word, {"sub", "while", "do", "if", "repeat"}))
      open_.push_back({label, word.starts_with("do")});
    return;
  }
  const bool is_loop = text.starts_with("while") || text.starts_with("do");
  if (const std::string number = number_after(text, "do"); is_loop && !number.empty())
    open_.push_back({number});
  else if (text.starts_with("end"))
    close(number_after(text, "end"));
}

std::string OpenText::add(std::string_view line) {
  text_ += line;
  if (line.empty() || line.back() != '\n') text_ += '\n';
  while (!line.empty()) {
    const std::size_t end = std::min(line.find('\n'), line.size());
    take(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return open_.empty() ? std::exchange(text_, {}) : std::string();
}

void OpenText::forget() {
  text_.clear();
  open_.clear();
}

}  // namespace softcnc::runtime
