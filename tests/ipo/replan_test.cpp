// SPDX-License-Identifier: MIT
// Override and hold while a program runs: when they take effect, what the samples say, and that
// they never break a limit or leave the path.
//
// SOFTCNC_PROGRAMS sets how many random programs are tried: scripts/stress programs.
#include <catch2/catch.hpp>

#include "support/machines.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"
#include "support/sanitized.hpp"

using namespace softcnc;
using namespace softcnc::test;
using ipo::FeedControl;

namespace {

constexpr FeedControl kGo{1, false, false}, kHold{1, true, false};

FeedControl override_of(double part) { return {part, false, false}; }

/// 1000 mm/s^2, 1 ms; with a jerk limit it takes 20 ms to get there.
Machine replan_machine(bool jerk) { return machine_with(250, 1000, jerk ? 50000 : 0); }

int rows_until(const Run& run, std::size_t from, double v) {
  std::size_t row = from;
  while (row < run.rows.size() && std::abs(run.rows[row].v - v) > 1e-3 * std::max(v, 1e-3)) ++row;
  return static_cast<int>(row - from);
}

std::vector<Block> long_line() { return polyline({{0, 0, 0}, {400, 0, 0}}, 100); }

struct RandomRun {
  Machine machine;
  AxisVector end;  // of the program
  Run run;
};

/// A random program on a random machine, with limits of jerk twice out of three times. `varied`:
/// with what is less usual. `period`: another one than the machine's, s; 0: its own.
/// `fewer_axes`: on a machine that may have two axes or one.
RandomRun run_random(unsigned seed, int moves, int control_count, bool varied = false,
                     double period = 0, bool fewer_axes = false) {
  std::mt19937 random(seed);
  Machine machine = random_machine(random);
  if (period > 0) machine.control.period = period;
  if (random() % 3 == 0)
    for (Axis& axis : machine.axes) axis.jerk = 0;
  auto blocks = random_program(random, moves);
  const Controls controls = random_controls(random, control_count);
  std::mt19937 random_variation(seed + 1);
  if (varied) vary(random_variation, machine, blocks);
  if (fewer_axes) leave_out_axes(random_variation, machine, blocks);
  return {machine, end(std::get<Move>(blocks.back().what).path), run(machine, blocks, controls)};
}

}  // namespace

TEST_CASE("a lower override slows the machine down as fast as its limits allow", "[ipo][replan]") {
  const bool jerk = GENERATE(false, true);
  CAPTURE(jerk);
  const Machine machine = replan_machine(jerk);
  const auto result = run(machine, long_line(), Controls{{1000, override_of(0.5)}});
  CHECK(exceeded(machine, result) == "");
  CHECK(result.rows[999].v == Approx(100).epsilon(1e-3));
  // From 100 to 50 mm/s in v / a, and a / j with jerk; with jerk the place is found by trying.
  CHECK(rows_until(result, 1000, 50) <= (jerk ? 110 : 52));
  CHECK(rows_until(result, 1000, 50) >= (jerk ? 65 : 49));
  CHECK(result.rows[1200].v == Approx(50).epsilon(1e-3));
  CHECK(result.rows[1200].limit == Limit::override_);
  CHECK(result.rows.back().position == AxisVector(400, 0, 0));
}

TEST_CASE("a higher override counts at once, and never above a limit of the machine",
          "[ipo][replan]") {
  const bool jerk = GENERATE(false, true);
  const Machine machine = replan_machine(jerk);
  const auto result =
      run(machine, long_line(), Controls{{500, override_of(2)}, {1200, override_of(1)}});
  CHECK(exceeded(machine, result) == "");
  CHECK(result.rows[499].v == Approx(100).epsilon(1e-3));
  CHECK(rows_until(result, 500, 200) <= (jerk ? 125 : 103));
  CHECK(result.rows[1150].v == Approx(200).epsilon(1e-3));
  CHECK(result.rows[1400].v == Approx(100).epsilon(1e-3));
  CHECK(result.rows[1400].limit == Limit::feed);
}

TEST_CASE("a hold rests on the path until it is released, and the rows name it", "[ipo][replan]") {
  const bool jerk = GENERATE(false, true);
  const bool by_override = GENERATE(false, true);
  CAPTURE(jerk, by_override);
  const Machine machine = replan_machine(jerk);
  const auto result = run(machine, long_line(),
                          Controls{{1000, by_override ? override_of(0) : kHold}, {3000, kGo}});
  const Limit name = by_override ? Limit::override_ : Limit::hold;
  CHECK(exceeded(machine, result) == "");
  CHECK(rows_until(result, 1000, 0) <= (jerk ? 160 : 103));
  for (const std::size_t row : {1010U, 1200U, 2999U}) CHECK(result.rows[row].limit == name);
  for (const std::size_t row : {1200U, 2999U}) {
    CHECK(result.rows[row].v == 0);
    CHECK(result.rows[row].position == result.rows[2000].position);
  }
  CHECK(result.rows[3010].v > 0);
  CHECK(result.rows.back().position == AxisVector(400, 0, 0));
}

TEST_CASE("an override changes neither rapids nor what is programmed without it", "[ipo][replan]") {
  const bool rapid = GENERATE(false, true);
  auto blocks = polyline({{0, 0, 0}, {400, 0, 0}}, 100, rapid);
  std::get<Move>(blocks[0].what).feed_override = rapid;
  const Machine machine = replan_machine(true);
  const auto plain = run(machine, blocks);
  const auto slowed = run(machine, blocks, Controls{{500, override_of(0.2)}});
  CHECK(exceeded(machine, slowed) == "");
  CHECK(std::abs(std::ssize(slowed.rows) - std::ssize(plain.rows)) <= 5);
}

TEST_CASE("a dwell that is held lasts as long in all", "[ipo][replan]") {
  const Machine machine = replan_machine(false);
  const auto blocks =
      number_blocks({Dwell{0.5}, Move{Line({0, 0, 0}, {10, 0, 0}), false, 100, PathMode::follow}});
  const auto plain = run(machine, blocks);
  const auto held = run(machine, blocks, Controls{{200, kHold}, {300, kGo}});
  CHECK(held.rows.size() == plain.rows.size() + 100);
  CHECK(held.rows[250].limit == Limit::hold);
}

TEST_CASE("override and hold at the same moments give the same rows however the blocks arrive",
          "[ipo][replan]") {
  const bool limits_jerk = GENERATE(true, false);
  const auto seed = static_cast<unsigned>(GENERATE(7, 8, 9));
  if (test::kSanitized && seed > 7) return;
  CAPTURE(limits_jerk, seed);
  std::mt19937 random(seed);
  const Machine machine = replan_machine(limits_jerk);
  const auto blocks = random_program(random, 12);
  const Controls controls{{300, override_of(0.4)}, {700, kHold}, {900, kGo}};
  const auto whole = run(machine, blocks, controls, 0);
  const auto pieces = run(machine, blocks, controls, 3);
  CHECK(exceeded(machine, whole) == "");
  REQUIRE(pieces.rows.size() == whole.rows.size());
  for (std::size_t i = 0; i < whole.rows.size(); ++i)
    REQUIRE(pieces.rows[i].position == whole.rows[i].position);
}

TEST_CASE("a move goes on from a rest at the end of all that had come", "[ipo][jerk][replan]") {
  const RandomRun random = run_random(324460773, 2, 2);
  CHECK(exceeded(random.machine, random.run) == "");
  CHECK(random.run.rows.back().position == random.end);
}

TEST_CASE("where slowing down takes a rest at a corner, no row cuts it", "[ipo][jerk][replan]") {
  const RandomRun random = run_random(226354267, 2, 1);
  CHECK(exceeded(random.machine, random.run) == "");
  CHECK(random.run.rows.back().position == random.end);
}

TEST_CASE("a hold that is taken back while it brakes takes no plan of countless nodes",
          "[ipo][jerk][replan]") {
  Machine machine;
  machine.control.period = 0.002;
  machine.control.chord_tolerance = 0.1;
  machine.limits.feed = 0;
  const AxisVector velocity(11.724, 6.3542, 98.15), acceleration(259.31, 270.29, 7712);
  const AxisVector jerk(35885, 978.5, 2591535);  // a curve is guessed to be as weak all along
  for (int i = 0; i < kAxes; ++i) {
    Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    axis.velocity = velocity[i];
    axis.acceleration = acceleration[i];
    axis.jerk = jerk[i];
  }
  const auto arc = [](const AxisVector& from, const AxisVector& to, const AxisVector& center) {
    return Move{Arc::make({from, to, center, Plane::xy, true, 0}).value(), false, 15.137,
                PathMode::follow};
  };
  const AxisVector middle(4.09946, 1.75021, 0), end(10.42366, 8.35402, 0);
  const auto blocks = number_blocks({arc({0, 0, 0}, {0, 0, 0}, {0.00272, 0, 0}),
                                     arc({0, 0, 0}, middle, {0, 5.67610, 0}),
                                     Move{Line(middle, end), false, 15.137, PathMode::follow}});
  const auto result = run(machine, blocks, Controls{{98, kHold}, {129, kGo}});
  CHECK(exceeded(machine, result) == "");
  CHECK(result.rows.back().position == end);
  CHECK(result.counts.effort.nodes < 100000);
}

TEST_CASE("an event takes no plan of the way that it takes back", "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  const Arc arc = Arc::make({{0, 0, 0}, {0, 0, 0}, {20, 0, 0}, Plane::xy, true, 3}).value();
  const auto blocks = number_blocks({Move{arc, false, 5, PathMode::follow}});
  const auto plain = run(machine, blocks);
  Controls controls;
  for (int i = 1; i <= 10; ++i) controls[1000 * i] = override_of(i % 2 == 0 ? 1 : 0.9);
  const auto result = run(machine, blocks, controls);
  CHECK(exceeded(machine, result) == "");
  CHECK(result.counts.effort.fallbacks == 0);
  CHECK(result.counts.effort.nodes < 2 * plain.counts.effort.nodes);
}

TEST_CASE("a hold where the machine brakes anyway is no fall-back, nor is its release",
          "[ipo][replan]") {
  const bool jerk = GENERATE(false, true);
  const int released = GENERATE(2, 500);  // samples later
  const Machine machine = replan_machine(jerk);
  const auto blocks =
      number_blocks({Move{Line({0, 0, 0}, {20, 0, 0}), false, 100, PathMode::stop},
                     Move{Line({20, 0, 0}, {40, 0, 0}), false, 100, PathMode::follow}});
  const auto plain = run(machine, blocks);
  int stop = 10;
  while (plain.rows[static_cast<std::size_t>(stop)].s < 20) ++stop;
  for (int row = stop - 60; row <= stop + 1; ++row) {
    CAPTURE(jerk, released, row);
    Controls controls{{row, kHold}};
    controls[row + released] = kGo;
    const auto result = run(machine, blocks, controls);
    CHECK(exceeded(machine, result) == "");
    CHECK(result.counts.effort.fallbacks == 0);
    CHECK(result.rows.back().position == AxisVector(40, 0, 0));
  }
}

TEST_CASE("a hold soon after the start of a long line rests soon", "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  const auto result = run(machine, long_line(), Controls{{20, kHold}, {3000, kGo}});
  CHECK(exceeded(machine, result) == "");
  CHECK(result.rows[19].v > 5);
  CHECK(result.rows[2000].v == 0);
  CHECK(result.rows[2000].s - result.rows[19].s < 1.5);
}

TEST_CASE("a higher override counts soon while the machine still slows to a very low one",
          "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  const double low = GENERATE(0.001, 0.01, 0.05);
  for (int row = 1005; row <= 1150; row += 5 * test::kPart) {
    CAPTURE(low, row);
    const auto raised = run(machine, long_line(), Controls{{1000, override_of(low)}, {row, kGo}});
    CHECK(exceeded(machine, raised) == "");
    CHECK(raised.counts.effort.fallbacks == 0);
    CHECK(raised.rows.size() < 4600);
    CHECK(raised.rows.back().position == AxisVector(400, 0, 0));
  }
}

TEST_CASE("a hold counts soon while the machine slows to a very low override",
          "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  for (int row = 1095; row <= 1130; row += test::kPart) {
    CAPTURE(row);
    const auto held =
        run(machine, long_line(),
            Controls{{1000, override_of(0.01)}, {row, {0.01, true, false}}, {1400, kGo}});
    CHECK(exceeded(machine, held) == "");
    CHECK(held.counts.effort.fallbacks == 0);
    CHECK(held.rows[1200].v == 0);
    CHECK(held.rows[1200].limit == Limit::hold);
    CHECK(held.rows.back().position == AxisVector(400, 0, 0));
  }
}

TEST_CASE("a stop is found in few tries", "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  const Arc arc = Arc::make({{0, 0, 0}, {0, 0, 0}, {10, 0, 0}, Plane::xy, true, 3}).value();
  const auto blocks = number_blocks({Move{arc, false, 80, PathMode::follow}});
  const auto plain = run(machine, blocks);
  for (const int row : {60, 300, 1000}) {
    CAPTURE(row);
    const auto result = run(machine, blocks, Controls{{row, kHold}, {row + 500, kGo}});
    CHECK(exceeded(machine, result) == "");
    CHECK(result.counts.effort.iterations < plain.counts.effort.iterations + 400);
  }
}

TEST_CASE("a speed that is rounding is none", "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  const Arc arc = Arc::make({{0, 0, 0}, {20, 0, 0}, {10, 0, 0}, Plane::xy, true, 0}).value();
  Diagnostics diagnostics;
  ipo::Planner planner(machine, 1, diagnostics);
  for (Block& block :
       number_blocks({Move{Line({-2e-7, 0, 0}, {0, 0, 0}), false, 100, PathMode::follow},
                      Move{arc, false, 100, PathMode::follow}}))
    planner.push(std::move(block));
  planner.finish();
  ipo::BlockQueue queue(10 * machine.control.period);
  while (auto part = planner.pop_part()) queue.push(std::move(*part));
  planner.replan(queue.take_rest(), {0, 1e-29, 1e-13}, 0, override_of(0.5));
  while (planner.pop()) {
  }
  CHECK(planner.counts().effort.fallbacks == 0);
  CHECK(planner.counts().effort.nodes < 10000);
}

TEST_CASE("an event at the end of a move leaves it where it ends", "[ipo][jerk][replan]") {
  const Machine machine = replan_machine(true);
  const auto blocks =
      number_blocks({Move{Line({0, 0, 0}, {20, 0, 0}), false, 100, PathMode::stop},
                     Move{Line({20, 0, 0}, {40, 0, 0}), false, 100, PathMode::follow}});
  for (int row = 318; row <= 323; ++row) {  // it takes 0.32 s
    CAPTURE(row);
    const auto result = run(machine, blocks, Controls{{row, override_of(0.5)}});
    CHECK(exceeded(machine, result) == "");
    CHECK(result.rows.size() > 700);
  }
}

TEST_CASE("a step keeps its chord where a curve bends most between two looks at it",
          "[ipo][replan]") {
  const RandomRun random = run_random(294741569, 2, 2);
  CHECK(exceeded(random.machine, random.run) == "");
}

TEST_CASE("joined chords end where the last one ends, to the bit", "[ipo][replan]") {
  const RandomRun random = run_random(381425127, 3, 1, true);
  CHECK(random.run.rows.back().position == random.end);
}

TEST_CASE("rows on a hairpin of a spline are found on it", "[ipo][replan]") {
  const RandomRun random = run_random(219071531, 2, 3, true);
  CHECK(exceeded(random.machine, random.run) == "");
}

TEST_CASE("an arc on which the machine brakes keeps its acceleration after an override as well",
          "[ipo][replan]") {
  const RandomRun random = run_random(659084377, 2, 1, true, 2.5e-4);
  CHECK(exceeded(random.machine, random.run) == "");
}

TEST_CASE("an axis keeps its velocity where an arc turns into it, however slowly it is left",
          "[ipo][replan]") {
  // The tangential limit of 190 mm/s^2 is a sixth of what the axes can do.
  const RandomRun random = run_random(74235003, 2, 1, true);
  CHECK(exceeded(random.machine, random.run) == "");
}

TEST_CASE("random holds and overrides of random programs keep every limit and the path",
          "[ipo][jerk][property][replan]") {
  holds(
      [] {
        const auto seed = static_cast<unsigned>(integer(1, 1'000'000'000));
        const int moves = integer(1, 4);
        const double period = integer(0, 7) == 0 ? integer(1, 2) * 2.5e-4 : 0;
        const RandomRun random = run_random(seed, moves, integer(1, 5), true, period, true);
        RC_ASSERT(exceeded(random.machine, random.run) == "");
        RC_ASSERT(random.run.rows.back().position == random.end);
        RC_ASSERT(random.run.rows.back().v == 0);
      },
      programs_asked(50));
}
