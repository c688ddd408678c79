// SPDX-License-Identifier: MIT
#include "ipr/faults.hpp"

#include <array>
#include <cstdio>

namespace softcnc::ipr {
namespace {

constexpr int kLongestShown = 24;  // bytes of a bad word repeated in a message

}  // namespace

std::string quoted(std::string_view text) {
  return "'" + std::string(text.substr(0, kLongestShown)) + "'";
}

std::string character_name(std::string_view character) {
  const auto byte = static_cast<unsigned char>(character.front());
  std::array<char, 16> text{};
  if (character.size() == 1) {
    if (byte > 0x20U && byte < 0x7FU) return quoted(character);
    std::snprintf(text.data(), text.size(), "byte 0x%02X", byte);
    return text.data();
  }
  unsigned point = byte & (0xFFU >> (character.size() + 1));
  for (const char c : character.substr(1))
    point = (point << 6U) | (static_cast<unsigned char>(c) & 0x3FU);
  std::snprintf(text.data(), text.size(), " (U+%04X)", point);
  return quoted(character) + text.data();
}

bool looks_like_utf16(std::string_view first_line) {
  if (first_line.starts_with("\xFF\xFE") || first_line.starts_with("\xFE\xFF")) return true;
  return first_line.size() > 1 && (first_line[0] == '\0') != (first_line[1] == '\0');
}

TextFault number_fault(NumberFault fault, std::string_view written, std::string_view behind) {
  switch (fault) {
    case NumberFault::no_digits:
      return {Code::SC1002, "no number after " + std::string(behind) + ", only " + quoted(written)};
    case NumberFault::sign_inside:
      return {Code::SC1003, "a sign inside the number " + quoted(written)};
    case NumberFault::two_points:
      return {Code::SC1004, "two decimal points in " + quoted(written)};
    default:
      return {Code::SC1005, quoted(written) + " has more than " + std::to_string(kIntegerDigits) +
                                " digits before the decimal point"};
  }
}

}  // namespace softcnc::ipr
