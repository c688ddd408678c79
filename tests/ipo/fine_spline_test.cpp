// SPDX-License-Identifier: MIT
// The spline between setpoints against what a spline promises.
#include "ipo/queue/fine_spline.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace softcnc;

namespace {

constexpr std::size_t kPartsOfPeriod = 100;

/// The points through setpoints at places of x; `v` is their planned speed, 0 at rest. The next one
/// is expected where it comes, and `astray` mm from there.
std::vector<double> through(const std::vector<double>& places, const std::vector<double>& v,
                            double astray = 0) {
  ipo::FineSpline spline(kPartsOfPeriod);
  std::vector<double> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::vector<FinePoint> points(kPartsOfPeriod);
    Setpoint setpoint;
    setpoint.position = {places[i], -2 * places[i], 1};
    setpoint.s = places[i] + 5;
    setpoint.v = v[i];
    const double next = places[std::min(i + 1, places.size() - 1)] + astray;
    spline.add(setpoint, {next + 5, {next, -2 * next, 1}}, points);
    if (i == 0) continue;
    for (const FinePoint& point : points) {
      CHECK(point.position[1] == Approx(-2 * point.position[0]).margin(1e-12));
      CHECK(point.position[2] == Approx(1));
      CHECK(point.s == Approx(point.position[0] + 5));
      all.push_back(point.position[0]);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("the spline passes its setpoints, and neither speed nor acceleration jumps there",
          "[ipo][fine]") {
  const std::vector<double> places{0, 0.3, 1.1, 1.7, 3.2, 3.0, 3.9, 4};
  const auto x = through(places, {0, 1, 1, 1, 1, 1, 1, 0}, GENERATE(0.0, 0.5));
  for (std::size_t i = 1; i < places.size(); ++i)
    CHECK(x[i * kPartsOfPeriod - 1] == Approx(places[i]).margin(1e-12));
  double steepest = 0;  // third differences stay of the order of the step: no jump of the second
  for (std::size_t i = 3; i < x.size(); ++i)
    steepest = std::max(steepest, std::abs(x[i] - 3 * x[i - 1] + 3 * x[i - 2] - x[i - 3]));
  CHECK(steepest < 500 * std::pow(1.0 / kPartsOfPeriod, 3));
}

TEST_CASE("an even acceleration comes out as it is", "[ipo][fine]") {
  std::vector<double> places, v;
  for (int i = 0; i < 8; ++i) {
    places.push_back(0.5 * i * i + 0.1 * i);
    v.push_back(1);
  }
  const auto x = through(places, v);
  for (std::size_t i = kPartsOfPeriod; i < x.size() - kPartsOfPeriod; ++i) {
    const double t = static_cast<double>(i + 1) / kPartsOfPeriod;
    REQUIRE(x[i] == Approx(0.5 * t * t + 0.1 * t));
  }
}

TEST_CASE("between setpoints at rest nothing moves", "[ipo][fine]") {
  const auto x = through({0, 1, 2, 2, 2, 3}, {0, 1, 0, 0, 0, 1});
  for (std::size_t i = 2 * kPartsOfPeriod; i < 4 * kPartsOfPeriod; ++i) REQUIRE(x[i] == Approx(2));
  for (std::size_t i = 4 * kPartsOfPeriod; i < x.size(); ++i) REQUIRE(x[i] >= 2 - 1e-12);
}
