// SPDX-License-Identifier: MIT
// Numbers as text: however they are written, the characters are those of std::to_chars.
#include "hal/files/number.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using softcnc::hal::kNumberLength;
using softcnc::hal::number_text;

namespace {

std::string searched(double value) {
  char text[kNumberLength];
  return {text, std::to_chars(text, text + kNumberLength, value).ptr};
}

/// Numbers among the first `count` of 10^-decimals times whole ones that are written otherwise.
int differing(int decimals, int count, std::mt19937_64& random) {
  std::uniform_int_distribution<std::int64_t> whole(-20'000'000'000, 20'000'000'000);
  int differ = 0;
  for (int i = 1; i <= count; ++i) {
    const double small = i / std::pow(10, decimals);
    const double any = static_cast<double>(whole(random)) / std::pow(10, decimals);
    if (number_text(small) != searched(small) || number_text(any) != searched(any)) ++differ;
  }
  return differ;
}

}  // namespace

TEST_CASE("short decimals are written as a search for their digits writes them", "[hal]") {
  std::mt19937_64 random(274);
  for (int decimals = 0; decimals < 10; ++decimals) {
    CAPTURE(decimals);
    CHECK(differing(decimals, 100000, random) == 0);
  }
}

TEST_CASE("numbers with more digits, and those at the edges, read back exactly", "[hal]") {
  const double edges[] = {
      0.001,  0.0009999999, 99999.999999,           99999.9999999,          1e5, 123456, 1e300,
      5e-324, 0.1 + 0.2,    std::nextafter(0.5, 1), std::nextafter(12.5, 0)};
  for (const double value : edges) {
    CHECK(number_text(value) == searched(value));
    CHECK(number_text(-value) == "-" + searched(value));
  }
  std::mt19937_64 random(275);
  std::uniform_real_distribution<double> any(-1000, 1000);
  for (int i = 0; i < 100000; ++i) {
    const double value = any(random);
    REQUIRE(number_text(value) == searched(value));
  }
  CHECK(number_text(-0.0) == "0");
}
