// SPDX-License-Identifier: MIT
// Decimal numbers: value, length, errors.
#include "ipr/text/number.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <string>

namespace softcnc::ipr {

TEST_CASE("a number is read in every way it is written", "[ipr][number]") {
  CHECK(read_number("10").value == 10.0);
  CHECK(read_number("10.").value == 10.0);
  CHECK(read_number(".5").value == 0.5);
  CHECK(read_number("-.5").value == -0.5);
  CHECK(read_number("+007.250").value == 7.25);
  CHECK(read_number("0.1").value == 0.1);
  CHECK(read_number("999999999.999").value == 999999999.999);
}

TEST_CASE("blanks inside a number do not count, those after it are not part of it",
          "[ipr][number]") {
  const Number number = read_number("- 1 0 .\t5  Y3");
  CHECK(number.value == -10.5);
  CHECK(number.length == 9);
}

TEST_CASE("a number ends where something else begins", "[ipr][number]") {
  const Number number = read_number("12.5Y3");
  CHECK(number.value == 12.5);
  CHECK(number.length == 4);
}

TEST_CASE("whatever byte follows a number, near or far from the end of the text", "[ipr][number]") {
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte);
    if (is_number_part(c) || is_blank(c)) continue;
    CAPTURE(byte);
    for (const std::string digits : {"7", "1234567", "12345678", "123456789"})
      for (const std::string after : {"", "1", "99999999999"}) {
        const Number number = read_number("-" + digits + ".25" + c + after);
        CHECK(number.error == NumberError::none);
        CHECK(number.length == digits.size() + 4);
        CHECK(number.value == -(std::stod(digits) + 0.25));
      }
  }
}

TEST_CASE("every error of a number has its name", "[ipr][number]") {
  CHECK(read_number("-").error == NumberError::no_digits);
  CHECK(read_number(".").error == NumberError::no_digits);
  CHECK(read_number("--1").error == NumberError::sign_inside);
  CHECK(read_number("1-2").error == NumberError::sign_inside);
  CHECK(read_number("1.2.3").error == NumberError::two_points);
  CHECK(read_number("..").error == NumberError::two_points);
  CHECK(read_number("1234567890").error == NumberError::too_large);
  CHECK(read_number("0000000000001").error == NumberError::none);
}

TEST_CASE("a number with an error is passed over whole", "[ipr][number]") {
  CHECK(read_number("1.2.3Y").length == 5);
  CHECK(read_number("--1 X").length == 3);
}

TEST_CASE("numbers agree with strtod to the last bit", "[ipr][number]") {
  std::mt19937_64 random(20240611);
  const auto digits = [&](int most) {
    std::string text;
    const auto count = static_cast<int>(random() % static_cast<unsigned>(most)) + 1;
    for (int i = 0; i < count; ++i) text += static_cast<char>('0' + random() % 10);
    return text;
  };
  for (int i = 0; i < 200000; ++i) {
    const std::string sign = random() % 2 == 0 ? "-" : "";
    const std::string text = sign + digits(9) + "." + digits(i % 10 == 0 ? 40 : 10);
    REQUIRE(read_number(text).error == NumberError::none);
    REQUIRE(read_number(text).value == std::strtod(text.c_str(), nullptr));
  }
}

TEST_CASE("a plain number is what it is with blanks inside", "[ipr][number]") {
  std::mt19937_64 random(20240612);
  int plain = 0;
  for (int i = 0; i < 100000; ++i) {
    std::string text, blanks;
    for (std::uint64_t left = random() % 18; left > 0; --left)
      text += "0123456789012345678901234.-"[random() % 27];
    for (const char c : text) (blanks += ' ') += c;
    double value = 0;
    const std::size_t length = read_plain_number(text, value);
    if (length == 0) continue;
    ++plain;
    REQUIRE(length == text.size());
    REQUIRE(read_number(blanks).error == NumberError::none);
    REQUIRE(value == read_number(blanks).value);
  }
  CHECK(plain > 10000);
}

TEST_CASE("a number too small for a double is zero", "[ipr][number]") {
  const std::string text = "0." + std::string(400, '0') + "1";
  CHECK(read_number(text).value == 0.0);
  CHECK(read_number(text).error == NumberError::none);
}

}  // namespace softcnc::ipr
