// SPDX-License-Identifier: MIT
// Whole ns from step to step, against exact arithmetic in whole numbers.
#include "motion/model/step_rate.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace softcnc;

namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

StepPort port(double rate, double length_ns = 20, double space_ns = 20) {
  StepPort port;
  port.max_rate = rate;
  port.step_length = length_ns * 1e-9;
  port.step_space = space_ns * 1e-9;
  return port;
}

}  // namespace

TEST_CASE("steps in whole ns are never closer than the largest rate", "[motion][pulse]") {
  CHECK(step_interval(port(300e3)) == 3334);
  CHECK(step_interval(port(7e6)) == 143);
  CHECK(step_interval(port(333'333)) == 3001);
  CHECK(step_interval(port(1)) == kNsPerSecond);
  std::mt19937 random(7);
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t hertz = 1 + static_cast<std::int64_t>(random() % 10'000'000);
    const std::int64_t interval = step_interval(port(static_cast<double>(hertz)));
    REQUIRE(interval * hertz >= kNsPerSecond);
    REQUIRE((interval - 1) * hertz < kNsPerSecond);
  }
}

TEST_CASE("a rate of whole ns loses nothing", "[motion][pulse]") {
  for (std::int64_t hertz = 1; hertz <= 10'000'000; ++hertz) {
    if (kNsPerSecond % hertz != 0) continue;
    const auto rate = static_cast<double>(hertz);
    CHECK(step_interval(port(rate)) == kNsPerSecond / hertz);
    CHECK(step_rate(port(rate)) == rate);
  }
}

TEST_CASE("times of a driver are never shortened by rounding", "[motion][pulse]") {
  CHECK(least_ns(0) == 0);
  CHECK(least_ns(2500.4e-9) == 2501);
  CHECK(least_ns(0.3e-9) == 1);
  for (std::int64_t ns = 1; ns <= 100'000'000; ns += 997)
    REQUIRE(least_ns(s_from_ns(static_cast<double>(ns))) == ns);
}

TEST_CASE("a step has its length and its space at any rate", "[motion][pulse]") {
  CHECK(step_interval(port(200e3, 2500, 2500)) == 5000);
  CHECK(step_interval(port(1e9 / 5000.8, 2500.4, 2500.4)) == 5002);
}
