// SPDX-License-Identifier: MIT
#include "ipo/planner/planner.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "support/curves.hpp"
#include "support/machines.hpp"
#include "support/paths.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using test::arc;
using test::exceeded;
using test::number_blocks;
using test::one_move;
using test::polyline;
using test::random_program;
using test::run;

namespace {

Machine fast_machine(double acceleration, double period = 1e-3, double tolerance = 1e-3) {
  Machine machine = test::machine_with(1000, acceleration, 0);
  machine.control.period = period;
  machine.control.chord_tolerance = tolerance;
  return machine;
}

}  // namespace

TEST_CASE("a line from rest to rest takes the trapezoid's time", "[planner]") {
  const Machine machine = fast_machine(1000);
  // v / a + L / v, and 2 sqrt(L / a) where the feed is not reached.
  CHECK(run(machine, polyline({{0, 0, 0}, {100, 0, 0}}, 100)).time == Approx(1.1).epsilon(1e-12));
  CHECK(run(machine, polyline({{0, 0, 0}, {4, 0, 0}}, 100)).time ==
        Approx(2 * std::sqrt(4e-3)).epsilon(1e-12));
  // Diagonally both axes accelerate at their limit: sqrt(2) along the path.
  CHECK(run(machine, polyline({{0, 0, 0}, {100, 100, 0}}, 100)).time ==
        Approx(100 / (1000 * std::sqrt(2.0)) + std::sqrt(2.0)).epsilon(1e-12));
}

TEST_CASE("a line takes the trapezoid's time of its tangential limit", "[planner]") {
  for (const double jerk : {0.0, 1e6}) {
    CAPTURE(jerk);
    Machine machine = fast_machine(1000);
    for (Axis& axis : machine.axes) axis.jerk = jerk;
    machine.limits.tangential = 400;
    const auto result = run(machine, polyline({{0, 0, 0}, {60, 80, 0}}, 100));
    // L / v + v / a, and a / j more where the acceleration takes its time.
    CHECK(result.time == Approx(1 + 0.25 + (jerk > 0 ? 400 / (1e6 / 0.8) : 0)).epsilon(1e-6));
    CHECK(result.time_by_limit.at(Limit::tangential) > 0.48);
    CHECK(result.measured.tangential == Approx(400).epsilon(1e-3));
    CHECK(exceeded(machine, result) == "");
  }
}

TEST_CASE("the peak of the bend of a rounded corner is passed within the normal limit",
          "[planner]") {
  Machine machine = fast_machine(1000);
  machine.axes[0].acceleration = 300;
  machine.axes[1].jerk = 50000;
  machine.axes[2].acceleration = 3000;
  machine.limits.normal = 100;
  auto blocks = polyline({{-1.10836, 0.91422, 0},
                          {-7.3791, -3.09181, 0},
                          {-7.39356, -3.70401, 0},
                          {-4.06079, -8.57439, 0},
                          {-3.10147, -9.33149, 0},
                          {-1.97848, -9.81357, 0},
                          {-1.37938, -9.94034, 0},
                          {-0.76884, -9.98757, 0}},
                         250);
  for (Block& block : blocks) {
    std::get<Move>(block.what).corner_tolerance = 0.005;
    std::get<Move>(block.what).chord_tolerance = 0.01;
  }
  CHECK(exceeded(machine, run(machine, blocks)) == "");
}

TEST_CASE("a circle is run at the speed of its normal limit, ramps within the tangential one",
          "[planner]") {
  for (const double jerk : {0.0, 1e5}) {
    CAPTURE(jerk);
    Machine machine = fast_machine(1000);
    for (Axis& axis : machine.axes) axis.jerk = jerk;
    machine.limits.tangential = 200;
    machine.limits.normal = 160;
    const auto circle = Arc::make({{10, 0, 0}, {10, 0, 0}, {0, 0, 0}, Plane::xy, true, 2}).value();
    const auto result = run(machine, number_blocks({Move{circle, false, 100, PathMode::follow}}));
    // v = sqrt(160 * 10) = 40; L / v + v / a.
    const double closed = length(circle) / 40 + 40.0 / 200;
    CHECK(result.time == Approx(closed + (jerk > 0 ? 0.002 : 0)).epsilon(1.5e-3));
    CHECK(result.time_by_limit.at(Limit::normal) > 0.9 * length(circle) / 40);
    CHECK(result.time_by_limit.at(Limit::tangential) > 0.35);
    CHECK(result.measured.normal == Approx(160).epsilon(2e-3));
    CHECK(exceeded(machine, result) == "");
  }
}

TEST_CASE("a rapid is bound by the axes alone", "[planner]") {
  Machine machine = fast_machine(1000);
  machine.limits.feed = 10;
  for (Axis& axis : machine.axes) axis.velocity = 50;
  const auto result = run(machine, polyline({{0, 0, 0}, {100, 100, 0}}, 1, true));
  CHECK(result.time == Approx(100.0 / 50 + 50.0 / 1000).epsilon(1e-12));
  CHECK(result.time_by_limit.at(Limit::rapid) == Approx(100.0 / 50 - 50.0 / 1000));
}

TEST_CASE("a circle takes the time of the closed form under axis limits", "[planner]") {
  // Radius 10 mm, 100 mm/s, 1000 mm/s^2 per axis: at 100 mm/s one axis is just at its limit at the
  // quadrants. Ramps obey |cos| v'^ + |sin| v^2/r <= A on both axes; the reference is a fine
  // numeric integration of the ramp, up and down being mirror images.
  const Machine machine = fast_machine(1000);
  const auto result = run(machine, one_move(arc({10, 0, 0}, {10, 0, 0}, {0, 0, 0}, true), 100));
  double t = 0, s = 0, v = 0;
  const double r = 10, dt = 1e-7;
  while (v < 100) {
    const double angle = s / r, c = std::abs(std::cos(angle)), n = std::abs(std::sin(angle));
    const double sign_x = std::cos(angle) * std::sin(angle) < 0 ? -1 : 1;
    // x'' = -sin a - cos v^2/r; y'' = cos a - sin v^2/r with a, v along the path.
    const double x = (1000 - sign_x * c * v * v / r) / std::max(n, 1e-12);
    const double y = (1000 + sign_x * n * v * v / r) / std::max(c, 1e-12);
    v += std::min(x, y) * dt;
    s += v * dt;
    t += dt;
  }
  const double reference = 2 * t + (2 * std::numbers::pi * r - 2 * s) / 100;
  CHECK(result.time == Approx(reference).epsilon(3e-3));
  CHECK(exceeded(machine, result) == "");
}

TEST_CASE("circles and helices of many turns stay inside every limit", "[planner]") {
  for (const int turns : {2, 3, 4, 8})
    for (const double rise : {0.0, 2.0}) {
      CAPTURE(turns, rise);
      const auto path =
          Arc::make({{1, 0, 0}, {1, 0, turns * rise}, {0, 0, 0}, Plane::xy, true, turns - 1});
      REQUIRE(path);
      const Machine machine = fast_machine(1000);
      const auto result = run(machine, one_move(*path, 250));
      CHECK(exceeded(machine, result) == "");
      // Two axes together allow v^2/r of sqrt(2) times what one does; the rise adds to the
      // distance.
      const double fastest = std::sqrt(std::sqrt(2.0) * 1000 * path->radius());
      CHECK(result.time > path->length() / (fastest * (1 + rise)));
    }
}

TEST_CASE("an arc is braked on within the acceleration of the axes", "[planner]") {
  // Between two nodes v^2 falls as x'' grows: what they ask for together is no straight line.
  const double r = 0.42;
  for (double sweep = 2.5; sweep < 6.2; sweep += 0.06) {
    CAPTURE(sweep);
    const Machine machine = fast_machine(340, 1e-3, 5e-5);
    const AxisVector end(r * std::cos(sweep), r * std::sin(sweep), 0);
    const auto result = run(machine, one_move(arc({r, 0, 0}, end, {0, 0, 0}, true), 128));
    CHECK(exceeded(machine, result) == "");
  }
}

TEST_CASE("a slow axis keeps its speed between the nodes of an arc", "[planner]") {
  // The feed binds up to where the arc turns towards the slow axis; from there on what it allows
  // falls steeply, whatever lies halfway.
  for (const double slow : {5.0, 20.0, 60.0})
    for (const double feed : {70.0, 100.0, 150.0})
      for (const double start : {0.02, 0.05, 0.12, 0.15, 0.22, 0.33}) {
        CAPTURE(slow, feed, start);
        Machine machine = fast_machine(5000, 4e-3, 5e-3);
        machine.axes[1].velocity = slow;
        const AxisVector from(30 * std::cos(start), 30 * std::sin(start), 0);
        const auto result = run(machine, one_move(arc(from, from, {0, 0, 0}, true), feed));
        CHECK(exceeded(machine, result) == "");
      }
}

TEST_CASE("the benchmark curves take the optimum's time within 1 %, inside every limit",
          "[planner]") {
  // References: the exact acceleration-limited optimum (reachability analysis, an independent
  // program in Python with numpy), refined until the fourth figure stands.
  struct Case {
    const char* curve;
    double feed, period, tolerance, reference, within;
  };
  for (const Case& c : {Case{"butterfly", 100, 1e-3, 1e-3, 5.027, 0.01},
                        Case{"circle_deg2", 100, 1e-3, 1e-3, 0.7282, 0.01},
                        Case{"infinity8", 100, 1e-3, 1e-3, 12.773, 0.01},
                        Case{"butterfly", 2000.0 / 60, 8e-3, 5e-5, 41.56, 0.05},
                        Case{"butterfly", 2000.0 / 60, 8e-3, 2e-3, 12.159, 0.05},
                        Case{"butterfly", 100, 4e-3, 1e-3, 5.742, 0.05}}) {
    CAPTURE(c.curve, c.feed, c.period, c.tolerance);
    const Machine machine = fast_machine(1000, c.period, c.tolerance);
    const auto result = run(machine, one_move(test::curve(c.curve), c.feed));
    CHECK(result.time < c.reference * (1 + c.within));
    CHECK(result.time > c.reference * 0.995);
    CHECK(exceeded(machine, result) == "");
    CHECK(result.measured.feed_fluctuation < 1e-6);
    CHECK(result.rows.back().position ==
          position(test::curve(c.curve), test::curve(c.curve).length()));
  }
}

TEST_CASE("the machine rests where the tangent turns, and only there", "[planner]") {
  const Machine machine = fast_machine(1000);
  const auto square =
      run(machine, polyline({{0, 0, 0}, {50, 0, 0}, {50, 50, 0}, {0, 50, 0}, {0, 0, 0}}, 100));
  CHECK(square.time == Approx(4 * (0.5 + 0.1)).epsilon(1e-12));
  CHECK(exceeded(machine, square) == "");
  const auto straight = run(machine, polyline({{0, 0, 0}, {50, 0, 0}, {100, 0, 0}}, 100));
  CHECK(straight.time == Approx(1.1).epsilon(1e-12));
}

TEST_CASE("an exact stop rests at the end of its block", "[planner]") {
  const Machine machine = fast_machine(1000);
  auto blocks = polyline({{0, 0, 0}, {50, 0, 0}, {100, 0, 0}}, 100);
  std::get<Move>(blocks[0].what).path_mode = PathMode::stop;
  CHECK(run(machine, blocks).time == Approx(2 * (0.5 + 0.1)).epsilon(1e-12));
}

TEST_CASE("a corner has a row of its own where the polyline would cut it", "[planner]") {
  const Machine machine = fast_machine(1000, 8e-3, 5e-5);
  const auto result = run(machine, polyline({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 100));
  CHECK(exceeded(machine, result) == "");
  const bool row_in_corner =
      std::any_of(result.rows.begin(), result.rows.end(),
                  [](const Setpoint& row) { return row.position == AxisVector(10, 0, 0); });
  CHECK(row_in_corner);
  CHECK(result.time < 2 * (0.1 + 0.1) + 8e-3);
}

TEST_CASE("a tangent that is off by rounding does not stop the machine", "[planner]") {
  const Machine machine = fast_machine(1000);
  // A line into an arc whose center was rounded: the tangent turns by 1 mrad.
  const auto blocks = number_blocks(
      {Move{Line({0, 0, 0}, {50, 0, 0}), false, 100, PathMode::follow},
       Move{arc({50, 0, 0}, {60, 10, 0}, {50, 10, 0}, true), false, 100, PathMode::follow},
       Move{Line({60, 10, 0}, {60.05, 60, 0}), false, 100, PathMode::follow}});
  const auto result = run(machine, blocks);
  CHECK(exceeded(machine, result) == "");
  double slowest = 1e9;
  for (const Setpoint& row : result.rows)
    if (row.s > 20 && row.s < 90) slowest = std::min(slowest, row.v);
  CHECK(slowest > 50);
}

TEST_CASE("dwell is rest, actions happen at rest and take no time", "[planner]") {
  const Machine machine = fast_machine(1000);
  const Move first{Line({0, 0, 0}, {50, 0, 0}), false, 100, PathMode::follow};
  const Move second{Line({50, 0, 0}, {100, 0, 0}), false, 100, PathMode::follow};
  const auto result =
      run(machine, number_blocks({first, Dwell{0.25}, second, Action{Action::Kind::end, 30, 0}}));
  CHECK(result.time == Approx(2 * 0.6 + 0.25).epsilon(1e-12));
  CHECK(result.time_by_limit.at(Limit::stop) == Approx(0.25));
  int at_rest = 0;
  for (const Setpoint& row : result.rows)
    if (row.block == 2) {
      CHECK(row.v == 0);
      CHECK(row.limit == Limit::stop);
      CHECK(row.position == AxisVector(50, 0, 0));
      ++at_rest;
    }
  CHECK(at_rest == 250);
}

TEST_CASE("a move beyond the travel of an axis is reported with its block's place", "[planner]") {
  Machine machine = fast_machine(1000);
  for (Axis& axis : machine.axes) {
    axis.min = -12;
    axis.max = 12;
  }
  const auto at_end = run(machine, polyline({{0, 0, 0}, {5, 0, 0}, {5, -13, 0}}, 100));
  REQUIRE(at_end.diagnostics.size() == 1);
  CHECK(at_end.diagnostics[0].code == Code::SC4001);
  CHECK(at_end.diagnostics[0].pos.line == 2);
  CHECK(at_end.diagnostics[0].pos.column == 1);
  CHECK(at_end.diagnostics[0].message ==
        "Y reaches -13 mm, 1 mm beyond its travel from -12 to 12 mm");
  CHECK(at_end.rows.back().position == AxisVector(5, 0, 0));
  CHECK(at_end.rows.back().v == 0);
  // Coming back is not a second error, going further is.
  CHECK(run(machine, polyline({{0, 0, 0}, {0, 20, 0}, {0, 0, 0}}, 100)).diagnostics.size() == 1);
  CHECK(run(machine, polyline({{0, 0, 0}, {0, 20, 0}, {0, 30, 0}}, 100)).diagnostics.size() == 2);
  // Inside at both ends, outside between: the extremum counts. A half circle to Y 15.
  const auto between = run(machine, one_move(arc({10, 5, 0}, {-10, 5, 0}, {0, 5, 0}, true), 100));
  REQUIRE(between.diagnostics.size() == 1);
  CHECK(between.diagnostics[0].message ==
        "Y reaches 15 mm, 3 mm beyond its travel from -12 to 12 mm");
  // No false alarm: the same arc in the other direction stays inside, however far its circle
  // reaches.
  CHECK(run(machine, one_move(arc({10, 5, 0}, {-10, 5, 0}, {0, 5, 0}, false), 100))
            .diagnostics.empty());
}

TEST_CASE("an excess shows, however small, and every axis with it", "[planner]") {
  Machine machine = fast_machine(1000);
  machine.axes[0].max = 12;
  machine.axes[1].min = -12;
  const auto told = [&](const AxisVector& to) {
    const auto result = run(machine, polyline({{0, 0, 0}, to}, 100));
    REQUIRE(result.diagnostics.size() <= 1);
    return result.diagnostics.empty() ? std::string() : result.diagnostics[0].message;
  };
  CHECK(told({12, -12, 0}).empty());
  CHECK(told({12.0000005, 0, 0}).empty());
  CHECK(told({12.0000021, 0, 0}) ==
        "X reaches 12.0000021 mm, 0.0000021 mm beyond its travel from -1000 to 12 mm");
  CHECK(told({12.125, -1012, 0}) ==
        "X reaches 12.125 mm, 0.125 mm beyond its travel from -1000 to 12 mm; "
        "Y reaches -1012 mm, 1000 mm beyond its travel from -12 to 1000 mm");
}

TEST_CASE("an override below 100 % names itself where it binds", "[planner]") {
  const Machine machine = fast_machine(1000);
  const auto result = run(machine, polyline({{0, 0, 0}, {100, 0, 0}}, 100), -1, 1, 0.5);
  CHECK(result.time == Approx(100.0 / 50 + 50.0 / 1000));
  CHECK(result.time_by_limit.count(Limit::override_) == 1);
  CHECK(result.time_by_limit.count(Limit::feed) == 0);
}

TEST_CASE("rows count time from zero, one a period, the last at rest", "[planner]") {
  const Machine machine = fast_machine(1000);
  const auto result = run(machine, polyline({{0, 0, 0}, {4.1, 0, 0}}, 100));
  for (std::size_t i = 0; i < result.rows.size(); ++i)
    CHECK(result.rows[i].period == static_cast<std::int64_t>(i));
  CHECK(result.rows.front().position == AxisVector(0, 0, 0));
  CHECK(result.rows.back().position == AxisVector(4.1, 0, 0));
  CHECK(result.rows.back().v == 0);
  CHECK(static_cast<double>(result.rows.size() - 1) == std::ceil(result.time / 1e-3));
}

TEST_CASE("a program without motion is one row", "[planner]") {
  const Machine machine = fast_machine(1000);
  CHECK(run(machine, number_blocks({Action{Action::Kind::end, 30, 0}})).rows.size() == 1);
  CHECK(run(machine, {}).rows.size() == 1);
}

TEST_CASE("axes of very unequal acceleration are planned without a standstill", "[planner]") {
  // On the arc the slow axis stands nearly across the tangent: it bounds q, not u.
  Machine machine = fast_machine(200);
  machine.axes[1].acceleration = 6000;
  const AxisVector a(-2.001312053, -3.120116379, 0),
      b = a + AxisVector(-0.505348540, -3.279220161, 0);
  const auto result = run(
      machine, number_blocks({Move{Line({0, 0, 0}, a), false, 150, PathMode::follow},
                              Move{arc(a, b, a + AxisVector(3.444477562, -2.209364531, 0), true),
                                   false, 150, PathMode::follow},
                              Move{Line(b, b + AxisVector(0.969108962, -3.577877020, 0)), false,
                                   150, PathMode::follow}}));
  CHECK(exceeded(machine, result) == "");
  CHECK(result.diagnostics.empty());
  for (const Setpoint& row : result.rows)
    if (row.s > 1 && row.s < 9) REQUIRE(row.v > 5);
}

TEST_CASE("a bend too sharp to resolve is a corner", "[planner]") {
  for (const double x : {10.001, 10.0001, 9.9999, 10.00001, 9.99999, 10.0})
    for (const double period : {1e-3, 1e-4}) {
      CAPTURE(x, period);
      const Machine machine = fast_machine(1000, period);
      const auto nurbs = Nurbs::make({3,
                                      {{0, 0, 0}, {x, 10, 0}, {0, 10, 0}, {10, 0, 0}},
                                      {1, 1, 1, 1},
                                      {0, 0, 0, 0, 1, 1, 1, 1}});
      CHECK(exceeded(machine, run(machine, one_move(nurbs.value(), 100))) == "");
    }
}

TEST_CASE("moves far shorter than any machine resolves take no time to speak of", "[planner]") {
  const Machine machine = fast_machine(1000);
  for (const double size : {1e-6, 1e-7, 1e-8}) {
    const auto tiny = one_move(arc({0, 0, 0}, {size, 0, 0}, {size / 2, 0, 0}, false), 100);
    CHECK(run(machine, tiny).time < 5e-3);  // a sample at each of its turns
    CHECK(run(machine, polyline({{0, 0, 0}, {size, 0, 0}}, 100)).time < 1e-3);
  }
}

TEST_CASE("a slow feed needs no more nodes than a fast one", "[planner]") {
  const Machine machine = fast_machine(1000);
  for (const double feed : {100.0, 1.0, 0.1}) {
    Diagnostics diagnostics;
    ipo::Planner planner(machine, 1, diagnostics);
    planner.push(one_move(arc({50, 0, 0}, {50, 0, 0}, {0, 0, 0}, true), feed)[0]);
    CHECK(planner.counts().nodes < 1000);
  }
}

TEST_CASE("random programs keep every limit in every row", "[planner][property]") {
  for (unsigned seed = 1; seed <= 150; ++seed) {
    std::mt19937 random(seed);
    const double period = std::array{1e-3, 4e-3, 8e-3}[seed % 3];
    const double tolerance = std::array{1e-3, 5e-5, 5e-3}[seed / 3 % 3];
    Machine machine = fast_machine(seed % 2 ? 1000 : 5000, period, tolerance);
    machine.axes[2].acceleration = 300;
    machine.axes[1].velocity = 60;
    const auto blocks = random_program(random, 12);
    const auto result = run(machine, blocks);
    CAPTURE(seed);
    CHECK(exceeded(machine, result) == "");
    const Path& last = std::get<Move>(blocks.back().what).path;
    CHECK(result.rows.back().position == end(last));
  }
}

TEST_CASE("the plan does not depend on how the blocks arrive", "[planner][property]") {
  for (unsigned seed = 1; seed <= (test::kSanitized ? 4 : 20); ++seed) {
    std::mt19937 random(seed);
    Machine machine = fast_machine(1000);
    if (seed % 3 == 0)
      for (Axis& axis : machine.axes) axis.jerk = 50'000;
    auto blocks = random_program(random, test::kSanitized ? 20 : 40);
    if (seed % 4 == 0)
      for (Block& block : blocks) {
        Move& move = std::get<Move>(block.what);
        move.corner_tolerance = move.chord_tolerance = 0.02;
      }
    const auto whole = run(machine, blocks, -1, 0);
    for (const std::size_t chunk : {std::size_t{1}, std::size_t{7}, test::kSlowly}) {
      const auto pieces = run(machine, blocks, -1, chunk);
      REQUIRE(pieces.rows.size() == whole.rows.size());
      for (std::size_t i = 0; i < whole.rows.size(); ++i) {
        REQUIRE(pieces.rows[i].position == whole.rows[i].position);
        REQUIRE(pieces.rows[i].v == whole.rows[i].v);
        REQUIRE(pieces.rows[i].limit == whole.rows[i].limit);
      }
    }
  }
}

TEST_CASE("a block that leaves in parts is the block that leaves as a whole", "[planner]") {
  Machine machine = fast_machine(1000);
  machine.axes[0].jerk = machine.axes[1].jerk = GENERATE(0.0, 50'000.0);
  const auto blocks = number_blocks(
      {Move{Line({0, 0, 0}, {40, 0, 0}), false, 50, PathMode::follow},
       Move{arc({40, 0, 0}, {40, 0, 0}, {40, 30, 0}, true), false, 50, PathMode::follow},
       Move{Line({40, 0, 0}, {40, 80, 0}), false, 50, PathMode::follow}});
  Diagnostics diagnostics;
  ipo::Planner wholes(machine, 1, diagnostics), parts(machine, 1, diagnostics);
  for (const Block& block : blocks) wholes.push(block);
  wholes.finish();
  ipo::BlockQueue together(0), apart(0);
  std::size_t continuations = 0;
  const auto take_parts = [&] {
    while (auto part = parts.pop_part_now()) {
      continuations += std::holds_alternative<ipo::Continuation>(*part) ? 1 : 0;
      apart.push(std::move(*part));
    }
  };
  for (const Block& block : blocks) {
    parts.push(block);
    take_parts();
    CHECK_FALSE(apart.empty());  // at once: each line cruises, the arc is long
  }
  parts.finish();
  take_parts();
  CHECK(continuations >= 3);
  while (auto timed = wholes.pop()) together.push(std::move(*timed));
  CHECK(apart.t_end() == together.t_end());
  for (; !together.empty(); together.advance(), apart.advance()) {
    REQUIRE_FALSE(apart.empty());
    const ipo::TimedBlock &whole = together.front(), &part = apart.front();
    CHECK(part.block.number == whole.block.number);
    CHECK(part.t_start == whole.t_start);
    CHECK(part.s_start == whole.s_start);
    REQUIRE(part.profile.pieces() == whole.profile.pieces());
    std::size_t a = 0, b = 0;
    for (double t = 0; t < whole.profile.duration(); t += 1e-3) {
      const ipo::State expected = whole.profile.at(t, a), found = part.profile.at(t, b);
      REQUIRE(found.s == expected.s);
      REQUIRE(found.v == expected.v);
    }
  }
  CHECK(apart.empty());
}

TEST_CASE("however long a program, the planner holds a few of its blocks", "[planner][jerk]") {
  Machine machine = fast_machine(1000);
  const auto waiting = [&machine](const auto& move_of, int count) {
    Diagnostics diagnostics;
    ipo::Planner planner(machine, 1, diagnostics);
    int most = 0, gone = 0;
    for (int i = 0; i < count; ++i) {
      planner.push({move_of(i), {i + 1, 1, 1}, i + 1});
      while (const auto timed = planner.pop())
        gone = timed->marks.empty() ? timed->block.number : timed->marks.back().number;
      most = std::max(most, i + 1 - gone);
    }
    CHECK(diagnostics.errors() == 0);
    return most;
  };
  const auto stops = [](int i) {
    const AxisVector from(i % 2 == 0 ? 0 : 10, 0, 0), to(i % 2 == 0 ? 10 : 0, 0, 0);
    return Move{Line(from, to), false, 50, PathMode::follow};
  };
  const auto chords = [](int i) {
    const auto at = [](int k) {
      return AxisVector(5 * std::cos(0.02 * k), 5 * std::sin(0.02 * k), 0);
    };
    return Move{Line(at(i), at(i + 1)), false, 50, PathMode::follow, 0.005, 0.005};
  };
  for (const double jerk : {0.0, 50'000.0}) {
    for (Axis& axis : machine.axes) axis.jerk = jerk;
    CAPTURE(jerk);
    CHECK(waiting(stops, 3000) < 100);
    CHECK(waiting(chords, 3000) < 1500);
    CHECK(waiting(chords, 12'000) < 1500);
  }
}

TEST_CASE("a stop at any moment ends at rest on the path, within the limits", "[planner][stop]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const Machine machine = fast_machine(1000);
    const auto blocks = random_program(random, 10);
    const auto whole = run(machine, blocks);
    const int after = static_cast<int>(random() % whole.rows.size());
    const auto stopped = run(machine, blocks, after);
    CAPTURE(seed, after);
    CHECK(exceeded(machine, stopped) == "");
    CHECK(stopped.rows.back().v == 0);
    CHECK(stopped.rows.size() <= whole.rows.size() + 1);
    for (int i = 0; i <= after; ++i)
      REQUIRE(stopped.rows[static_cast<std::size_t>(i)].position ==
              whole.rows[static_cast<std::size_t>(i)].position);
  }
}

TEST_CASE("a stop on a line takes v^2 / 2a", "[planner][stop]") {
  const Machine machine = fast_machine(1000);
  const auto stopped = run(machine, polyline({{0, 0, 0}, {500, 0, 0}}, 100), 999);
  // At sample 999 the machine runs at 100 mm/s; it could stand 5 mm later.
  const double distance = stopped.rows.back().s - stopped.rows[999].s;
  CHECK(distance > 4.99);
  CHECK(distance < 5.11);
  CHECK(stopped.rows.back().v == 0);
}
