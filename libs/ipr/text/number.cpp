// SPDX-License-Identifier: MIT
// Decimal numbers of any form: exact and fast as long as their digits fit an integer, otherwise by
// std::from_chars.
#include "ipr/text/number.hpp"

#include <array>

#include <charconv>
#include <string>

namespace softcnc::ipr {
namespace {

constexpr std::uint64_t kExact = std::uint64_t{1} << 53U;          // integers below are doubles
constexpr std::uint64_t kMostBeforeDigit = (UINT64_MAX - 9) / 10;  // one digit more fits below

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
    if (digits > kMostBeforeDigit)
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

}  // namespace

Number read_number(std::string_view text) {
  Number number;
  if ((number.length = read_plain_number(text, number.value)) > 0) return number;
  Scan scan;
  std::size_t i = 0;
  for (; i < text.size(); ++i) {
    const char c = text[i];
    if (is_blank(c)) continue;
    if (is_digit(c)) {
      scan.take_digit(c);
    } else if (c == '.') {
      if (scan.point) number.error = NumberError::two_points;
      scan.point = true;
    } else if (c == '-' || c == '+') {
      if (number.length > 0) number.error = NumberError::sign_inside;
      scan.negative = c == '-';
    } else {
      break;
    }
    number.length = i + 1;
  }
  if (number.error != NumberError::none) return number;
  if (!scan.any_digit) number.error = NumberError::no_digits;
  if (scan.integer_digits > kIntegerDigits) number.error = NumberError::too_large;
  if (number.error == NumberError::none)
    number.value = value_of(scan, text.substr(0, number.length));
  return number;
}

std::string number_text(double value) {
  std::array<char, 400> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 3);
  std::string number(text.data(), end);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return number == "-0" ? "0" : number;
}

}  // namespace softcnc::ipr
