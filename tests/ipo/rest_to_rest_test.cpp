// SPDX-License-Identifier: MIT
#include "ipo/path/rest_to_rest.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/property.hpp"

namespace softcnc::ipo {
namespace {

/// s, from rest to rest: the trapezoidal and triangular profiles of acceleration (L. Biagiotti and
/// C. Melchiorri, Trajectory Planning for Automatic Machines and Robots, 2008, section 3.4).
double least_time(double way, const LineLimits& most) {
  const auto [v, a, j] = most;
  const double ramp = v * j >= a * a ? v / a + a / j : 2 * std::sqrt(v / j);
  if (way >= v * ramp) return way / v + ramp;
  if (way >= 2 * a * a * a / (j * j)) return a / j + std::sqrt(a * a / (j * j) + 4 * way / a);
  return 4 * std::cbrt(way / (2 * j));
}

double duration(const std::vector<Ramp>& ramps) {
  double sum = 0;
  for (const Ramp& ramp : ramps) sum += ramp.duration;
  return sum;
}

/// Whether it is a motion of limited jerk without a gap, found by integrating a constant jerk over
/// each ramp.
void check_motion(const std::vector<Ramp>& ramps, double s0, double s1, const LineLimits& most) {
  constexpr double kOver = 1 + 2e-4;
  Instant at{s0, 0, 0, 0};
  for (const Ramp& ramp : ramps) {
    const double t = ramp.duration;
    RC_ASSERT(t > 0);
    at.j = (ramp.a1 - ramp.a0) / t;
    RC_ASSERT(std::abs(at.j) <= most.j * kOver);
    at.s += t * (at.v + t * (at.a / 2 + t * at.j / 6));
    at.v += t * (at.a + t * at.j / 2);
    at.a += t * at.j;
    RC_ASSERT(std::abs(at.s - ramp.s1) <= 1e-9 * (1 + std::abs(s1)));
    RC_ASSERT(std::abs(at.v - ramp.v1) <= 1e-9 * (1 + most.v));
    RC_ASSERT(std::abs(at.a - ramp.a1) <= 1e-9 * (1 + most.a));
    RC_ASSERT(at.v <= most.v * kOver);
    RC_ASSERT(std::abs(at.a) <= most.a * kOver);
    at.s = ramp.s1;
  }
  RC_ASSERT(ramps.back().s1 == s1);
  RC_ASSERT(ramps.back().v1 == 0);
  RC_ASSERT(ramps.back().a1 == 0);
}

LineLimits random_limits() {
  return {std::pow(10, test::real(-1, 3)), std::pow(10, test::real(1, 4.5)),
          std::pow(10, test::real(3, 6.5))};
}

}  // namespace

TEST_CASE("from rest to rest: any way, in the least time", "[rest_to_rest]") {
  test::holds(
      [] {
        const LineLimits most = random_limits();
        const double s0 = test::real(0, 100), way = std::pow(10, test::real(-4, 3));
        const auto ramps = rest_to_rest(s0, s0 + way, most, Limit::feed);
        RC_ASSERT(std::abs(duration(ramps) / least_time(way, most) - 1) < 1e-4);
        check_motion(ramps, s0, s0 + way, most);
      },
      2000);
}

TEST_CASE("from rest to rest: the beginning and the end alone, joined where it cruises",
          "[rest_to_rest]") {
  test::holds(
      [] {
        const LineLimits most = random_limits();
        const double s0 = test::real(0, 100), ramp = distance_to_cruise(most);
        const double way = (2 + test::real(0.1, 3)) * ramp;
        const double between = s0 + test::real(1, way / ramp - 1) * ramp;
        RC_PRE(between - s0 >= ramp && s0 + way - between >= ramp);
        auto ramps = rest_to_cruise(s0, between, most, Limit::feed);
        RC_ASSERT(ramps.back().s1 == Approx(between));
        ramps.back().s1 = between;
        const auto end = cruise_to_rest(between, s0 + way, most, Limit::feed);
        RC_ASSERT(end.front().v0 == ramps.back().v1);
        ramps.insert(ramps.end(), end.begin(), end.end());
        RC_ASSERT(std::abs(duration(ramps) / least_time(way, most) - 1) < 1e-4);
        check_motion(ramps, s0, s0 + way, most);
      },
      2000);
}

TEST_CASE("from rest to rest: where one kind of motion goes over into the next", "[rest_to_rest]") {
  test::holds([] {
    const LineLimits most{100, 1000, test::real(10'500, 50'000)};  // so that 1000 is held
    const double to_cruise = most.v * (most.v / most.a + most.a / most.j);
    const double to_hold = 2 * std::pow(most.a, 3) / (most.j * most.j);
    for (const double way : {to_cruise, to_hold})
      for (const double off : {0.0, 1e-13, 1e-10, 1e-7, 1e-5})
        for (const double sign : {-1.0, 1.0}) {
          const double there = way * (1 + sign * off);
          const auto ramps = rest_to_rest(0, there, most, Limit::feed);
          RC_ASSERT(std::abs(duration(ramps) / least_time(there, most) - 1) < 1e-5);
          check_motion(ramps, 0, there, most);
        }
    // A speed at which the acceleration is just reached.
    const double knee = most.a * most.a / most.j;
    for (const double off : {-1e-6, -1e-12, 0.0, 1e-12, 1e-9, 1e-6}) {
      const LineLimits slow{knee * (1 + off), most.a, most.j};
      check_motion(rest_to_rest(0, 50, slow, Limit::feed), 0, 50, slow);
    }
  });
}

TEST_CASE("from rest to rest: what holds back, and how fast it is on the way", "[rest_to_rest]") {
  const LineLimits most{100, 1000, 50'000};
  const auto ramps = rest_to_rest(5, 65, most, Limit::rapid);
  REQUIRE(ramps.size() == 7);
  CHECK(ramps[0].limit == Limit::jerk);
  CHECK(ramps[1].limit == Limit::acceleration);
  CHECK(ramps[3].limit == Limit::rapid);
  CHECK(ramps[3].v0 == 100);
  CHECK(duration(ramps) == Approx(0.6 + 0.1 + 0.02));
  CHECK(speed_at(ramps, 5) == Approx(0).margin(1e-6));
  CHECK(speed_at(ramps, 65) == Approx(0).margin(1e-6));
  CHECK(speed_at(ramps, 35) == Approx(100));
  // v = j t^2 / 2 at s = j t^3 / 6, and the same before the end.
  const double t = 0.013;
  CHECK(speed_at(ramps, 5 + 50'000 * t * t * t / 6) == Approx(50'000 * t * t / 2));
  CHECK(speed_at(ramps, 65 - 50'000 * t * t * t / 6) == Approx(50'000 * t * t / 2));
}

}  // namespace softcnc::ipo
