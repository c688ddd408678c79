// SPDX-License-Identifier: MIT
// A decimal number as part programs write it: no exponent, no locale, blanks allowed inside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace softcnc::ipr {

enum class NumberFault : std::uint8_t { none, no_digits, sign_inside, two_points, too_large };

struct Number {
  double value = 0;        // nearest to what is written; 0 if there is a fault
  std::size_t length = 0;  // bytes read, without blanks behind
  NumberFault fault = NumberFault::none;
};

inline constexpr int kIntegerDigits = 9;  // before the point; more is NumberFault::too_large

constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }
constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
constexpr bool is_number_part(char c) noexcept {
  return is_digit(c) || c == '.' || c == '-' || c == '+';
}

/// Reads everything at the beginning of `text` that looks like one number.
Number read_number(std::string_view text);

}  // namespace softcnc::ipr
