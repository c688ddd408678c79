// SPDX-License-Identifier: MIT
// Jerk-limited plans from outside: limits in every sample, times against closed forms and against
// the independent optimum.
#include "ipo/jerk_limited/jerk_window.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "support/curves.hpp"
#include "support/machines.hpp"
#include "support/run.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {}  // namespace

TEST_CASE("a line from rest to rest takes the time of its seven phases", "[ipo][jerk]") {
  // L / v + v / a + a / j, all three limits being reached.
  const auto result = run(machine_with(250, 1000, 50000), polyline({{0, 0, 0}, {100, 0, 0}}, 100));
  CHECK(result.time == Approx(1.0 + 0.1 + 0.02).epsilon(1e-3));
  CHECK(exceeded(machine_with(250, 1000, 50000), result) == "");
  CHECK(result.rows.back().position == AxisVector(100, 0, 0));
}

TEST_CASE("curves are as fast as the independent optimum but for two per cent, and keep all limits",
          "[ipo][jerk]") {
  struct Row {
    const char* curve;
    double velocity, acceleration, jerk, feed, optimum;
  };
  // Optimum: near-optimal times of an independent solver, refined until they stood.
  for (const Row& row : {Row{"butterfly", 250, 2000, 20000, 250, 4.549},
                         Row{"circle_deg2", 250, 1000, 50000, 100, 0.742}}) {
    CAPTURE(row.curve);
    const Machine machine = machine_with(row.velocity, row.acceleration, row.jerk);
    const auto result = run(machine, one_move(curve(row.curve), row.feed));
    CHECK(result.time < 1.02 * row.optimum);
    CHECK(result.time > 0.98 * row.optimum);
    CHECK(exceeded(machine, result) == "");
  }
}

TEST_CASE("a slow arc takes few nodes however short its stopping distances are", "[ipo][jerk]") {
  const AxisVector from(1, 0, 0), to(4, 3, 0), centre(1, 3, 0);
  const Machine machine = machine_with(250, 1000, 50000);
  for (const double feed : {0.05, 0.5, 5.0}) {
    CAPTURE(feed);
    const Path arc = *Arc::make({from, to, centre});
    const auto result = run(machine, one_move(arc, feed));
    CHECK(static_cast<double>(result.counts.effort.nodes) < 600 * result.time + 200);
    CHECK(result.counts.effort.fallbacks == 0);
    CHECK(result.time == Approx(length(arc) / feed).epsilon(1e-3).margin(0.1));
    CHECK(exceeded(machine, result) == "");
  }
}

TEST_CASE("corners rounded by micrometres, and tips, do not hold a plan up", "[ipo][jerk]") {
  Machine machine = machine_with(250, 900, 18000);
  machine.control.period = 0.004;
  machine.control.chord_tolerance = 0.005;
  machine.limits.normal = GENERATE(0.0, 30.0);
  machine.axes[1].acceleration = 300;
  machine.axes[1].jerk = 15000;
  machine.axes[2].acceleration = 60;
  machine.axes[2].jerk = 3000;
  const std::vector<AxisVector> corner{
      {111.65, -77.83, 3.6}, {146.87, 36.88, 3.6}, {89.52, 54.54, -14.4}};
  const std::vector<AxisVector> tip{
      {-88.06, 101.27, -29.5}, {-92.26, 96.97, -27.7}, {-88.5, 100.8, -29.5}};
  for (const auto& points : {corner, tip}) {
    auto blocks = polyline(points, 100);
    for (Block& block : blocks) std::get<Move>(block.what).corner_tolerance = 0.005;
    const auto result = run(machine, blocks);
    CHECK(result.counts.effort.fallbacks == 0);
    CHECK(result.counts.nodes < 1000);
    CHECK(result.counts.effort.iterations < 400);
    CHECK(exceeded(machine, result) == "");
  }
}

TEST_CASE("an axis that stands still, or is as fast as a row, asks for no nodes", "[ipo][jerk]") {
  const auto path = one_move(curve("butterfly"), 100);
  Machine machine = machine_with(250, 1000, 20000);
  const auto even = run(machine, path);
  machine.axes[2].jerk = 1e6;
  CHECK(run(machine, path).counts.effort.nodes == even.counts.effort.nodes);
  machine.axes[1].jerk = 0;
  const auto result = run(machine, path);
  CHECK(exceeded(machine, result) == "");
  CHECK(static_cast<double>(result.counts.effort.nodes) < 7000 * result.time);
}

TEST_CASE("chords run exactly take no longer where more jerk is allowed", "[ipo][jerk]") {
  std::vector<AxisVector> points{{0, 0, 0}};
  const auto rounded = [](double mm) { return std::round(1e3 * mm) / 1e3; };
  for (int i = 1; i < (kSanitized ? 40 : 150); ++i)
    points.emplace_back(rounded(50 * std::sin(0.008 * i)), rounded(50 - 50 * std::cos(0.008 * i)),
                        0);
  double least = 1e9;
  for (const double jerk : {2e5, 5e5, 1e6}) {
    CAPTURE(jerk);
    const Machine machine = machine_with(250, 1000, jerk);
    const auto result = run(machine, polyline(points, 50));
    CHECK(exceeded(machine, result) == "");
    CHECK(result.time < 1.05 * least);
    CHECK(result.counts.effort.fallbacks < 5);
    least = std::min(least, result.time);
  }
}

TEST_CASE("no plan that goes on from another one is faster than the feed", "[ipo][jerk]") {
  const auto result = run(machine_with(250, 1000, 20000), one_move(curve("infinity8"), 200));
  CHECK(result.counts.effort.fallbacks == 0);
  for (const Setpoint& row : result.rows) REQUIRE(row.v <= 200 * (1 + 1e-6));
}

TEST_CASE("where half a second ahead cannot be planned, a shorter way is", "[ipo][jerk]") {
  Machine machine = machine_with(250, 1000, 50000);
  machine.axes[1].jerk = 15000;
  machine.control.period = 0.008;
  ArcSpec spec{{0, 0, 0}, {-1.679246188, 1.080192886, 0}, {4.543326109, 8.908321271, 0}};
  spec.ccw = false;
  const auto result = run(machine, one_move(*Arc::make(spec), 1));
  CHECK(result.counts.effort.fallbacks == 0);
  CHECK(exceeded(machine, result) == "");
}

TEST_CASE("a limit of the jerk that no row can reach costs nothing", "[ipo][jerk]") {
  const auto path = one_move(curve("butterfly"), 100);
  const auto machine = [](double jerk) {
    Machine made = machine_with(250, 1000, jerk);
    made.control.period = made.control.servo_period = 0.004;
    return made;
  };
  const auto without = run(machine(0), path);
  for (const double jerk : {5e5, 1e9}) {  // 5e5 = 2 A / T
    CAPTURE(jerk);
    const auto result = run(machine(jerk), path);
    CHECK(result.time == without.time);
    CHECK(exceeded(machine(jerk), result) == "");
  }
  for (const double jerk : {2e5, 3e5, 4e5, 4.9e5}) {
    CAPTURE(jerk);
    const auto result = run(machine(jerk), path);
    CHECK(result.time < 1.03 * without.time);
    CHECK(exceeded(machine(jerk), result) == "");
  }
}

TEST_CASE("corners rest, and joints of line and arc jump in acceleration no more than allowed",
          "[ipo][jerk]") {
  const Machine machine = machine_with(250, 1000, 50000);
  const auto square = run(machine, polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, 100));
  CHECK(exceeded(machine, square) == "");
  const Arc arc = Arc::make({{50, 0, 0}, {60, 10, 0}, {50, 10, 0}, Plane::xy, true, 0}).value();
  const auto joined = run(
      machine, number_blocks({Move{Line({0, 0, 0}, {50, 0, 0}), false, 100, PathMode::follow},
                              Move{arc, false, 100, PathMode::follow},
                              Move{Line({60, 10, 0}, {60, 60, 0}), false, 100, PathMode::follow}}));
  CHECK(exceeded(machine, joined) == "");
  CHECK(joined.rows.back().position == AxisVector(60, 60, 0));
}

TEST_CASE("where line and arc meet askew of the axes, jump and jerk share the third difference",
          "[ipo][jerk]") {
  // What jumps and what drives along the path lie on the same axes.
  const double jerk = GENERATE(50000.0, 500000.0), turn = GENERATE(0.3, 0.8, 2.5, 4.0);
  CAPTURE(jerk, turn);
  const Machine machine = machine_with(250, 3000, jerk);
  const auto turned = [turn](double x, double y) {
    return AxisVector(x * std::cos(turn) - y * std::sin(turn),
                      x * std::sin(turn) + y * std::cos(turn), 0);
  };
  const AxisVector first = turned(0, 0), second = turned(8, 0), third = turned(8, 6);
  const Arc arc = Arc::make({second, third, turned(8, 3), Plane::xy, true, 0}).value();
  const auto result =
      run(machine, number_blocks({Move{Line(first, second), false, 250, PathMode::follow},
                                  Move{arc, false, 250, PathMode::follow},
                                  Move{Line(third, turned(0, 6)), false, 250, PathMode::follow}}));
  CHECK(exceeded(machine, result) == "");
  CHECK(result.counts.effort.fallbacks == 0);
  CHECK(result.counts.effort.iterations < 60);
  CHECK(result.rows.back().position.isApprox(turned(0, 6), 1e-12));
}

TEST_CASE("in its last moment on a tight arc an axis may not use more jerk than it has",
          "[ipo][jerk]") {
  // At rest the arc points along x except for 0.04; its curvature requires more of y than its
  // direction does.
  Machine machine = machine_with(250, 1000, 12000);
  machine.axes[0].jerk = 0;
  machine.axes[1].jerk = 3700;
  const double radius = 0.0075;
  const auto on_circle = [&](double angle) {
    return AxisVector(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  const Arc arc =
      Arc::make({on_circle(-0.386), on_circle(1.53), AxisVector::Zero(), Plane::xy, true, 0})
          .value();
  CHECK(exceeded(machine, run(machine, one_move(arc, 3.4))) == "");
}

TEST_CASE("a stop within a jerk-limited curve ends at rest on the path", "[ipo][jerk]") {
  const Machine machine = machine_with(250, 1000, 50000);
  for (const int after : {3, 700, 2000, 4000}) {
    CAPTURE(after);
    const auto stopped = run(machine, one_move(curve("butterfly"), 100), after);
    CHECK(exceeded(machine, stopped) == "");
    CHECK(stopped.rows.back().v == 0);
    CHECK(static_cast<int>(stopped.rows.size()) < after + 400);
  }
}

TEST_CASE("a jerk-limited plan does not depend on how the blocks arrive", "[ipo][jerk]") {
  const Machine machine = machine_with(250, 3000, 60000);
  std::vector<AxisVector> points{AxisVector::Zero()};
  for (int i = 1; i <= 60; ++i) points.emplace_back(0.5 * i, 5 * std::sin(0.1 * i), 0);
  const auto blocks = polyline(points, 100);
  const auto whole = run(machine, blocks, -1, 0);
  const auto pieces = run(machine, blocks, -1, 7);
  CHECK(exceeded(machine, whole) == "");
  REQUIRE(pieces.rows.size() == whole.rows.size());
  for (std::size_t i = 0; i < whole.rows.size(); ++i)
    REQUIRE(pieces.rows[i].position == whole.rows[i].position);
}

TEST_CASE("a long plan follows an axis without a limit of jerk every so many rows", "[ipo][jerk]") {
  Machine machine;
  machine.control.period = 2.5e-4;
  machine.axes[0].acceleration = 97;
  machine.axes[0].jerk = 258;
  machine.axes[1].acceleration = 64;
  const Arc arc = Arc::make({{0, 0, 0}, {20, 20, 0}, {0, 20, 0}, Plane::xy, true, 0}).value();
  const auto result = run(machine, one_move(arc, 15));
  CHECK(exceeded(machine, result) == "");
  CHECK(result.time < 2.5);  // 2.87 where a plan was found with four tenths of the jerk alone
  CHECK(result.rows.size() > 8000);  // of which each had a node, in each of the plans
  CHECK(result.counts.effort.nodes < 8000);
  CHECK(result.counts.effort.fallbacks == 0);
}
