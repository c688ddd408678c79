// SPDX-License-Identifier: MIT
// The error of staircases as the verifier measures it, against Table 3 of paper 003.
#include "motion/verification/staircase_error.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "motion/verification/verify.hpp"
#include "support/staircases.hpp"

using namespace softcnc;

namespace {

constexpr std::int64_t kRadius = 4000;  // BLU
constexpr double kBlu = 0.0025;         // mm

Machine mill(Method method) {
  Machine machine;
  machine.control.interpolation = method;
  for (Axis& axis : machine.axes) axis.blu = kBlu;
  return machine;
}

/// The quadrant of Table 3 in periods of `clocks` each, of which the verifier sees every clock.
Measured quadrant(Method method, std::size_t clocks) {
  const auto from = test::crossing(kRadius, 0), to = test::crossing(kRadius, 1);
  ArcPulses pulses(test::arc_about_origin(from, to, kRadius, std::acos(0.0)), pulse_method(method));
  const double r = kRadius * kBlu;
  const Path path = Arc::make({{r, 0, 0}, {0, r, 0}, {0, 0, 0}, Plane::xy, true, 0}).value();
  const PathStretch stretch{&path, 0};
  Verifier verifier(mill(method));
  Setpoint row;
  row.position = {r, 0, 0};
  verifier.sample(row, {&stretch, 1});
  std::vector<Step> steps(clocks);
  std::vector<TimedStep> timed;
  while (const std::size_t n = pulses.fill(steps)) {
    timed.clear();
    for (std::size_t i = 0; i < n; ++i) {
      timed.push_back({double(i + 1) / double(n), steps[i]});
      for (int axis = 0; axis < kAxes; ++axis) row.position[axis] += steps[i][axis] * kBlu;
    }
    ++row.period;
    row.pulses = timed;
    row.s = r * std::atan2(row.position[1], row.position[0]);
    verifier.sample(row, {&stretch, 1});
  }
  verifier.finish();
  return verifier.measured();
}

std::string six_digits(double mm) {
  std::string text = std::to_string(std::round(mm / kBlu * 1e6) / 1e6);
  return text;
}

}  // namespace

TEST_CASE("the verifier measures the errors of Table 3 of paper 003", "[verify][pulse][paper]") {
  struct Row {
    Method method;
    const char *mean, *max;
  };
  const auto [method, mean, max] = GENERATE(values<Row>({{Method::sam, "0.392587", "0.999875"},
                                                         {Method::m_sam, "0.302568", "0.999500"},
                                                         {Method::dsm, "0.225151", "0.496906"},
                                                         {Method::m_dsm, "0.225151", "0.496906"},
                                                         {Method::dda, "0.306079", "0.999500"}}));
  const std::size_t clocks = GENERATE(1U, 7U, 500U);
  const Measured measured = quadrant(method, clocks);
  CHECK(six_digits(measured.path_deviation_mean) == mean);
  CHECK(six_digits(measured.path_deviation) == max);
  CHECK(measured.chord_error == measured.path_deviation);
}

TEST_CASE("a place beside a joint is as far from the path as from its nearer side",
          "[verify][pulse]") {
  const Path first = Line({0, 0, 0}, {1, 0, 0}), second = Line({1, 0, 0}, {1, 1, 0});
  const std::vector<PathStretch> stretches{{&first, 0}, {&second, 1}};
  StaircaseError error(mill(Method::dsm));
  Setpoint before, now;
  before.position = {0.9975, 0.0025, 0};
  before.s = 0.9975;
  now.s = 1.005;
  const std::vector<TimedStep> pulses{{0.9, Step(0, 1)}, {1, Step(1, 1)}};  // both on the second
  now.pulses = pulses;
  error.period(before, now, stretches);
  CHECK(error.largest() < 1e-12);
  const std::vector<TimedStep> late{{0.9, Step(1, -1)}};  // (0.9975, 0): on the first one alone
  now.pulses = late;
  error.period(before, now, stretches);
  CHECK(error.largest() < 1e-12);
  CHECK(error.mean() < 1e-12);
}
