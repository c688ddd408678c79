// SPDX-License-Identifier: MIT
// The feed that keeps a roughness: in every sample below the limit, and near it where it binds.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "motion/roughness/roughness.hpp"
#include "support/machines.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

constexpr double kSurfaceFeed = 100;  // mm/s: 0.5 mm per tooth at 6000 rpm and two teeth

Surface paper_surface() { return {5, 0.5, 0.01066888, 2, 100}; }

Machine surfacing_machine(RoughnessModel model, double acceleration, double jerk = 0) {
  Machine machine = test::usual_machine(acceleration, jerk);
  machine.surfacing.model = model;
  return machine;
}

Move surface_move(Path path, double feed = kSurfaceFeed) {
  Move move{std::move(path), false, feed, PathMode::follow};
  move.surface = paper_surface();
  return move;
}

/// Over the top of a cylinder of 50 mm, from 25 degrees upward to 25 degrees downward.
Path over_cylinder(double sign = 1) {
  const double half = 50 * std::sin(std::numbers::pi * 25 / 180);
  const double height = 50 * std::cos(std::numbers::pi * 25 / 180);
  return Arc::make({{-half, 0, sign * height},
                    {half, 0, sign * height},
                    {0, 0, 0},
                    Plane::zx,
                    sign > 0,
                    0})
      .value();
}

/// The curve of programs 11 and 21: up out of a valley, over a hill, and down into one.
Path hill() {
  NurbsSpec spec;
  spec.degree = 3;
  spec.control = {{0, 0, 0},   {5, 0, 1},  {15, 0, 6}, {28, 0, 10},
                  {42, 0, 10}, {55, 0, 6}, {65, 0, 1}, {70, 0, 0}};
  spec.weights.assign(8, 1);
  spec.knots = {0, 0, 0, 0, 0.2, 0.4, 0.6, 0.8, 1, 1, 1, 1};
  return Nurbs::make(spec).value();
}

/// (5) and (6), written out again; mm/s.
double paper_cap(double sine) {
  const double r = 5, fp = 0.5, rmax = 0.01066888;
  const double beside = fp / (2 * std::numbers::pi) + std::sqrt(8 * r * rmax - fp * fp);
  const double tip = std::sqrt(r * sine * r * sine + 2 * r * rmax - rmax * rmax);
  return 2 * 100 * std::min(beside, tip);
}

double sine_on_cylinder(const Setpoint& row) { return row.position[0] / 50; }

}  // namespace

TEST_CASE("over a cylinder the feed keeps the roughness in every row", "[ipo][roughness]") {
  for (const double jerk : {0.0, 5e5}) {
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(jerk, sign);
      const Machine machine = surfacing_machine(RoughnessModel::paper, 5000, jerk);
      const auto result = run(machine, number_blocks({surface_move(over_cylinder(sign))}));
      REQUIRE(exceeded(machine, result) == "");
      double slowest = kSurfaceFeed;
      int bound = 0;
      for (const Setpoint& row : result.rows) {
        const double cap = paper_cap(sine_on_cylinder(row));
        if (row.v > cap * (1 + 1e-6))
          FAIL("at " << row.position[0] << ": " << row.v << " > " << cap);
        if (std::abs(row.position[0]) < 1) slowest = std::min(slowest, row.v);
        if (row.limit == Limit::roughness) ++bound;
      }
      CHECK(slowest / kSurfaceFeed == Approx(0.653).margin(0.01));
      CHECK(bound > 30);
      CHECK(result.measured.rmax <= 0.01066888 * 1.002);
      CHECK(result.measured.rmax > 0.01066888 * 0.99);
    }
  }
}

TEST_CASE("in a valley the guaranteed feed is lower than on level ground", "[ipo][roughness]") {
  // Through the bottom of a circle of radius 10 the surface, 15 from its axis, is half as long
  // again as the path of the tip.
  const Path valley = Arc::make({{-6, 0, 2}, {6, 0, 2}, {0, 0, 10}, Plane::zx, false, 0}).value();
  const auto fastest = [&](RoughnessModel model, const Path& path) {
    const Machine machine = surfacing_machine(model, 50000);
    const auto result = run(machine, number_blocks({surface_move(path)}));
    CHECK(result.measured.rmax <= 0.01066888 * 1.005);
    double near_bottom = 0;
    for (const Setpoint& row : result.rows)
      if (std::abs(row.position[0]) < 0.05) near_bottom = std::max(near_bottom, row.v);
    return near_bottom;
  };
  const Path level = Line({-6, 0, 0}, {6, 0, 0});
  CHECK(fastest(RoughnessModel::guaranteed, valley) ==
        Approx(fastest(RoughnessModel::guaranteed, level) / std::pow(1.5, 2.0 / 3)).epsilon(0.01));
  CHECK(fastest(RoughnessModel::paper, valley) ==
        Approx(fastest(RoughnessModel::paper, level)).epsilon(0.01));
}

TEST_CASE("the roughness costs no more time than its cap asks for", "[ipo][roughness]") {
  for (const double jerk : {0.0, 1e7}) {
    CAPTURE(jerk);
    const double acceleration = 1e5;
    const Machine machine = surfacing_machine(RoughnessModel::paper, acceleration, jerk);
    const Path path = over_cylinder();
    const auto result = run(machine, number_blocks({surface_move(path)}));
    // Half of both ramps, and every stretch at its limit.
    double ideal = jerk > 0 ? 2 * std::sqrt(kSurfaceFeed / jerk) : kSurfaceFeed / acceleration;
    constexpr int kSteps = 100000;
    const double ds = length(path) / kSteps;
    for (int i = 0; i < kSteps; ++i)
      ideal += ds / std::min(kSurfaceFeed, paper_cap(position(path, (i + 0.5) * ds)[0] / 50));
    CHECK(result.time == Approx(ideal).epsilon(0.003));
  }
}

TEST_CASE("plans that follow one another on the flanks of the cap find a way on",
          "[ipo][roughness][jerk]") {
  for (const auto& [acceleration, jerk] :
       {std::pair{2000.0, 2e5}, {5000.0, 5e5}, {10000.0, 1e6}, {10000.0, 2e6}, {20000.0, 1e7}}) {
    CAPTURE(acceleration, jerk);
    const Machine machine = surfacing_machine(RoughnessModel::paper, acceleration, jerk);
    const auto result = run(machine, number_blocks({surface_move(over_cylinder())}));
    CHECK(result.counts.effort.fallbacks == 0);
    for (const Setpoint& row : result.rows)
      if (std::abs(row.position[0]) < 10 && row.v < 0.6 * kSurfaceFeed) FAIL(row.position[0]);
  }
}

TEST_CASE("upward and downward milling cost the same", "[ipo][roughness]") {
  const Machine machine = surfacing_machine(RoughnessModel::guaranteed, 5000);
  const auto up = Line({0, 0, 0}, {40, 0, 1}), down = Line({0, 0, 1}, {40, 0, 0});
  const double time = run(machine, number_blocks({surface_move(up)})).time;
  CHECK(run(machine, number_blocks({surface_move(down)})).time == Approx(time));
  Move plain = surface_move(up);
  plain.surface.reset();
  CHECK(run(machine, number_blocks({plain})).time < time * 0.9);
}

TEST_CASE("without a target, or without a spindle, nothing is limited by roughness",
          "[ipo][roughness]") {
  const Machine machine = surfacing_machine(RoughnessModel::guaranteed, 5000);
  Move plain = surface_move(over_cylinder()), resting = plain;
  plain.surface.reset();
  resting.surface->spindle = 0;
  const auto expected = run(machine, number_blocks({plain}));
  const auto result = run(machine, number_blocks({resting}));
  CHECK(result.time_by_limit.count(Limit::roughness) == 0);
  REQUIRE(result.rows.size() == expected.rows.size());
  CHECK(result.time == expected.time);
}

TEST_CASE("the override does not multiply what roughness allows", "[ipo][roughness]") {
  const Machine machine = surfacing_machine(RoughnessModel::paper, 5000);
  const auto result =
      run(machine, number_blocks({surface_move(Line({0, 0, 0}, {60, 0, 0}))}), -1, 1, 1.5);
  double fastest = 0;
  for (const Setpoint& row : result.rows) fastest = std::max(fastest, row.v);
  CHECK(fastest == Approx(paper_cap(0)));
}

TEST_CASE("random curves keep their roughness with both models, with jerk limits and without",
          "[ipo][roughness][property]") {
  holds(
      [] {
        std::mt19937 random(static_cast<unsigned>(integer(1, 1'000'000'000)));
        Machine machine = random_machine(random);
        machine.surfacing.model = static_cast<RoughnessModel>(integer(0, 1));
        if (integer(0, 1) == 1)
          for (Axis& axis : machine.axes) axis.jerk = 0;
        Surface surface = paper_surface();
        surface.pick_feed = real(0.05, 0.6);
        if (integer(0, 2) == 0) surface.slope_across = real(0.01, 0.6);
        surface.rmax = least_rmax(surface) * real(1.05, 4);
        surface.teeth = integer(1, 5);
        surface.spindle = real(5, 400);
        std::vector<Block> blocks = random_program(random, integer(1, 4));
        for (Block& block : blocks)
          if (auto& move = std::get<Move>(block.what); !move.rapid) move.surface = surface;
        const auto result = run(machine, blocks);
        RC_ASSERT(exceeded(machine, result) == "");
        RC_ASSERT(result.roughness_used <= 1 + 1e-6);
        RC_ASSERT(result.measured.rmax <= surface.rmax * (1 + 1e-5));
      },
      40);
}

TEST_CASE("no row of the curves of paper 004 is faster than its roughness allows",
          "[ipo][roughness]") {
  for (const Path& path : {over_cylinder(), over_cylinder(-1), hill()})
    for (const RoughnessModel model : {RoughnessModel::paper, RoughnessModel::guaranteed})
      for (const double jerk : {0.0, 2e5, 2e6})
        for (const double period : {0.001, 0.004}) {
          Machine machine = surfacing_machine(model, 5000, jerk);
          machine.control.period = period;
          CAPTURE(name(model), jerk, period, length(path));
          const auto result = run(machine, number_blocks({surface_move(path)}));
          CHECK(result.roughness_used <= 1 + 1e-6);
          CHECK(result.roughness_used > 0.99);
          CHECK(result.counts.effort.fallbacks == 0);
          CHECK(result.time_by_limit.at(Limit::roughness) > 0.1 * result.time);
        }
}
