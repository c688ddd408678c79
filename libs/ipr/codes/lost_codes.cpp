// SPDX-License-Identifier: MIT
#include "ipr/codes/lost_codes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "ipr/text/lexer.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kTenths = 10;
constexpr int kG04 = 40, kG09 = 90;  // as GCode::number: they leave nothing in force

/// The digit that a character is, or looks like; -1: none.
constexpr int digit_of(char c) noexcept {
  if (is_digit(c)) return c - '0';
  if (c == 'O' || c == 'o') return 0;
  return c == 'l' || c == 'I' ? 1 : -1;
}

/// Behind a G: its digits up to the next blank or letter, whatever else stands among them.
std::optional<int> number_meant(std::string_view behind) noexcept {
  constexpr int kLargest = 1000;
  std::optional<int> number;
  bool behind_blank = false;
  for (const char c : behind) {
    const int digit = digit_of(c);
    if (is_letter(c) && (digit < 0 || behind_blank)) break;
    if ((number && is_blank(c)) || number.value_or(0) > kLargest) break;
    behind_blank = is_blank(c);
    if (digit >= 0) number = 10 * number.value_or(0) + digit;
  }
  return number;
}

/// Whether a point stands among the digits, so that those of G6..1 are not 61 alone.
bool points_stand_in(std::string_view behind) noexcept {
  const auto end = std::find_if(behind.begin(), behind.end(),
                                [](char c) { return is_letter(c) || is_blank(c); });
  return std::find(behind.begin(), end, '.') != end;
}

bool begins_word(std::span<const Word> words, std::size_t at) noexcept {
  const int column = static_cast<int>(at) + 1;
  return std::any_of(words.begin(), words.end(),
                     [&](const Word& word) { return word.pos.column == column; });
}

/// A letter of a longer name, like that of GOTO or GT. One letter behind it may stand for a digit.
bool is_of_name(std::string_view text, std::size_t at) noexcept {
  if (at > 0 && is_letter(text[at - 1])) return true;
  const auto is_letter_at = [&](std::size_t i) {
    return i < text.size() && is_letter(text[i]) && digit_of(text[i]) < 0;
  };
  const bool in_brackets = text.substr(0, at).find('[') != std::string_view::npos;
  return is_letter_at(at + 1) && (in_brackets || is_letter_at(at + 2));
}

/// `1i`: a letter that stands for a digit, since no value follows it.
bool ends_in_letter(std::string_view behind) noexcept {
  const auto at = behind.find_first_not_of("0123456789.");
  if (at == 0 || at == std::string_view::npos || !is_letter(behind[at]) ||
      digit_of(behind[at]) >= 0)
    return false;
  const std::string_view rest = behind.substr(at + 1);
  const auto next = rest.find_first_not_of(" \t");
  return next == std::string_view::npos ||
         std::string_view("0123456789.+-#[").find(rest[next]) == std::string_view::npos;
}

/// Behind the comment that begins at `at`; npos if it has no end.
std::size_t behind_comment(std::string_view text, std::size_t at) noexcept {
  const std::size_t close = text[at] == '(' ? text.find(')', at) : std::string_view::npos;
  return close == std::string_view::npos ? close : close + 1;
}

/// Behind the name that begins at `at` with its '<'.
std::size_t behind_name(std::string_view text, std::size_t at) noexcept {
  const std::size_t close = text.find('>', at);
  return close == std::string_view::npos ? at + 1 : close + 1;
}

/// Codes that are not supported, and would turn, scale, mirror or bend coordinates: lathe
/// diameters, polar and cylindrical coordinates, G16, G51, G68.
bool changes_coordinates(double number) noexcept {
  constexpr std::array<double, 7> kCodes{7, 12, 16, 51, 68, 107, 112};
  return std::find(kCodes.begin(), kCodes.end(), std::floor(number)) != kCodes.end();
}

/// The G or M codes on a line that are no words of it: what stands behind the letter of each.
template <typename Function>
void for_each_lost(const Line& line, char letter, Function function) {
  for (std::size_t at = 0; at < line.text.size();) {
    const char c = line.text[at];
    if (c == '(' || c == ';') {
      at = behind_comment(line.text, at);
      continue;
    }
    if (c == '<') {
      at = behind_name(line.text, at);
      continue;
    }
    const bool code = upper_case(c) == letter && !is_of_name(line.text, at) &&
                      !begins_word(line.words, at) && !begins_word(line.doubtful, at);
    ++at;
    if (code) function(line.text.substr(at));
  }
}

/// `G(8`: another character stands in the place of the first digit.
bool begins_strangely(std::string_view behind) noexcept {
  constexpr std::string_view kOfNumbers{" \t.+-#["};
  return !behind.empty() && !is_digit(behind[0]) && !is_letter(behind[0]) &&
         kOfNumbers.find(behind[0]) == std::string_view::npos;
}

/// `*18`: what stands behind another character in the place of the first letter.
std::string_view behind_stranger(std::string_view text) noexcept {
  constexpr std::string_view kOther{"/%(;#[<.+-\""};
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos || first + 1 >= text.size()) return {};
  const char c = text[first];
  const bool strange = !is_digit(c) && !is_letter(c) && kOther.find(c) == std::string_view::npos;
  return strange && is_digit(text[first + 1]) ? text.substr(first + 1) : std::string_view{};
}

/// `1G9`: of G19 and G91, whose digits stand around the letter.
Groups groups_of_both(double one, double other) noexcept {
  Groups groups;
  for (const double number : {one * 10 + other, other * 10 + one})
    if (find_gcode('G', number) != nullptr) groups |= groups_of_code(number);
  return groups;
}

}  // namespace

bool is_end(double number) noexcept {
  constexpr double kM02 = 2, kM30 = 30;
  return number == kM02 || number == kM30;
}

Groups groups_of_code(double number) noexcept {
  constexpr int kLeast = 200;  // of codes that there are on no control
  const GCode* code = find_gcode('G', number);
  if (code == nullptr && number < 1) code = find_gcode('G', std::round(number * 100));  // G.91
  if (code == nullptr && number >= kLeast)
    return {Group::motion, Group::plane, Group::distance, Group::arc_distance};
  if (code == nullptr && changes_coordinates(number)) return {Group::motion, Group::work_offset};
  if (code == nullptr) code = find_gcode('G', std::floor(number));
  const bool rests = code != nullptr && (code->number == kG04 || code->number == kG09);
  if (rests) return {};
  Groups groups{code != nullptr ? code->group : Group::motion};
  const bool tenths = code != nullptr && find_gcode('G', number) == nullptr;
  if (tenths && find_gcode('G', std::fmod(number, kTenths)) != nullptr)
    groups |= {Group::motion};  // `G95.2`, for G5.2
  return groups;
}

Groups lost_groups(const Line& line) noexcept {
  Groups lost;
  for (const Word& word : line.doubtful)
    if (word.letter == 'G') lost |= groups_of_code(word.value);
  if (line.lone_number && find_gcode('G', *line.lone_number) != nullptr)
    lost |= groups_of_code(*line.lone_number);
  if (const auto number = number_meant(behind_stranger(line.text));
      number && find_gcode('G', *number) != nullptr)
    lost |= groups_of_code(*number);
  for_each_lost(line, 'G', [&](std::string_view behind) {
    const auto number = number_meant(behind);
    const bool known = !begins_strangely(behind) && number && find_gcode('G', *number) != nullptr &&
                       !ends_in_letter(behind);
    lost |= known ? groups_of_code(*number) : kModesOfG;
    if (line.lone_number && number) lost |= groups_of_both(*line.lone_number, *number);
    const bool tenths = known && points_stand_in(behind);
    if (tenths && find_gcode('G', *number / kTenths) != nullptr)
      lost |= groups_of_code(*number / kTenths);
  });
  return lost;
}

bool means_end(const Line& line) noexcept {
  int lost = 0, ends = 0;
  for_each_lost(line, 'M', [&](std::string_view behind) {
    const auto number = number_meant(behind);
    ++lost;
    ends += number && is_end(*number) ? 1 : 0;
  });
  return lost == 1 && ends == 1;
}

bool may_save_modes(const Line& line) noexcept {
  constexpr int kM73 = 73;
  bool may = false;
  for (const Word& word : line.doubtful) may = may || (word.letter == 'M' && word.value == kM73);
  for_each_lost(line, 'M', [&](std::string_view behind) {
    const auto number = number_meant(behind);
    may = may || !number || *number == kM73 || find_gcode('M', *number) == nullptr;
  });
  return may;
}

}  // namespace softcnc::ipr
