// SPDX-License-Identifier: MIT
// The rule by which positions become counts.
#include "motion/pulses/counts.hpp"

#include <catch2/catch.hpp>

namespace softcnc {

TEST_CASE("positions round to the nearest count, halves away from zero", "[motion][counts]") {
  const Counts counts(0.0025);
  CHECK(counts(0) == 0);
  CHECK(counts(0.00124) == 0);
  CHECK(counts(0.00125) == 1);
  CHECK(counts(-0.00125) == -1);
  CHECK(counts(0.00375) == 2);  // 0.00375 / 0.0025 is just below 1.5 in doubles
  CHECK(counts(40.0) == 16000);
  CHECK(counts(-1000.0) == -400000);
}

TEST_CASE("noise below 1e-9 mm does not move a half", "[motion][counts]") {
  const Counts counts(0.0025);
  for (int i = -2000; i < 2000; ++i) {
    const double half = (i + 0.5) * 0.0025;
    const std::int64_t expected = i >= 0 ? i + 1 : i;
    REQUIRE(counts(half) == expected);
    REQUIRE(counts(half + 4e-10) == expected);
    REQUIRE(counts(half - 4e-10) == expected);
  }
}

TEST_CASE("every whole count is found again", "[motion][counts]") {
  for (const double blu : {0.0025, 0.001, 0.0001, 0.00125, 0.005 / 3}) {
    const Counts counts(blu);
    for (std::int64_t n = -300'000; n <= 300'000; n += 7)
      REQUIRE(counts(static_cast<double>(n) * blu) == n);
  }
}

}  // namespace softcnc
