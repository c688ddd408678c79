// SPDX-License-Identifier: MIT
// A decimal number as part programs write it: no exponent, no locale, blanks allowed inside.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace softcnc::ipr {

enum class NumberError : std::uint8_t { none, no_digits, sign_inside, two_points, too_large };

struct Number {
  double value = 0;        // nearest to what is written; 0 if there is an error
  std::size_t length = 0;  // bytes read, without blanks after
  NumberError error = NumberError::none;
};

/// How far from a whole number the number of a variable or a label may be.
inline constexpr double kWholeTolerance = 1e-4;

inline constexpr int kIntegerDigits = 9;  // before the point; more is NumberError::too_large

inline constexpr std::string_view kBlanks = " \t\v\f";
constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
constexpr std::string_view without_blanks_around(std::string_view text) noexcept {
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}
constexpr char upper_case(char c) noexcept {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr bool is_letter(char c) noexcept { return upper_case(c) >= 'A' && upper_case(c) <= 'Z'; }
constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
constexpr bool is_number_part(char c) noexcept {
  return is_digit(c) || c == '.' || c == '-' || c == '+';
}

inline constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Reads eight characters at once, the first one in the lowest byte.
struct EightCharacters {
  static constexpr bool kFits = std::endian::native == std::endian::little;
  static constexpr std::uint64_t kEach = 0x0101'0101'0101'0101;  // one in each byte

  std::uint64_t values;  // in each byte that of the digit, if it is one

  explicit EightCharacters(const char* at) noexcept {
    std::memcpy(&values, at, sizeof values);
    values ^= kEach * '0';
  }
  /// Returns how many digits precede the first character that is not one. A byte beyond 9, or with
  /// its highest bit set, is not a digit; a carry goes only to bytes after it.
  std::size_t digits() const noexcept {
    const std::uint64_t others = ((values + kEach * (0x7F - 9)) | values) & (kEach * 0x80);
    return static_cast<std::size_t>(std::countr_zero(others)) / 8;
  }
  /// Returns the number that the first `count` digits form: by pairs, by fours, by eights. Requires
  /// a `count` from 1 to 8.
  std::uint64_t number(std::size_t count) const noexcept {
    const std::uint64_t aligned = values << (64 - 8 * count);
    const std::uint64_t pairs = aligned * 10 + (aligned >> 8U);
    constexpr std::uint64_t kPairs = 0x0000'00FF'0000'00FF;
    constexpr std::uint64_t kFirst = 100 + (std::uint64_t{1'000'000} << 32U);
    constexpr std::uint64_t kSecond = 1 + (std::uint64_t{10'000} << 32U);
    return ((pairs & kPairs) * kFirst + ((pairs >> 16U) & kPairs) * kSecond) >> 32U;
  }
};

/// Appends the digits at `at` to the number `digits` and returns where they end. Digits that do not
/// fit into 64 bits are lost.
inline const char* pass_digits(const char* at, const char* end, std::uint64_t& digits) noexcept {
  constexpr std::array<std::uint64_t, 9> kTens{1,      10,      100,      1000,     10000,
                                               100000, 1000000, 10000000, 100000000};
  if (EightCharacters::kFits && end - at >= 8) {
    const EightCharacters eight(at);
    const std::size_t count = eight.digits();
    if (count == 0) return at;
    digits = digits * kTens[count] + eight.number(count);
    at += count;
    if (count < 8) return at;
  }
  for (; at != end && is_digit(*at); ++at)
    digits = digits * 10 + static_cast<unsigned char>(*at - '0');
  return at;
}

/// Returns whether a number that seems to end at `at` goes on, after blanks or with characters that
/// make it an error.
inline bool goes_on(const char* at, const char* end) noexcept {
  while (at != end && is_blank(*at)) ++at;
  return at != end && is_number_part(*at);
}

/// Reads a number as most are written, of at most 15 digits in a row, and returns its number of
/// bytes; 0 if it is written otherwise. Both operands are doubles exactly, so that one division
/// rounds once (Clinger 1990).
inline std::size_t read_plain_number(std::string_view text, double& value) noexcept {
  constexpr std::ptrdiff_t kFew = 15;
  const char* const end = text.data() + text.size();
  const bool negative = !text.empty() && text.front() == '-';
  const char* const first = text.data() + (negative ? 1 : 0);
  std::uint64_t digits = 0;
  const char* const point = pass_digits(first, end, digits);
  if (point == first || point - first > kIntegerDigits) return 0;
  const char* at = point;
  if (at != end && *at == '.') at = pass_digits(at + 1, end, digits);
  if (at - first > kFew || goes_on(at, end)) return 0;
  const auto decimals = static_cast<std::size_t>(std::max<std::ptrdiff_t>(at - point - 1, 0));
  const double magnitude = static_cast<double>(static_cast<std::int64_t>(digits));
  value = (negative ? -magnitude : magnitude) / kPowersOfTen[decimals];
  return static_cast<std::size_t>(at - text.data());
}

/// Reads everything at the beginning of `text` that looks like one number. Number::error says what
/// is wrong with it.
Number read_number(std::string_view text);

/// Returns a number for a message, with at most three decimals and no trailing zeros.
std::string number_text(double value);

}  // namespace softcnc::ipr
