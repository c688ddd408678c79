// SPDX-License-Identifier: MIT
// The step rules of the literature against their closed forms on a circle, which a NURBS of degree
// 2 draws exactly but not evenly.
#include "ipo/methods/step_rule.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>

#include "ipo/methods/method_table.hpp"
#include "ipo/methods/parameter_walk.hpp"
#include "support/curves.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::ipo;

namespace {

constexpr double kRadiusOfDeg2 = 10;  // mm: of circle_deg2, about the origin

double angle_of(const AxisVector& point) { return std::atan2(point[1], point[0]); }

/// A walk on the circle that has gone `s` mm, by the arc length, to a place where |P'| changes.
ParameterWalk walk_at(const Nurbs& circle, Method method, double s, double tolerance = 1e-3) {
  ParameterWalk walk(circle, method, tolerance);
  for (int i = 0; i < 3; ++i) walk.step(s / 3);
  return walk;
}

Machine free_machine(Method method, double period) {
  Machine machine;
  machine.limits.feed = 0;
  machine.control.interpolation = method;
  machine.control.period = period;
  for (Axis& axis : machine.axes) {
    axis.velocity = 1e6;
    axis.acceleration = 1e9;
  }
  return machine;
}

std::string page(const std::string& name) {
  std::ifstream file(std::string(SOFTCNC_SOURCE_DIR) + "/docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("every method has a row, and its row in docs/methods.md", "[methods]") {
  const std::string text = page("methods.md");
  REQUIRE(method_table().size() == kMethodNames.size());
  for (std::size_t i = 0; i < kMethodNames.size(); ++i) {
    const MethodEntry& row = method_table()[i];
    CAPTURE(kMethodNames[i]);
    CHECK(row.method == static_cast<Method>(i));
    CHECK_FALSE(row.source.empty());
    const auto begin = text.find("| `" + std::string(kMethodNames[i]) + "` | ");
    REQUIRE(begin != std::string::npos);
    const std::string line = text.substr(begin, text.find('\n', begin) - begin);
    CHECK(line.find("| " + std::string(row.source) + " |") != std::string::npos);
    CHECK(line.ends_with(row.ignores.empty() ? "| nothing |"
                                             : "| " + std::string(row.ignores) + " |"));
    const bool walks = !follows_time(row.method) && !ignores_plan(row.method);
    CHECK((row.rule.increment != nullptr) == walks);
    CHECK((row.rule.longest != nullptr) == limits_chord(row.method));
  }
}

TEST_CASE("a step of Runge and Kutta has an error of order five", "[methods]") {
  const Nurbs circle = test::curve("circle_deg2");
  const auto error = [&](double ds) {
    ParameterWalk walk = walk_at(circle, Method::rk4, 5);
    const double before = angle_of(walk.position());
    walk.step(ds);
    return std::abs(kRadiusOfDeg2 * (angle_of(walk.position()) - before) - ds);
  };
  // 4.36e-8 mm for a step of 1 mm, computed independently.
  CHECK(error(1) == Approx(4.36e-8).epsilon(0.01));
  CHECK(error(1) / error(0.5) == Approx(32).epsilon(0.05));
}

TEST_CASE("the feed hardly fluctuates with Runge and Kutta", "[methods]") {
  // Computed independently on the butterfly: 0.002 % at a scheduled feed and 1 ms.
  Machine machine;
  machine.limits.feed = 0;
  machine.control.interpolation = Method::rk4;
  const auto result = test::run(
      machine, test::number_blocks({Move{test::curve("butterfly"), false, 100, PathMode::follow}}));
  CHECK(result.measured.feed_fluctuation > 1e-7);
  CHECK(result.measured.feed_fluctuation < 1e-4);
  CHECK(result.rows.back().position == AxisVector(54.492, 52.139, 0));
}

TEST_CASE("the compensation of Yeh and Hsu makes the chord as long as the feed asks", "[methods]") {
  const Nurbs circle = test::curve("circle_deg2");
  const auto chord_error = [&](Method method, double ds) {
    ParameterWalk walk = walk_at(circle, method, 1);
    const AxisVector before = walk.position();
    walk.step(ds);
    return std::abs((walk.position() - before).norm() - ds);
  };
  CHECK(chord_error(Method::yeh_hsu_1999, 0.1) < 1e-8);
  CHECK(chord_error(Method::taylor1, 0.1) > 1e-5);
  // What the linear equation for the compensation leaves is of order four, not two.
  CHECK(chord_error(Method::yeh_hsu_1999, 1) / chord_error(Method::yeh_hsu_1999, 0.5) ==
        Approx(16).epsilon(0.3));
  CHECK(chord_error(Method::taylor1, 1) / chord_error(Method::taylor1, 0.5) ==
        Approx(4).epsilon(0.3));
}

TEST_CASE("equal chords of Yeh and Hsu turn by equal angles on a circle", "[methods]") {
  // 2 asin(V T / 2 R) a period, so the arc is longer than the chord by (V T)^2 / 24 R^2.
  const double feed = 250, period = 4e-3, chord = feed * period;
  Machine machine = free_machine(Method::yeh_hsu_1999, period);
  machine.control.chord_tolerance = 1;
  const auto result = test::run(
      machine,
      test::number_blocks({Move{test::curve("circle_deg2"), false, feed, PathMode::follow}}));
  for (std::size_t i = 10; i < 50; ++i) {
    const double turn = angle_of(result.rows[i].position) - angle_of(result.rows[i - 1].position);
    REQUIRE(std::remainder(turn, 2 * M_PI) ==
            Approx(2 * std::asin(chord / (2 * kRadiusOfDeg2))).epsilon(2e-5));
  }
}

TEST_CASE("the adaptive feed of Yeh and Hsu keeps the chord tolerance on a circle", "[methods]") {
  // The radius is the same everywhere, so the speed is (2 / T) sqrt(rho^2 - (rho - eps)^2).
  const double period = 8e-3, tolerance = 1e-4;
  Machine machine = free_machine(Method::yeh_hsu_2002, period);
  machine.control.chord_tolerance = tolerance;
  const auto blocks = [](double feed) {
    return test::number_blocks({Move{test::curve("circle_deg2"), false, feed, PathMode::follow}});
  };
  const double inner = kRadiusOfDeg2 - tolerance;
  const double longest = 2 * std::sqrt(kRadiusOfDeg2 * kRadiusOfDeg2 - inner * inner);
  const auto limited = test::run(machine, blocks(1000));
  CHECK(limited.measured.chord_error == Approx(tolerance).epsilon(0.005));
  CHECK(static_cast<double>(limited.rows.size()) ==
        Approx(2 * M_PI * kRadiusOfDeg2 / longest).margin(3));
  // Where the asked speed is smaller, it counts.
  const double feed = 0.5 * longest / period;
  const auto asked = test::run(machine, blocks(feed));
  CHECK(asked.measured.chord_error == Approx(tolerance / 4).epsilon(0.01));
  CHECK(asked.rows[40].s - asked.rows[39].s == Approx(feed * period).epsilon(1e-3));
}

TEST_CASE("in a part of a period a method takes that part of its longest step", "[methods]") {
  const Nurbs circle = test::curve("circle_deg2");
  WalkPlace place{&circle, 0, 0, {circle.point(0), {}, {}}, 1, 1e-3};
  const double whole[] = {three_point_longest(place), yeh_hsu_2002_longest(place)};
  CHECK(whole[0] == Approx(std::sqrt(8e-3 * kRadiusOfDeg2)).epsilon(1e-9));
  place.part = 0.25;
  CHECK(three_point_longest(place) == Approx(0.25 * whole[0]).epsilon(1e-12));
  CHECK(yeh_hsu_2002_longest(place) == Approx(0.25 * whole[1]).epsilon(1e-12));
  // A curve that begins within a period: what is left of it, then whole steps.
  const double period = 8e-3, left = GENERATE(0.125, 0.5, 1.0);
  Machine machine = free_machine(GENERATE(Method::curvature3p, Method::yeh_hsu_2002), period);
  machine.control.chord_tolerance = 1e-3;
  const auto result =
      test::run(machine, test::number_blocks({{Dwell{(2 - left) * period}},
                                              {Move{circle, false, 1000, PathMode::follow}}}));
  CAPTURE(name(machine.control.interpolation), left);
  CHECK(result.rows[1].s == 0);
  CHECK(result.rows[2].s == Approx(left * whole[0]).epsilon(0.01));
  CHECK(result.rows[3].s - result.rows[2].s == Approx(whole[0]).epsilon(0.06));
}

TEST_CASE("a radius below the tolerance leaves a step of two tolerances", "[methods]") {
  const Nurbs circle = test::curve("circle_deg2");
  const WalkPlace place{&circle, 0, 0, {circle.point(0), {}, {}}, 1, 2 * kRadiusOfDeg2};
  CHECK(curvature_at(place) == Approx(1 / kRadiusOfDeg2));
  CHECK(yeh_hsu_2002_longest(place) == Approx(4 * kRadiusOfDeg2));
}
