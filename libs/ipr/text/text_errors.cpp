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
  unsigned point = byte & (0xFFU >> (character.size() + 1));
  for (const char c : character.substr(1))
    point = (point << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  std::snprintf(text.data(), text.size(), " (U+%04X)", point);
  return in_quotes(character) + text.data();
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
