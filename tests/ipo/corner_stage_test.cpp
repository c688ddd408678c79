// SPDX-License-Identifier: MIT
#include "ipo/smoothing/corner_stage.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "support/chords.hpp"
#include "support/machines.hpp"
#include "support/paths.hpp"
#include "support/property.hpp"
#include "support/rounded.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::ipo;
using test::number_blocks;
using test::path_of;
using test::rounded;

namespace {

Machine wide_machine(double acceleration, double jerk = 0) {
  Machine machine = test::machine_with(1000, acceleration, jerk);
  for (Axis& axis : machine.axes) {
    axis.min = -1e5;
    axis.max = 1e5;
  }
  return machine;
}

/// Passes every curve at the feed, so that no rest would be sooner.
Machine mighty(double jerk = 0) {
  Machine machine = wide_machine(1e9, jerk);
  machine.control.period = 1e-6;
  machine.control.chord_tolerance = 1;
  return machine;
}

Move move_within(Path path, double p, double q, double feed = 100) {
  return {std::move(path), false, feed, PathMode::follow, p, q};
}

std::vector<Block> polyline_within(const std::vector<AxisVector>& points, double p, double q,
                                   double feed = 100) {
  std::vector<std::variant<Move, Dwell, Action>> moves;
  for (std::size_t i = 1; i < points.size(); ++i)
    moves.emplace_back(move_within(Line(points[i - 1], points[i]), p, q, feed));
  return number_blocks(std::move(moves));
}

AxisVector random_step(double size) {
  using test::real;
  return size * AxisVector(real(-1, 1), real(-1, 1), real(-1, 1));
}

double random_size(double low, double high) { return std::pow(10.0, test::real(low, high)); }

/// Half circles one after another, to and fro.
AxisVector on_serpentine(double s, double radius) {
  const double half = std::numbers::pi * radius;
  const double k = std::floor(s / half);
  const double angle = (s - k * half) / radius;
  const double up = std::fmod(k, 2) == 0 ? 1 : -1;
  return {2 * radius * k - radius * std::cos(angle), up * radius * std::sin(angle), 0};
}

std::vector<AxisVector> serpentine(double radius, double chord, int count, double grid) {
  std::vector<AxisVector> points;
  for (int i = 0; i <= count; ++i) {
    const AxisVector point = on_serpentine(i * chord, radius);
    points.push_back(grid > 0 ? AxisVector((point / grid).array().round() * grid) : point);
  }
  return points;
}

void check_same_ends(const std::vector<Block>& blocks, const std::vector<Piece>& pieces) {
  CHECK(start(path_of(pieces.front().block)) == start(path_of(blocks.front())));
  CHECK(end(path_of(pieces.back().block)) == end(path_of(blocks.back())));
}

/// From the beginning of the program to its end, in its order, with no larger jumps than these.
void check_goes_on(const std::vector<Block>& blocks, const std::vector<Piece>& pieces,
                   const test::Jumps& most) {
  const auto jumps = test::jumps(pieces);
  RC_ASSERT(jumps.gap <= most.gap);
  RC_ASSERT(jumps.turn <= most.turn);
  RC_ASSERT(jumps.curvature <= most.curvature);
  RC_ASSERT(test::in_order(pieces));
  check_same_ends(blocks, pieces);
}

}  // namespace

TEST_CASE("a corner between long lines is P away from its rounding", "[corner_stage]") {
  constexpr double kShare = 2e-6;  // the search for a width ends at 1e-6 of the tolerance
  for (const double angle : {0.05, 0.5, 0.5 * std::numbers::pi, 2.5}) {
    const auto blocks = polyline_within(
        {{-10, 0, 0}, {0, 0, 0}, 10 * AxisVector(std::cos(angle), std::sin(angle), 0)}, 0.05, 0);
    const auto pieces = rounded(mighty(), blocks);
    REQUIRE(pieces.size() == 3);
    CAPTURE(angle);
    const Path& curve = path_of(pieces[1].block);
    CHECK(position(curve, 0.5 * length(curve)).norm() == Approx(0.05).epsilon(kShare));
    // w |k| / 6 = P with |k| = 2 sin(angle / 2).
    CHECK(length(path_of(pieces[0].block)) ==
          Approx(10 - 6 * 0.05 / (2 * std::sin(angle / 2))).epsilon(kShare));
    CHECK(pieces[1].deviation == Approx(0.05).epsilon(kShare));
    // The line changes at the middle.
    REQUIRE(pieces[1].marks.size() == 1);
    CHECK(pieces[1].marks[0].s == Approx(0.5 * length(curve)));
    CHECK(pieces[1].marks[0].number == 2);
  }
}

TEST_CASE("lines in every direction, long and short, stay within P of the program",
          "[corner_stage][property]") {
  test::holds(
      [] {
        const double p = random_size(-3, -0.5), size = random_size(-2, 1.5);
        std::vector<AxisVector> points{random_step(50)};
        for (int i = 0; i < 24; ++i)
          points.push_back(points.back() + random_step(size * random_size(-1, 1)));
        const auto blocks = polyline_within(points, p, test::integer(0, 2) * 0.5 * p);
        const auto pieces = rounded(mighty(), blocks);
        RC_ASSERT(test::apart(blocks, pieces) <= p * (1 + 1e-6));
        // The curvature is rounding, where lines of a few um meet.
        check_goes_on(blocks, pieces, {0, 1e-7, 1e-3});
      },
      40);
}

TEST_CASE("chopped curves, fine and coarse, stay within P of the program",
          "[corner_stage][property]") {
  test::holds(
      [] {
        using test::real;
        const double p = random_size(-3, -1), radius = random_size(-0.5, 1.5);
        const double chord = std::sqrt(8 * radius * p * random_size(-3, 0.3));
        const double even = random_size(-3, 0), noise = p * random_size(-4, -1);
        std::vector<AxisVector> points{AxisVector::Zero()};
        double angle = real(0, 6), curvature = 1 / radius;
        for (int i = 0; i < 60; ++i) {
          if (test::integer(0, 15) == 0)
            curvature = real(-1, 1) / radius;  // straight, or in the other direction
          if (test::integer(0, 25) == 0) angle += real(-1, 1);  // a corner
          const double length = chord * (1 + even * real(-0.9, 3));
          angle += 0.5 * curvature * length;
          const AxisVector direction(std::cos(angle), std::sin(angle), 0.1);
          angle += 0.5 * curvature * length;
          points.push_back(points.back() + length * direction + random_step(noise));
        }
        auto blocks = polyline_within(points, p, test::integer(0, 2) * 0.5 * p);
        if (test::integer(0, 1) == 0) std::get<Move>(blocks[30].what).feed = 90;
        const auto pieces = rounded(mighty(), blocks);
        RC_ASSERT(test::apart(blocks, pieces) <= p * (1 + 1e-6));
        for (const Piece& piece : pieces) RC_ASSERT(piece.deviation <= p * (1 + 1e-6));
        check_goes_on(blocks, pieces, {1e-12, 1e-7, 1e-3});
      },
      60);
}

TEST_CASE("long chopped curves stay within P of the program, and become few spans",
          "[corner_stage][property]") {
  test::holds(
      [] {
        using test::real;
        const double p = random_size(-3, -1), radius = random_size(0, 1);
        const double chord = std::sqrt(8 * radius * p) * random_size(-1.3, -0.3);
        const double even = random_size(-3, -0.5), noise = p * random_size(-4, -1.3);
        std::vector<AxisVector> points{AxisVector::Zero()};
        double angle = 0, curvature = 1 / radius, curvature_rate = 0;
        for (int i = 0; i < 300; ++i) {
          const int event = test::integer(0, 60);
          if (event == 0)
            curvature = real(-1, 1) / radius, curvature_rate = 0;  // an arc, or nearly straight
          if (event == 1) curvature_rate = real(-0.2, 0.2) / (radius * radius);
          if (event == 2) curvature = curvature_rate = 0;
          if (event == 3) angle += real(-1, 1);
          const double length = chord * (1 + even * real(-0.9, 3));
          curvature = std::clamp(curvature + curvature_rate * length, -1 / radius, 1 / radius);
          angle += 0.5 * curvature * length;
          const AxisVector direction(std::cos(angle), std::sin(angle), 0);
          angle += 0.5 * curvature * length;
          points.push_back(points.back() + length * direction + random_step(noise));
        }
        auto blocks = polyline_within(points, p, test::integer(0, 2) * 0.5 * p);
        if (test::integer(0, 2) == 0) std::get<Move>(blocks[150].what).feed = 90;
        const auto pieces = rounded(mighty(), blocks);
        std::vector<AxisVector> run;
        test::Cloud cloud;
        for (const Piece& piece : pieces) {
          const Path& path = path_of(piece.block);
          cloud.add(path);
          const int steps = std::holds_alternative<Line>(path) ? 1 : 300;
          for (int i = 0; i <= steps; ++i) run.push_back(position(path, length(path) * i / steps));
          RC_ASSERT(piece.deviation <= p * (1 + 1e-6));
        }
        RC_ASSERT(test::from_polyline(run, points) <= p * (1 + 1e-6));
        for (const AxisVector& point : points) RC_ASSERT(cloud.distance(point) <= p * (1 + 1e-6));
        check_goes_on(blocks, pieces, {1e-12, 1e-7, 1e-3});
      },
      40);
}

TEST_CASE("along a chopped curve a span reaches over many lines", "[corner_stage]") {
  const auto points = serpentine(3.5, 0.1, 2000, 1e-4);
  const auto pieces = rounded(mighty(), polyline_within(points, 0.005, 0.005));
  std::size_t spans = 0;
  for (const Piece& piece : pieces) spans += breaks(path_of(piece.block)).size() + 1;
  CHECK(spans < 2000 / 5);
}

TEST_CASE("a chopped circle becomes a spline of few spans that bends like it", "[corner_stage]") {
  const double radius = 3.5, p = 0.005;
  const auto blocks = polyline_within(serpentine(radius, 0.04, 270, 0), p, 0);
  const auto pieces = rounded(mighty(), blocks);
  double s = 0;
  int knots = 0;
  for (const Piece& piece : pieces) {
    const Path& path = path_of(piece.block);
    for (int i = 0; i < 500; ++i) {
      const double at_s = length(path) * i / 500;
      if (s + at_s < 3 || s + at_s > 7.5) continue;
      CHECK(at(path, at_s).ddq.norm() * radius == Approx(1).epsilon(0.02));
    }
    for (const double at_s : breaks(path)) knots += s + at_s > 3 && s + at_s < 7.5 ? 1 : 0;
    s += length(path);
    CHECK(piece.deviation < 0.6 * p);
  }
  CHECK(knots < 4.5 / 0.5);  // 0.16 of the radius apart, or more
}

TEST_CASE("lines, arcs and NURBS stay within P of the program", "[corner_stage][property]") {
  test::holds(
      [] {
        using test::real;
        const double p = random_size(-2.5, -0.7), size = random_size(-0.5, 1);
        std::vector<std::variant<Move, Dwell, Action>> moves;
        AxisVector here = AxisVector::Zero();
        for (int i = 0; i < 8; ++i) {
          const double length = size * random_size(-0.5, 0.5);
          const int kind = test::integer(0, 2);
          const double feed = 50 + 10 * test::integer(0, 1);
          if (kind == 0) {
            const AxisVector to = here + random_step(length) + AxisVector(0, 0, 0.1 * length);
            moves.emplace_back(move_within(Line(here, to), p, p, feed));
            here = to;
          } else if (kind == 1) {
            const double from = real(0, 6.28), sweep = real(0.3, 6) * (1 - 2 * test::integer(0, 1));
            const auto on = [&](double angle) {
              return AxisVector(length * AxisVector(std::cos(angle), std::sin(angle), 0));
            };
            const AxisVector center = here - on(from);
            const AxisVector to =
                center + on(from + sweep) + AxisVector(0, 0, real(-0.5, 0.5) * length);
            moves.emplace_back(move_within(test::arc(here, to, center, sweep > 0), p, p, feed));
            here = to;
          } else {
            NurbsSpec spec{3, {here}, {1, 2, 1, 0.5, 1, 1}, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}};
            const double turn = real(0, 6.28);
            for (int k = 0; k < 5; ++k)
              spec.control.push_back(
                  spec.control.back() +
                  length * AxisVector(std::cos(turn + 0.4 * k), std::sin(turn + 0.4 * k), 0.2 * k));
            here = spec.control.back();
            moves.emplace_back(move_within(Nurbs::make(spec).value(), p, p, feed));
          }
        }
        const auto blocks = number_blocks(std::move(moves));
        const auto pieces = rounded(mighty(1e14 * test::integer(0, 1)), blocks);
        RC_ASSERT(test::apart(blocks, pieces) <= p * (1 + 1e-6));
        check_goes_on(blocks, pieces, {1e-12, 1e-6, 1e-5});
      },
      25);
}

TEST_CASE("chopped curves are as smooth as the curves were", "[corner_stage]") {
  const double radius = 3.5;
  const auto blocks = polyline_within(serpentine(radius, 0.1, 1000, 1e-4), 0.005, 0.005);
  const auto pieces = rounded(wide_machine(1000), blocks);
  CHECK(test::apart(blocks, pieces) <= 0.005);
  const auto jumps = test::jumps(pieces);
  CHECK(jumps.turn < 1e-9);
  CHECK(jumps.curvature < 1e-6);
  CHECK(test::in_order(pieces));
  double largest = 0, s = 0;
  for (const Piece& piece : pieces) {
    const Path& path = path_of(piece.block);
    for (int i = 0; i < 100; ++i)
      if (s > 2 && s < 98) largest = std::max(largest, at(path, length(path) * i / 100).ddq.norm());
    s += length(path);
  }
  // From arc to arc the curvature jumps by two, and overshoots by a twelfth of that
  // (chord_knots.hpp); chords of 0.1 mm alone turn by ten times the curvature at their ends.
  CHECK(largest * radius < 1 + 2.0 / 12);
}

TEST_CASE("20,000 chords of 0.1 mm keep every limit, near the time of the curve itself",
          "[corner_stage]") {
  const Machine machine = wide_machine(1000);
  const auto chords = polyline_within(serpentine(3.5, 0.1, 20000, 1e-4), 0.005, 0.005, 250);
  const auto result = test::run(machine, chords);
  CHECK(test::exceeded(machine, result) == "");
  std::vector<std::variant<Move, Dwell, Action>> moves;
  const double half = std::numbers::pi * 3.5;
  AxisVector here = on_serpentine(0, 3.5);
  for (int k = 0; k * half < 2000; ++k) {
    const AxisVector center(2 * 3.5 * k, 0, 0);
    const AxisVector to = center + AxisVector(3.5, 0, 0);
    moves.emplace_back(move_within(test::arc(here, to, center, k % 2 != 0), 0, 0, 250));
    here = to;
  }
  const auto arcs = test::run(machine, number_blocks(std::move(moves)));
  const double per_mm = arcs.time / (std::ceil(2000 / half) * half);
  CAPTURE(result.time, per_mm * 2000);
  CHECK(result.time < 1.06 * per_mm * 2000);
}

TEST_CASE("20,000 chords on arcs and sines, with corners between, keep every limit",
          "[corner_stage]") {
  const Machine machine = wide_machine(1000);
  const auto points = test::Chopped(3.5, 0.1, 1e-4).points(20000);
  const auto result = test::run(machine, polyline_within(points, 0.005, 0.005, 250));
  CHECK(test::exceeded(machine, result) == "");
  CHECK(result.rows.back().position == points.back());
  const auto exact = test::run(machine, polyline_within(points, 0, 0, 250));
  CAPTURE(result.time, exact.time);
  CHECK(result.time < 0.7 * exact.time);
}

TEST_CASE("lines that are joined go on smoothly from an arc and into one", "[corner_stage]") {
  for (const double jerk : {0.0, 5e4}) {
    std::vector<std::variant<Move, Dwell, Action>> moves;
    moves.emplace_back(
        move_within(test::arc({-10, 10, 0}, {0, 0, 0}, {0, 10, 0}, true), 0.05, 0.05));
    AxisVector here = AxisVector::Zero();
    for (int i = 1; i <= 30; ++i) {
      const AxisVector to(0.1 * i, 0.001 * i * i, 0);
      moves.emplace_back(move_within(Line(here, to), 0.05, 0.05));
      here = to;
    }
    moves.emplace_back(move_within(
        test::arc(here, here + AxisVector(5, -5, 0), here + AxisVector(0, -5, 0), false), 0.05,
        0.05));
    const auto blocks = number_blocks(std::move(moves));
    const auto pieces = rounded(wide_machine(1000, jerk), blocks);
    CHECK(pieces.size() < 16);
    CHECK(test::jumps(pieces).turn < 1e-7);
    CHECK(test::in_order(pieces));
    CHECK(test::apart(blocks, pieces) <= 0.05);
    check_same_ends(blocks, pieces);
  }
}

TEST_CASE("what must be exact is exact", "[corner_stage]") {
  const Line east({0, 0, 0}, {10, 0, 0}), north({10, 0, 0}, {10, 10, 0});
  const auto machine = wide_machine(1000);
  const auto corner_is_met = [&](std::vector<std::variant<Move, Dwell, Action>> moves) {
    const auto pieces = rounded(machine, number_blocks(std::move(moves)));
    return std::any_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
      const Move* move = std::get_if<Move>(&piece.block.what);
      return move && end(move->path) == AxisVector(10, 0, 0);
    });
  };
  CHECK_FALSE(corner_is_met({move_within(east, 0.1, 0), move_within(north, 0.1, 0)}));
  CHECK_FALSE(corner_is_met({move_within(east, 0.1, 0, 50), move_within(north, 0.1, 0, 70)}));
  CHECK(corner_is_met({move_within(east, 0.1, 0), Dwell{0.1}, move_within(north, 0.1, 0)}));
  CHECK(corner_is_met({move_within(east, 0.1, 0), Action{Action::Kind::coolant, 8, 0},
                       move_within(north, 0.1, 0)}));
  CHECK(corner_is_met({move_within(east, 0.1, 0), move_within(north, 0, 0)}));
  CHECK(corner_is_met({move_within(east, 0, 0), move_within(north, 0.1, 0)}));
  Move rapid = move_within(north, 0.1, 0);
  rapid.rapid = true;
  CHECK(corner_is_met({move_within(east, 0.1, 0), rapid}));
  Move first_rapid = move_within(east, 0.1, 0);
  first_rapid.rapid = true;
  CHECK_FALSE(corner_is_met({first_rapid, rapid}));
  CHECK(corner_is_met(
      {move_within(east, 0.1, 0), move_within(Line({10, 0, 0}, {0, 0.1, 0}), 0.1, 0)}));
  Move stop = move_within(north, 0, 0);
  stop.path_mode = PathMode::stop;
  CHECK(corner_is_met({move_within(east, 0.1, 0), stop}));
}

TEST_CASE("of two tolerances the smaller counts, and a blend has the feed of either side",
          "[corner_stage]") {
  const auto blocks = number_blocks({move_within(Line({0, 0, 0}, {10, 0, 0}), 0.1, 0, 50),
                                     move_within(Line({10, 0, 0}, {10, 10, 0}), 0.02, 0, 70)});
  const auto pieces = rounded(wide_machine(1000), blocks);
  REQUIRE(pieces.size() == 4);
  CHECK(test::apart(blocks, pieces) == Approx(0.02).epsilon(1e-5));
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(std::get<Move>(pieces[i].block.what).feed == (i < 2 ? 50 : 70));
  CHECK(length(path_of(pieces[1].block)) == Approx(length(path_of(pieces[2].block))));
}

TEST_CASE("without a tolerance blocks pass at once, unchanged", "[corner_stage]") {
  const Machine machine = wide_machine(1000);
  CornerStage stage(machine, make_trial_plan(machine));
  const auto blocks = polyline_within({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, 0, 0);
  for (const Block& block : blocks) CHECK(stage.passes(block));
  stage.push(polyline_within({{0, 0, 0}, {1, 0, 0}}, 0.1, 0)[0]);
  CHECK_FALSE(stage.passes(blocks[0]));
  CHECK_FALSE(stage.pop());
  stage.push(blocks[0]);
  REQUIRE(stage.pop());
  const auto second = stage.pop();
  REQUIRE(second);
  CHECK(end(path_of(second->block)) == AxisVector(10, 0, 0));
  CHECK(stage.passes(blocks[1]));
}

TEST_CASE("little is held back, however long the program", "[corner_stage]") {
  const Machine machine = wide_machine(1000);
  CornerStage stage(machine, make_trial_plan(machine));
  int in = 0, out = 0, most = 0;
  for (const Block& block : polyline_within(serpentine(20, 0.05, 6000, 0), 0.01, 0.01)) {
    stage.push(block);
    ++in;
    while (auto piece = stage.pop()) {
      const int last = piece->marks.empty() ? piece->block.number : piece->marks.back().number;
      out = std::max(out, last);
    }
    most = std::max(most, in - out);
  }
  CHECK(most < 600);
  CHECK(out > 3000);
}

TEST_CASE("a NURBS with a corner inside is rounded there", "[corner_stage]") {
  const NurbsSpec spec{2,
                       {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}, {10, 5, 0}, {10, 10, 0}},
                       {1, 1, 1, 1, 1},
                       {0, 0, 0, 1, 1, 2, 2, 2}};
  const auto blocks = number_blocks({move_within(Nurbs::make(spec).value(), 0.05, 0.05)});
  const auto pieces = rounded(wide_machine(1000), blocks);
  const auto jumps = test::jumps(pieces);
  CHECK(jumps.turn < 1e-9);
  CHECK(test::apart(blocks, pieces) <= 0.05);
  CHECK(test::apart(blocks, pieces) > 0.04);
}

TEST_CASE("rounding a corner never costs time, however small the tolerance", "[corner_stage]") {
  const Machine machine = wide_machine(1000);
  const std::vector<AxisVector> points{{0, 0, 0}, {26, 0, 0}, {26, 26, 0}};
  double before = test::run(machine, polyline_within(points, 0, 0)).time;
  CHECK(before == Approx(2 * (0.26 + 0.1)));
  for (const double p : {0.003, 0.01, 0.05, 0.2}) {
    const auto result = test::run(machine, polyline_within(points, p, p));
    CAPTURE(p);
    CHECK(test::exceeded(machine, result) == "");
    CHECK(result.time < before - 0.002);
    before = result.time;
  }
}

TEST_CASE("a spiral of 200 sides with stops takes the least time from rest to rest, and waits",
          "[corner_stage][feed][jerk]") {
  const Machine machine = wide_machine(1000, 50'000);
  std::vector<AxisVector> points{{0, 0, 0}};
  double stops = 0;
  for (int i = 0; i < 200; ++i) {
    const double side = 1 + 0.25 * (i / 2);
    const double angle = std::numbers::pi / 2 * i;
    points.push_back(points.back() + side * AxisVector(std::round(std::cos(angle)),
                                                       std::round(std::sin(angle)), 0));
    // v^2 / a + v a / j = 12 mm to 100 mm/s and back, 2 a^3 / j^2 = 0.8 mm to hold 1000 mm/s^2.
    stops += side >= 12 ? side / 100 + 0.12 : 0.02 + std::sqrt(0.02 * 0.02 + 4 * side / 1000);
  }
  auto exact = polyline_within(points, 0, 0);
  for (Block& block : exact) std::get<Move>(block.what).path_mode = PathMode::stop;
  const auto result = test::run(machine, exact);
  CHECK(test::exceeded(machine, result) == "");
  CHECK(result.time >= stops * (1 - 1e-5));
  CHECK(result.time <= stops * 1.001);
}

TEST_CASE("a spiral of 200 sides: stops at G61.1, rounded corners at G64 P0.05",
          "[corner_stage][feed]") {
  const Machine machine = wide_machine(1000);
  std::vector<AxisVector> points{{0, 0, 0}};
  double stops = 0;
  for (int i = 0; i < 200; ++i) {
    const double side = 1 + 0.25 * (i / 2);
    const std::array<AxisVector, 4> ways{AxisVector(1, 0, 0), AxisVector(0, 1, 0),
                                         AxisVector(-1, 0, 0), AxisVector(0, -1, 0)};
    points.push_back(points.back() + side * ways[static_cast<std::size_t>(i % 4)]);
    const double ramp = 100.0 * 100.0 / 1000;  // v^2 / a
    stops += side < ramp ? 2 * std::sqrt(side / 1000) : side / 100 + 100.0 / 1000;
  }
  auto exact = polyline_within(points, 0, 0);
  for (Block& block : exact) std::get<Move>(block.what).path_mode = PathMode::stop;
  const auto slow = test::run(machine, exact);
  CHECK(test::exceeded(machine, slow) == "");
  // Beside the closed form, at most one period of waiting at a corner.
  CHECK(slow.time >= stops);
  CHECK(slow.time <= stops + 200 * machine.control.period);
  const auto fast = test::run(machine, polyline_within(points, 0.05, 0.05));
  CHECK(test::exceeded(machine, fast) == "");
  CAPTURE(slow.time, fast.time);
  CHECK(fast.time < slow.time - 199 * 0.012);  // s for each corner
}

TEST_CASE("bends are forgotten as the path goes on, also between straight lines",
          "[corner_stage]") {
  std::deque<ipo::Piece> out;
  ipo::SmoothedSegments pieces(out);
  const auto corner = [](int i) { return AxisVector(10 * i, i % 2 == 0 ? 0 : 5, 0); };
  pieces.begin(corner(0));
  std::size_t most = 0;
  double t = 0;
  for (int i = 0; i < 2000; ++i) {
    const AxisVector ahead = (corner(i + 1) - corner(i)).normalized();
    const AxisVector jump =
        i == 0 ? AxisVector(0, 0, 0) : AxisVector(ahead - (corner(i) - corner(i - 1)).normalized());
    pieces.add_programmed(t, corner(i), 0);
    pieces.add_mark(t, {0, {i + 1, 1, 1}, i + 1});
    pieces.add({ipo::spread_evenly(t, jump, i == 0 ? 0 : 0.1), corner(i), ahead, 0, {}});
    pieces.emit(t - 0.2);  // before the hat
    most = std::max(most, pieces.vertices().size());
    t += (corner(i + 1) - corner(i)).norm();
  }
  CHECK(out.size() > 3900);  // a line and a curve each
  CHECK(most < 200);
}
