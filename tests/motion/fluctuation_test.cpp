// SPDX-License-Identifier: MIT
#include "motion/verification/fluctuation.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace softcnc;

namespace {

/// What a percentile may be too large by.
constexpr double kResolution = 1.0 / 256;

}  // namespace

TEST_CASE("a fluctuation is known by its largest, its mean square and its percentiles",
          "[verify]") {
  Fluctuation fluctuation;
  CHECK(fluctuation.largest() == 0);
  CHECK(fluctuation.rms() == 0);
  CHECK(fluctuation.percentile(0.99) == 0);
  constexpr int kPeriods = 1000;
  double squares = 0;
  for (int i = 1; i <= kPeriods; ++i) {
    const double off = (i % 2 == 0 ? 1e-6 : -1e-6) * i;
    fluctuation.add(off);
    squares += off * off;
  }
  CHECK(fluctuation.largest() == Approx(1e-3).epsilon(1e-12));
  CHECK(fluctuation.rms() == Approx(std::sqrt(squares / kPeriods)).epsilon(1e-12));
  for (const double part : {0.1, 0.5, 0.99}) {
    CHECK(fluctuation.percentile(part) >= part * 1e-3 * (1 - 1e-12));
    CHECK(fluctuation.percentile(part) <= part * 1e-3 * (1 + kResolution));
  }
  CHECK(fluctuation.percentile(1) == fluctuation.largest());
}

TEST_CASE("one period in a hundred does not count in the 99th percentile", "[verify]") {
  Fluctuation fluctuation;
  for (int i = 0; i < 99; ++i) fluctuation.add(0);
  fluctuation.add(1e6);
  CHECK(fluctuation.percentile(0.99) == 0);
  CHECK(fluctuation.percentile(1) == 1e6);
  fluctuation.add(0.25);
  CHECK(fluctuation.percentile(0.99) == Approx(0.25).epsilon(kResolution));
}
