// SPDX-License-Identifier: MIT
#include "ipr/text/text_errors.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "motion/core/utf8.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::size_t kLongestWordShown = 24;  // bytes of a bad word repeated in a message
constexpr std::string_view kUtf16 = "UTF-16", kUtf32 = "UTF-32";
constexpr std::size_t kZerosOfUtf32 = 3;  // beside a character of ASCII

/// How many zero bytes stand there in a row.
std::size_t zeros_at(std::string_view text, std::size_t place) {
  const std::size_t end = std::min(text.find_first_not_of('\0', place), text.size());
  return end - std::min(place, end);
}

/// The number of a character beyond ASCII, of its bytes in UTF-8.
unsigned code_point(std::string_view character) noexcept {
  unsigned point =
      static_cast<unsigned char>(character.front()) & (0xFFU >> (character.size() + 1));
  for (const char c : character.substr(1))
    point = (point << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  return point;
}

struct LookAlike {
  char32_t character;
  char ascii;
};

/// Dashes, then capital letters of Greek and of Cyrillic (Unicode's list of confusable characters).
constexpr std::array kLookAlikes = std::to_array<LookAlike>(
    {{U'\u2010', '-'}, {U'\u2011', '-'}, {U'\u2012', '-'}, {U'\u2013', '-'}, {U'\u2014', '-'},
     {U'\u2212', '-'}, {U'\u0391', 'A'}, {U'\u0392', 'B'}, {U'\u0395', 'E'}, {U'\u0396', 'Z'},
     {U'\u0397', 'H'}, {U'\u0399', 'I'}, {U'\u039A', 'K'}, {U'\u039C', 'M'}, {U'\u039D', 'N'},
     {U'\u039F', 'O'}, {U'\u03A1', 'P'}, {U'\u03A4', 'T'}, {U'\u03A5', 'Y'}, {U'\u03A7', 'X'},
     {U'\u0405', 'S'}, {U'\u0406', 'I'}, {U'\u0408', 'J'}, {U'\u0410', 'A'}, {U'\u0412', 'B'},
     {U'\u0415', 'E'}, {U'\u041A', 'K'}, {U'\u041C', 'M'}, {U'\u041D', 'H'}, {U'\u041E', 'O'},
     {U'\u0420', 'P'}, {U'\u0421', 'C'}, {U'\u0422', 'T'}, {U'\u0423', 'Y'}, {U'\u0425', 'X'}});
/// The ASCII characters in the width of East Asian ones follow one another.
constexpr unsigned kFirstWide = 0xFF01, kLastWide = 0xFF5E, kFirstAscii = 0x21;

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
  if (text.size() <= most) return std::string(text);
  while (most > 0 && continues_character(text[most])) --most;
  return std::string(text.substr(0, most)) + "...";
}

std::string in_quotes(std::string_view text) {
  return "'" + shortened(text, kLongestWordShown) + "'";
}

std::string character_name(std::string_view character) {
  const auto byte = static_cast<unsigned char>(character.front());
  std::array<char, 16> text{};
  if (character.size() == 1) {
    if (byte > 0x20U && byte < 0x7FU) return in_quotes(character);
    std::snprintf(text.data(), text.size(), "byte 0x%02X", byte);
    return text.data();
  }
  std::snprintf(text.data(), text.size(), " (U+%04X)", code_point(character));
  return in_quotes(character) + text.data();
}

char look_alike(std::string_view character) noexcept {
  if (character.size() < 2) return 0;
  const unsigned point = code_point(character);
  if (point >= kFirstWide && point <= kLastWide)
    return static_cast<char>(point - kFirstWide + kFirstAscii);
  const auto* const found = std::find_if(kLookAlikes.begin(), kLookAlikes.end(),
                                         [&](const LookAlike& l) { return l.character == point; });
  return found == kLookAlikes.end() ? '\0' : found->ascii;
}

std::string_view wide_encoding(std::string_view first_line) {
  const std::string_view utf32_mark("\0\0\xFE\xFF", 4);
  if (first_line.starts_with(utf32_mark)) return kUtf32;
  if (first_line.starts_with("\xFF\xFE") || first_line.starts_with("\xFE\xFF"))
    return zeros_at(first_line, 2) >= 2 ? kUtf32 : kUtf16;
  if (first_line.size() < 2 || (first_line[0] == '\0') == (first_line[1] == '\0')) return {};
  return zeros_at(first_line, 1) == kZerosOfUtf32 ? kUtf32 : kUtf16;
}

std::string_view wide_encoding_at(std::string_view text, std::size_t nul) {
  const std::size_t zeros = zeros_at(text, nul);
  if (zeros_at(text, nul + zeros + 1) == 0) return {};
  return zeros == 1 ? kUtf16 : zeros == kZerosOfUtf32 ? kUtf32 : std::string_view{};
}

TextError wide_error(std::string_view encoding) {
  return {Code::SC1013, "the file is in " + std::string(encoding) + "; save it as UTF-8 or ASCII"};
}

TextError number_error(NumberError error, std::string_view written, std::string_view after) {
  switch (error) {
    case NumberError::no_digits:
      return {Code::SC1002,
              "no number after " + std::string(after) + ", only " + in_quotes(written)};
    case NumberError::sign_inside:
      return {Code::SC1003, "a sign inside the number " + in_quotes(written)};
    case NumberError::two_points:
      return {Code::SC1004, "two decimal points in " + in_quotes(written)};
    default:
      return {Code::SC1005, in_quotes(written) + " has more than " +
                                std::to_string(kIntegerDigits) +
                                " digits before the decimal point"};
  }
}

}  // namespace softcnc::ipr
