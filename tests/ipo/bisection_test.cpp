// SPDX-License-Identifier: MIT
#include "ipo/solver/bisection.hpp"

#include <catch2/catch.hpp>
#include <set>

using namespace softcnc;

TEST_CASE("the first of many is found from any guess, and nothing is tried twice", "[ipo]") {
  for (int last = 0; last < 40; ++last)
    for (int first = 0; first <= last + 1; ++first)
      for (int guess = -1; guess <= last + 1; ++guess) {
        CAPTURE(last, first, guess);
        std::set<int> tried;
        const auto found = ipo::bisect(guess, last, [&](int k) {
          REQUIRE((k >= 0 && k <= last));
          REQUIRE(tried.insert(k).second);
          return k >= first;
        });
        REQUIRE(found.has_value() == (first <= last));
        if (found) REQUIRE(*found == first);
      }
}

TEST_CASE("a good guess takes two tries, and a bad one of a thousand a few dozen", "[ipo]") {
  int tries = 0;
  const auto holds = [&tries](int k) {
    ++tries;
    return k >= 500;
  };
  CHECK(ipo::bisect(500, 1000, holds) == 500);
  CHECK(tries == 2);
  tries = 0;
  CHECK(ipo::bisect(0, 1000, holds) == 500);
  CHECK(tries <= 40);
}
