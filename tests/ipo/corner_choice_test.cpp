// SPDX-License-Identifier: MIT
#include "ipo/smoothing/corner_choice.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/machines.hpp"
#include "support/run.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using test::polyline;
using test::run;

namespace {

struct Setting {
  double acceleration, jerk, period;
};

Machine machine_of(const Setting& setting) {
  return test::usual_machine(setting.acceleration, setting.jerk, setting.period);
}

/// Two corners by `angle`, to the left and to the right.
std::vector<Block> corners(double angle, double feed, double tolerance) {
  const AxisVector turned(10 + 10 * std::cos(angle), 10 * std::sin(angle), 0);
  auto blocks = polyline({{0, 0, 0}, {10, 0, 0}, turned, turned + AxisVector(10, 0, 0)}, feed);
  for (Block& block : blocks) {
    std::get<Move>(block.what).corner_tolerance = tolerance;
    std::get<Move>(block.what).chord_tolerance = tolerance;
  }
  return blocks;
}

}  // namespace

TEST_CASE("rounding corners never takes longer than resting in them", "[corner_choice][property]") {
  const Setting settings[]{{1000, 0, 1e-3},     {5000, 0, 1e-3},      {1000, 0, 4e-3},
                           {5000, 0, 4e-3},     {1000, 50'000, 1e-3}, {2000, 20'000, 1e-3},
                           {3000, 60'000, 1e-3}};
  int rounded = 0, rests = 0;
  for (const Setting& setting : settings)
    for (const double degrees : {20.0, 45.0, 90.0, 120.0, 140.0})
      for (const double feed : {10.0, 50.0, 100.0}) {
        if (test::kSanitized && feed != 50) continue;
        const Machine machine = machine_of(setting);
        const double angle = degrees * std::numbers::pi / 180;
        const double exactly = run(machine, corners(angle, feed, 0)).time;
        for (const double tolerance : {0.001, 0.005, 0.01, 0.05}) {
          CAPTURE(setting.acceleration, setting.jerk, setting.period, degrees, feed, tolerance);
          const auto result = run(machine, corners(angle, feed, tolerance));
          CHECK(result.time <= exactly * 1.001);
          CHECK(test::exceeded(machine, result) == "");
          ++(result.deviation.off > 0.5 * tolerance ? rounded : rests);
        }
      }
  CHECK(rounded > (rounded + rests) / 3);
  CHECK(rests > (rounded + rests) / 9);
}

TEST_CASE("a corner that is passed at the feed is rounded, however little a rest would cost",
          "[corner_choice]") {
  const Machine machine = machine_of({1000, 0, 1e-3});
  const auto result = run(machine, corners(0.05, 2, 0.01));
  CHECK(result.deviation.off == Approx(0.01).epsilon(0.05));
  CHECK(result.time_by_limit.at(Limit::feed) > 0.999 * (result.time - 0.01));
}

TEST_CASE("what makes a curve slower makes a rest the better choice", "[corner_choice]") {
  const auto is_rounded = [](const Machine& machine) {  // 90 degrees within 10 um
    return run(machine, corners(0.5 * std::numbers::pi, 100, 0.01)).deviation.off > 0.005;
  };
  Machine machine = machine_of({1000, 0, 1e-3});
  CHECK(is_rounded(machine));
  machine.control.period = 4e-3;
  CHECK_FALSE(is_rounded(machine));
  machine = machine_of({10000, 0, 1e-3});  // the chord holds, not the axes
  CHECK_FALSE(is_rounded(machine));
  machine.control.chord_tolerance = 0.01;
  CHECK(is_rounded(machine));
}
