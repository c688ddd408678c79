// SPDX-License-Identifier: MIT
// Lines that turn by less than a corner: what samples see of them, and how fast they are run
// exactly.
#include "ipo/path/tangent_jump_load.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "support/machines.hpp"
#include "support/period.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

/// A polyline in the plane with its length from the first point to each.
struct Lines {
  std::vector<AxisVector> points;
  std::vector<double> ways{0};

  void add(const AxisVector& point) {
    if (!points.empty()) ways.push_back(ways.back() + (point - points.back()).norm());
    points.push_back(point);
  }
  AxisVector direction(std::size_t line) const {
    return (points[line + 1] - points[line]).normalized();
  }
  AxisVector at(double way) const {
    std::size_t line = 0;
    while (line + 2 < points.size() && ways[line + 1] < way) ++line;
    return points[line] + (way - ways[line]) * direction(line);
  }
};

/// Lines of 1/30 to 1 times `longest`, each of which turns by up to `turn` rad in either direction,
/// or to the left alone.
Lines random_lines(std::mt19937& random, int count, double longest, double turn, bool left) {
  const auto uniform = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  Lines lines;
  AxisVector here(0, 0, 0);
  double heading = uniform(0, 6.28);
  lines.add(here);
  for (int i = 0; i < count; ++i) {
    here += longest * std::pow(10, uniform(-1.5, 0)) *
            AxisVector(std::cos(heading), std::sin(heading), 0);
    lines.add(here);
    heading += uniform(left ? 0 : -turn, turn);
  }
  return lines;
}

/// What the tangent jumps around corner `n` of the lines require.
ipo::TangentJumpLoad load_around(const Lines& lines, std::size_t n, double acceleration,
                                 double cut) {
  ipo::TangentJumpLoad load(AxisVector::Constant(acceleration), cut, kPeriod);
  for (std::size_t i = 1; i + 1 < lines.points.size(); ++i) {
    const AxisVector jump = lines.direction(i) - lines.direction(i - 1);
    load.add(std::abs(lines.ways[i] - lines.ways[n]), jump.cwiseAbs(), jump.norm());
  }
  return load;
}

Machine jerkless_machine(double acceleration, double tolerance = 1e-3) {
  Machine machine = machine_with(1000, acceleration, 0);
  machine.control.chord_tolerance = tolerance;
  return machine;
}

double from_segment(const AxisVector& p, const AxisVector& a, const AxisVector& b) {
  const double w = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - w * (b - a)).norm();
}

}  // namespace

TEST_CASE("second differences of rows at one speed are no larger than what kinks are said to use",
          "[ipo][kink]") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 40; ++trial) {
    const Lines lines = random_lines(random, 60, 0.2, 0.009, trial % 2 == 0);
    const double v = 20 + 5 * trial, step = v * kPeriod, middle = lines.ways[30];
    AxisVector said = AxisVector::Zero(), seen = AxisVector::Zero();
    for (std::size_t n = 1; n + 1 < lines.points.size(); ++n)
      said = said.cwiseMax(load_around(lines, n, 1e3, 1).at(v));
    for (double way = middle - 3 * step; way < middle + 3 * step; way += step / 500) {
      const AxisVector d = lines.at(way - step) - 2 * lines.at(way) + lines.at(way + step);
      seen = seen.cwiseMax(d.cwiseAbs() / (kPeriod * kPeriod));
    }
    for (int axis = 0; axis < 2; ++axis) CHECK(seen[axis] <= said[axis] * (1 + 1e-9));
  }
}

TEST_CASE("one kink shows as its jump of velocity over one period", "[ipo][kink]") {
  ipo::TangentJumpLoad load(AxisVector::Constant(1e3), 1, kPeriod);
  load.add(0, {0, 0.005, 0}, 0.005);
  CHECK(load.at(100)[1] == Approx(0.005 * 100 / kPeriod).epsilon(1e-12));
  CHECK(load.fastest(1e4) == Approx(1e3 * kPeriod / 0.005).epsilon(1e-8));
  CHECK(load.fastest(10) == 10);
}

TEST_CASE("kinks close together show as the circle they lie on", "[ipo][kink]") {
  constexpr double kRadius = 20, kChord = 1e-3;
  ipo::TangentJumpLoad load(AxisVector::Constant(1e3), 1, kPeriod);
  for (int i = -400; i <= 400; ++i)
    load.add(kChord * std::abs(i), {kChord / kRadius, 0, 0}, kChord / kRadius);
  CHECK(load.at(100)[0] == Approx(100 * 100 / kRadius).epsilon(1e-3));
  CHECK(load.fastest(390) == Approx(std::sqrt(1e3 * kRadius)).epsilon(1e-3));
}

TEST_CASE("a step as long as kinks allow cuts them by no more than it may", "[ipo][kink]") {
  std::mt19937 random(8);
  for (int trial = 0; trial < 40; ++trial) {
    const Lines lines = random_lines(random, 60, 0.1, 0.009, trial % 2 == 0);
    constexpr double kCut = 5e-5;
    double v = 1000;
    for (std::size_t n = 10; n < 50; ++n)
      v = std::min(v, load_around(lines, n, 1e9, kCut).fastest(1000));
    const double step = v * kPeriod;
    double largest = 0;
    for (double way = lines.ways[15]; way + step < lines.ways[45]; way += step / 50) {
      const AxisVector from = lines.at(way), to = lines.at(way + step);
      for (std::size_t n = 0; n < lines.points.size(); ++n)
        if (lines.ways[n] > way && lines.ways[n] < way + step)
          largest = std::max(largest, from_segment(lines.points[n], from, to));
    }
    CHECK(largest <= kCut);
    CHECK(largest > 0.2 * kCut);
  }
}

TEST_CASE("a circle chopped into chords is run exactly as fast as the circle", "[ipo][kink]") {
  const auto [radius, chord, feed] = GENERATE(table<double, double, double>(
      {{20, 0.05, 100}, {20, 0.15, 200}, {50, 0.3, 300}, {5, 0.01, 50}}));
  CAPTURE(radius, chord, feed);
  const Machine machine = jerkless_machine(1000);
  const int chords = static_cast<int>(2 * std::numbers::pi * radius / chord);
  std::vector<AxisVector> points;
  for (int i = 0; i <= chords; ++i) {
    const double angle = 2 * std::numbers::pi * i / chords;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  const ArcSpec spec{{radius, 0, 0}, {radius, 0, 0}, {0, 0, 0}, Plane::xy, true, 1};
  const auto chopped = run(machine, polyline(points, feed));
  const auto smooth =
      run(machine, number_blocks({Move{Arc::make(spec).value(), false, feed, PathMode::follow}}));
  CHECK(exceeded(machine, chopped) == "");
  CHECK(chopped.time < 1.05 * smooth.time);
}

TEST_CASE("a joint that may only be passed slowly takes no longer than a stop, whatever the feed",
          "[ipo][kink]") {
  const auto [jerk, acceleration, period] = GENERATE(table<double, double, double>(
      {{5e3, 1e3, 1e-3}, {5e4, 1e3, 5e-4}, {0, 50, 5e-4}, {0, 200, 1e-3}}));
  CAPTURE(jerk, acceleration, period);
  Machine machine = jerkless_machine(acceleration);
  machine.control.period = period;
  for (Axis& axis : machine.axes) axis.jerk = jerk;
  double before = 1e9;
  for (const double feed : {50.0, 100.0, 200.0}) {
    const std::vector<AxisVector> points{{0, 0, 0}, {10, 0, 0}, {20, 0.095, 0}};
    auto blocks = polyline(points, feed);
    const auto passed = run(machine, blocks);
    for (Block& block : blocks) std::get<Move>(block.what).path_mode = PathMode::stop;
    const double stopped = run(machine, blocks).time;
    CHECK(exceeded(machine, passed) == "");
    CHECK(passed.time < stopped + 4 * period);
    CHECK(passed.time < 1.005 * before);
    before = passed.time;
  }
}

TEST_CASE("random lines without corners keep every limit under random overrides, stops and holds",
          "[ipo][kink][property]") {
  holds(
      [] {
        std::mt19937 random(static_cast<unsigned>(integer(1, 1'000'000'000)));
        const auto power = [&](double a, double b) {
          return std::pow(10.0, a + (b - a) * static_cast<double>(random()) /
                                        static_cast<double>(std::mt19937::max()));
        };
        Machine machine = random_machine(random);
        for (Axis& axis : machine.axes) axis.jerk = 0;
        if (random() % 3 == 0) machine.axes[random() % 2].acceleration *= power(-1.5, 0);
        if (random() % 4 == 0) machine.limits.tangential = machine.axes[0].acceleration * 0.3;
        const Lines lines = random_lines(random, 10 + static_cast<int>(random() % 150),
                                         power(-2, 1), power(-4, -2), random() % 2 == 0);
        std::vector<Block> blocks = polyline(lines.points, power(0.3, 2.5));
        leave_out_axes(random, machine, blocks);
        const AxisVector last = end(std::get<Move>(blocks.back().what).path);
        const auto result = run(machine, blocks);
        RC_ASSERT(exceeded(machine, result) == "");
        RC_ASSERT(result.rows.back().position == last);
        const auto pieces = run(machine, blocks, -1, static_cast<std::size_t>(integer(1, 7)));
        RC_ASSERT(pieces.rows.size() == result.rows.size());
        const int after = integer(0, static_cast<int>(result.rows.size()) - 1);
        RC_ASSERT(exceeded(machine, run(machine, blocks, after)) == "");
        const auto controlled = run(machine, blocks, random_controls(random, integer(1, 6)));
        RC_ASSERT(exceeded(machine, controlled) == "");
        RC_ASSERT(controlled.rows.back().position == last);
      },
      programs_asked(kSanitized ? 30 : 300));
}
