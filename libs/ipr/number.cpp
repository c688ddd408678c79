// SPDX-License-Identifier: MIT
// Decimal numbers: exact and fast for up to 15 digits, std::from_chars for longer ones.
#include "ipr/number.hpp"

#include <array>
#include <charconv>
#include <string>

namespace softcnc::ipr {
namespace {

constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                              1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                              1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kExact = std::uint64_t{1} << 53U;       // integers below are doubles
constexpr std::uint64_t kRoomForDigit = (UINT64_MAX - 9) / 10;  // one digit more fits below

struct Scan {
  std::uint64_t digits = 0;  // all digits as one integer, as long as they fit
  std::size_t decimals = 0, integer_digits = 0;
  bool overflow = false, any_digit = false, point = false, negative = false;

  void take_digit(char c) noexcept {
    any_digit = true;
    if (point)
      ++decimals;
    else if (digits != 0 || c != '0')
      ++integer_digits;
    if (digits > kRoomForDigit)
      overflow = true;
    else
      digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
  }
};

/// The slow way, for more digits than fit an integer. A value too small for a double is 0.
double from_text(std::string_view text) {
  std::string clean;
  for (const char c : text)
    if (!is_blank(c) && c != '+') clean += c;
  double value = 0;
  std::from_chars(clean.data(), clean.data() + clean.size(), value);
  return value;
}

/// Both operands are doubles exactly, so that one division rounds once (Clinger 1990).
double value_of(const Scan& scan, std::string_view text) {
  if (scan.overflow || scan.digits > kExact || scan.decimals >= kPowersOfTen.size())
    return from_text(text);
  const double magnitude = static_cast<double>(scan.digits) / kPowersOfTen[scan.decimals];
  return scan.negative ? -magnitude : magnitude;
}

/// Whether a number that seems to end here goes on, behind blanks or as what is none.
bool goes_on(std::string_view text, std::size_t i) noexcept {
  while (i < text.size() && is_blank(text[i])) ++i;
  return i < text.size() && is_number_part(text[i]);
}

/// A number as most are, of few digits in a row. False: it is another.
bool read_plain(std::string_view text, Number& number) noexcept {
  constexpr std::size_t kFew = 15;
  std::size_t i = !text.empty() && text[0] == '-' ? 1 : 0;
  const std::size_t begin = i;
  std::uint64_t digits = 0;
  for (; i < text.size() && is_digit(text[i]); ++i)
    digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
  const std::size_t point = i;
  if (point == begin || point - begin > kIntegerDigits) return false;
  if (i < text.size() && text[i] == '.')
    for (++i; i < text.size() && is_digit(text[i]); ++i)
      digits = digits * 10 + static_cast<std::uint64_t>(text[i] - '0');
  if (i - begin > kFew || goes_on(text, i)) return false;
  const std::size_t decimals = i > point ? i - point - 1 : 0;
  const double magnitude = static_cast<double>(digits) / kPowersOfTen[decimals];
  number.value = text[0] == '-' ? -magnitude : magnitude;
  number.length = i;
  return true;
}

}  // namespace

Number read_number(std::string_view text) {
  Number number;
  if (read_plain(text, number)) return number;
  Scan scan;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (is_blank(c)) continue;
    if (is_digit(c)) {
      scan.take_digit(c);
    } else if (c == '.') {
      if (scan.point) number.fault = NumberFault::two_points;
      scan.point = true;
    } else if (c == '-' || c == '+') {
      if (number.length > 0) number.fault = NumberFault::sign_inside;
      scan.negative = c == '-';
    } else {
      break;
    }
    number.length = i + 1;
  }
  if (number.fault != NumberFault::none) return number;
  if (!scan.any_digit) number.fault = NumberFault::no_digits;
  if (scan.integer_digits > kIntegerDigits) number.fault = NumberFault::too_large;
  if (number.fault == NumberFault::none)
    number.value = value_of(scan, text.substr(0, number.length));
  return number;
}

}  // namespace softcnc::ipr
