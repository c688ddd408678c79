// SPDX-License-Identifier: MIT
// Constant feed by dropped clocks, against its closed form; acceleration by delays.
#include "motion/pulses/pulse_clock.hpp"

#include <catch2/catch.hpp>

#include "motion/pulses/pulse_line.hpp"
#include "support/staircases.hpp"

namespace softcnc {
namespace {

using std::numbers::pi;

/// BLU of the path per clock.
double speed(const GridPoint& way, PulseMethod method, bool constant_feed) {
  LinePulses pulses(way, method);
  ClockDropper dropper(method);
  double clocks = 0;
  test::for_each_step(pulses,
                      [&](Step step) { clocks += constant_feed ? dropper.clocks(step) : 1; });
  return std::hypot(static_cast<double>(way[0]), static_cast<double>(way[1])) / clocks;
}

double ratio(double slope, PulseMethod method, bool constant_feed) {
  constexpr std::int64_t kWay = 30000;
  return speed({kWay, std::llround(kWay * slope), 0}, method, constant_feed) /
         speed({kWay, 0, 0}, method, constant_feed);
}

/// Speeds along a quadrant of R = 4000 in bins of 10 degrees, against the first.
std::array<double, 9> ratios_over_arc(PulseMethod method, bool constant_feed) {
  constexpr std::int64_t kRadius = 4000;
  ArcPulses pulses(test::arc_about_origin({kRadius, 0}, {0, kRadius}, kRadius, pi / 2), method);
  ClockDropper dropper(method);
  std::array<double, 9> clocks{};
  GridPoint at{kRadius, 0, 0};
  test::for_each_step(pulses, [&](Step step) {
    advance(at, step);
    const double angle = std::atan2(static_cast<double>(at[1]), static_cast<double>(at[0]));
    const auto bin = std::min<std::size_t>(static_cast<std::size_t>(angle * 18 / pi), 8);
    clocks[bin] += constant_feed ? dropper.clocks(step) : 1;
  });
  std::array<double, 9> ratios{};
  for (std::size_t i = 0; i < 9; ++i) ratios[i] = clocks[0] / clocks[i];
  return ratios;
}

constexpr PulseMethod kDiagonal[] = {PulseMethod::m_sam, PulseMethod::dsm, PulseMethod::m_dsm};

}  // namespace

TEST_CASE("the feed over the slope of a line, with and without compensation",
          "[motion][pulse][paper]") {
  for (int degrees = 0; degrees <= 45; ++degrees) {
    CAPTURE(degrees);
    const double m = std::tan(degrees * pi / 180);
    const double length = std::sqrt(1 + m * m);
    for (const PulseMethod method : kDiagonal) {
      CHECK(ratio(m, method, false) == Approx(length).epsilon(0.001));
      CHECK(ratio(m, method, true) == Approx(length / (1 + m / 3)).epsilon(0.001));
    }
    CHECK(ratio(m, PulseMethod::sam, false) == Approx(length / (1 + m)).epsilon(0.001));
    CHECK(ratio(m, PulseMethod::sam, true) == Approx(length / (1 + m / 3)).epsilon(0.001));
    CHECK(ratio(m, PulseMethod::dda, false) == Approx(1).epsilon(0.001));
    CHECK(ratio(m, PulseMethod::dda, true) == Approx(1).epsilon(0.001));
  }
  CHECK(ratio(std::tan(18.4 * pi / 180), PulseMethod::m_dsm, true) == Approx(0.9487).margin(1e-4));
  CHECK(ratio(1, PulseMethod::sam, true) == Approx(1.0607).margin(1e-4));
}

TEST_CASE("the feed over an arc in bins of ten degrees", "[motion][pulse][paper]") {
  const auto extremes = [](PulseMethod method, bool constant_feed) {
    const auto ratios = ratios_over_arc(method, constant_feed);
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    return std::array{*least, *most};
  };
  for (const PulseMethod method : kDiagonal) {
    CAPTURE(name(method));
    CHECK(extremes(method, true)[0] == Approx(0.973).epsilon(0.01));
    CHECK(extremes(method, true)[1] == Approx(1.066).epsilon(0.01));
    // A clock for each BLU of the leading axis: the integral of the cosine over the bins.
    const double first = std::sin(pi / 18), middle = 2 * (std::sin(pi / 4) - std::sin(pi / 4.5));
    CHECK(extremes(method, false)[1] == Approx(first / middle).epsilon(0.001));
  }
  CHECK(extremes(PulseMethod::sam, true)[0] == Approx(0.973).epsilon(0.01));
  CHECK(extremes(PulseMethod::sam, true)[1] == Approx(1.066).epsilon(0.01));
  CHECK(extremes(PulseMethod::dda, true)[0] == Approx(1).epsilon(0.01));
  CHECK(extremes(PulseMethod::dda, false)[1] == Approx(1).epsilon(0.01));
}

TEST_CASE("a ramp of delays is a constant acceleration", "[motion][pulse]") {
  constexpr double kHz = 100'000;
  constexpr std::int64_t kClocks = 5000, kRamp = 1000;
  const ClockRamp ramp(kHz, kClocks, kRamp);
  // n clocks from rest at constant acceleration take 2 n / f.
  double time = 0;
  for (std::int64_t i = 0; i < kRamp; ++i) {
    CHECK(time == Approx(2 / kHz * std::sqrt(static_cast<double>(kRamp * i))).margin(1e-12));
    time += ramp.delay(i);
  }
  CHECK(time == Approx(2 * kRamp / kHz));
  CHECK(ramp.delay(kRamp) == 1 / kHz);
  CHECK(ramp.delay(kClocks / 2) == 1 / kHz);
  for (std::int64_t i = 0; i < kClocks; ++i) REQUIRE(ramp.delay(i) == ramp.delay(kClocks - 1 - i));
}

TEST_CASE("two ramps that meet share the clocks", "[motion][pulse]") {
  const ClockRamp ramp(1000, 100, 1000);
  for (std::int64_t i = 1; i < 50; ++i) CHECK(ramp.delay(i) < ramp.delay(i - 1));
  for (std::int64_t i = 51; i < 100; ++i) CHECK(ramp.delay(i) > ramp.delay(i - 1));
  CHECK(ramp.delay(49) > 1e-3);
}

}  // namespace softcnc
