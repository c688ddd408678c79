// SPDX-License-Identifier: MIT
#include "ipr/dialects/sender_lines.hpp"

#include <algorithm>
#include <array>

#include "ipr/text/number.hpp"

namespace softcnc::ipr {
namespace {

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

std::string upper(std::string_view text) {
  std::string all(text);
  for (char& c : all)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return all;
}

/// `$10=3`, `$N0=G54`
bool assigns_setting(std::string_view setting) noexcept {
  const std::size_t equal = setting.find('=');
  if (equal == setting.npos || equal == 0) return false;
  std::string_view number = setting.substr(0, equal);
  if (number.front() == 'N') number.remove_prefix(1);
  return !number.empty() && std::all_of(number.begin(), number.end(), is_digit);
}

bool is_command(std::string_view command) {
  constexpr std::array<std::string_view, 13> kCommands{"",  "$", "#",  "G",  "I",  "N",  "C",
                                                       "X", "H", "HX", "HY", "HZ", "SLP"};
  const std::string word = upper(trimmed(command));
  return std::find(kCommands.begin(), kCommands.end(), word) != kCommands.end() ||
         word.starts_with("J=") || word.starts_with("RST=") || assigns_setting(word);
}

}  // namespace

bool is_sender_line(std::string_view line) {
  const std::string_view text = trimmed(line);
  if (text.empty()) return false;
  if (text.front() == '$') return is_command(text.substr(1, text.find_first_of(";(") - 1));
  return text.find_first_not_of("?!~ \t") == text.npos;
}

std::size_t checksum_at(std::string_view line) noexcept {
  constexpr std::size_t kMostDigits = 3;
  const std::size_t end = line.find_last_not_of(" \t") + 1;  // 0: there is nothing
  std::size_t begin = end;
  while (begin > 0 && is_digit(line[begin - 1])) --begin;
  if (begin == 0 || begin == end || end - begin > kMostDigits || line[begin - 1] != '*')
    return std::string_view::npos;
  const std::size_t star = begin - 1;
  return line.substr(0, star).find_first_of("[#=(;*") == line.npos ? star : line.npos;
}

void SenderLines::note(SourcePos pos, std::string_view line) {
  if (lines_.empty()) {
    first_ = pos;
    text_ = line;
  }
  if (lines_.size() < kMostLines) lines_.emplace(pos.file, pos.line);
}

void SenderLines::report(Diagnostics& diagnostics) {
  if (lines_.empty()) return;
  const std::size_t more = lines_.size() - 1;
  std::string message = "what is meant for a sender of grbl is skipped";
  if (more > 0)
    message += ", here and on " + std::to_string(more) + (more == 1 ? " more line" : " more lines");
  lines_.clear();
  diagnostics.report(Code::SC1055, first_, std::move(message), text_);
}

}  // namespace softcnc::ipr
