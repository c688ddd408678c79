// SPDX-License-Identifier: MIT
// Curves of thousands of spans, planned a stretch at a time: the same path, as fast, within every
// limit, whatever is asked of the feed meanwhile, and in little memory.
#include "ipo/path/long_curve.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "ipo/tuning.hpp"
#include "motion/geometry/spline.hpp"
#include "support/machines.hpp"
#include "support/run.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::test;
using ipo::FeedControl;

namespace {

Nurbs wave(int points) {
  std::vector<AxisVector> through;
  for (int i = 0; i <= points; ++i) through.emplace_back(0.1 * i, 5 * std::sin(0.3 * i), 0);
  return Nurbs::make(cubic_spline(through).value()).value();
}

Move along(Nurbs curve) { return {Path(std::move(curve)), false, 60, PathMode::stop}; }

std::vector<Block> between_lines(const Nurbs& curve) {
  const AxisVector end = curve.position(curve.length());
  return number_blocks({Move{Line(AxisVector(-5, 0, 0), AxisVector::Zero()), false, 60},
                        Move{Path(curve), false, 60},
                        Move{Line(end, end + AxisVector(0, 0, 5)), false, 60}});
}

}  // namespace

TEST_CASE("the stretches of a long curve are all of it, end to end", "[ipo][long_curve]") {
  const ipo::Piece curve{{along(wave(1500)), {7, 1, 1}, 3}, {}, 0.25};
  const Path& whole = std::get<Move>(curve.block.what).path;
  REQUIRE(ipo::is_long_curve(curve));
  double begin = 0, sum = 0;
  AxisVector reached = start(whole), direction = at(whole, 0).dq;
  int count = 0;
  while (begin < length(whole)) {
    const ipo::Piece part = ipo::next_stretch(curve, begin);
    const Move& move = std::get<Move>(part.block.what);
    CHECK(breaks(move.path).size() <= 2 * ipo::tuning::path::kSpansOfPart);
    CHECK(start(move.path) == reached);
    CHECK((at(move.path, 0).dq - direction).norm() < 1e-9);
    CHECK(part.block.source.line == 7);
    CHECK(part.block.number == 3);
    CHECK(part.deviation == 0.25);
    for (const double where : {0.1, 0.5, 0.9})
      CHECK((position(move.path, where * length(move.path)) -
             position(whole, sum + where * length(move.path)))
                .norm() < 1e-9);
    sum += length(move.path);
    CHECK(std::abs(sum - begin) < 1e-8);
    CHECK((move.path_mode == PathMode::stop) == (begin >= length(whole)));
    reached = end(move.path);
    direction = at(move.path, length(move.path), Side::before).dq;
    ++count;
  }
  CHECK(reached == end(whole));
  CHECK(count == 11);
  CHECK_FALSE(ipo::is_long_curve({{along(wave(500)), {}, 1}, {}, 0}));
}

TEST_CASE("a long curve takes as long in stretches as in one plan", "[ipo][long_curve]") {
  const double jerk = GENERATE(0.0, 50'000.0);
  CAPTURE(jerk);
  const auto blocks = between_lines(wave(700));
  Machine machine = machine_with(250, 1000, jerk);
  const Run in_stretches = run(machine, blocks);
  machine.control.interpolation = Method::taylor2;  // which is planned as a whole
  const Run as_a_whole = run(machine, blocks);
  CHECK(in_stretches.time == Approx(as_a_whole.time).epsilon(jerk > 0 ? 1e-3 : 1e-5));
  CHECK(exceeded(machine_with(250, 1000, jerk), in_stretches) == "");
  CHECK(in_stretches.rows.back().position == end(std::get<Move>(blocks.back().what).path));
  CHECK(in_stretches.rows.size() > 1000);
  // Nowhere on the curve does the tool rest where one stretch ends.
  for (const Setpoint& row : in_stretches.rows)
    if (row.block == 2 && row.s > 10 && row.s < length(std::get<Move>(blocks[1].what).path) - 5)
      REQUIRE(row.v > 1);
}

TEST_CASE("whatever is asked of the feed on a long curve keeps the limits, and the end is reached",
          "[ipo][long_curve]") {
  const double jerk = GENERATE(0.0, 50'000.0);
  CAPTURE(jerk);
  const Machine machine = machine_with(250, 1000, jerk);
  const auto blocks = between_lines(wave(kSanitized ? 700 : 1100));
  const FeedControl half{0.5, false, false}, hold{1, true, false}, full{1, false, false};
  const Run result = run(
      machine, blocks,
      Controls{
          {300, half}, {2'000, full}, {4'000, hold}, {5'000, full}, {9'000, half}, {9'100, full}});
  CHECK(exceeded(machine, result) == "");
  CHECK(result.rows.back().position == end(std::get<Move>(blocks.back().what).path));
  const Run stopped = run(machine, blocks, 3'000);
  CHECK(exceeded(machine, stopped) == "");
  CHECK(stopped.rows.back().v == 0);
  CHECK(stopped.rows.size() < 3'500);
}
