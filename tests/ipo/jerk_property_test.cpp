// SPDX-License-Identifier: MIT
// Random programs on random machines with jerk limits: whatever they ask, the limits hold.
//
// SOFTCNC_PROGRAMS sets how many are tried: scripts/stress programs.
#include <catch2/catch.hpp>

#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

constexpr int kPrograms = 300;

struct Case {
  Machine machine;
  std::vector<Block> blocks;
};

Case case_of(unsigned seed, int moves) {
  std::mt19937 random(seed);
  const Machine machine = random_machine(random);
  return {machine, random_program(random, moves)};
}

Case random_case() {
  const auto seed = static_cast<unsigned>(integer(1, 1'000'000'000));
  Case drawn = case_of(seed, integer(1, 4));
  std::mt19937 random(seed + 1);
  vary(random, drawn.machine, drawn.blocks);
  leave_out_axes(random, drawn.machine, drawn.blocks);
  if (integer(0, 7) == 0) drawn.machine.control.period = integer(1, 2) * 2.5e-4;
  return drawn;
}

const Path& last_path(const std::vector<Block>& blocks) {
  return std::get<Move>(blocks.back().what).path;
}

}  // namespace

TEST_CASE("random programs with jerk limits keep every limit and end where they should",
          "[ipo][jerk][property]") {
  holds(
      [] {
        const auto [machine, blocks] = random_case();
        const auto result = run(machine, blocks);
        RC_ASSERT(exceeded(machine, result) == "");
        RC_ASSERT(result.rows.back().position == end(last_path(blocks)));
        RC_ASSERT(static_cast<double>(result.counts.effort.work) <=
                  4e6 * (1.5 + 1.5 * result.time));
      },
      programs_asked(kPrograms));
}

TEST_CASE("a near cusp between two nodes of a plan is seen", "[ipo][jerk]") {
  const auto [machine, blocks] = case_of(431445380, 2);
  const auto result = run(machine, blocks);
  CHECK(exceeded(machine, result) == "");
  CHECK(result.rows.back().position == end(last_path(blocks)));
}

TEST_CASE("no row between the nodes of a plan with short periods is forgotten", "[ipo][jerk]") {
  const unsigned seed = GENERATE(24830191U, 40175367U);
  auto [machine, blocks] = case_of(seed, 1);
  std::mt19937 random(seed + 1);
  vary(random, machine, blocks);
  machine.control.period = 2.5e-4;
  CHECK(exceeded(machine, run(machine, blocks)) == "");
}

TEST_CASE("a bend of less than a tenth of a micrometre is resolved where rows feel its jerk",
          "[ipo][jerk]") {
  auto [machine, blocks] = case_of(8620582, 1);
  std::mt19937 random(8620583);
  vary(random, machine, blocks);
  leave_out_axes(random, machine, blocks);
  machine.control.period = 2.5e-4;
  CHECK(exceeded(machine, run(machine, blocks)) == "");
}

TEST_CASE("a stop at any moment of a jerk-limited program ends at rest on the path",
          "[ipo][jerk][property][stop]") {
  holds(
      [] {
        const auto [machine, blocks] = random_case();
        const auto whole = run(machine, blocks);
        const int after = integer(0, static_cast<int>(whole.rows.size()) - 1);
        const auto stopped = run(machine, blocks, after);
        RC_ASSERT(exceeded(machine, stopped) == "");
        RC_ASSERT(stopped.rows.back().v == 0);
        for (std::size_t i = 0; i <= static_cast<std::size_t>(after); ++i)
          RC_ASSERT(stopped.rows[i].position == whole.rows[i].position);
      },
      programs_asked(kPrograms) / 3);
}

TEST_CASE("a stop that needs all of the way to a corner ends there, not after it",
          "[ipo][jerk][stop]") {
  // Rounding may put the sum of front and distance a trace beyond the corner.
  std::mt19937 random(633717988);
  const Machine machine = random_machine(random);
  const auto blocks = random_program(random, 1 + static_cast<int>(random() % 4));
  const auto stopped = run(machine, blocks, 12);
  CHECK(exceeded(machine, stopped) == "");
  CHECK(stopped.rows.back().s == length(std::get<Move>(blocks.front().what).path));
}

TEST_CASE("a jerk-limited plan of a random program does not depend on how it arrives",
          "[ipo][jerk][property]") {
  holds(
      [] {
        const auto [machine, blocks] = random_case();
        const auto whole = run(machine, blocks, -1, 0);
        const auto pieces = run(machine, blocks, -1, static_cast<std::size_t>(integer(1, 7)));
        RC_ASSERT(pieces.rows.size() == whole.rows.size());
        for (std::size_t i = 0; i < whole.rows.size(); ++i) {
          RC_ASSERT(pieces.rows[i].position == whole.rows[i].position);
          RC_ASSERT(pieces.rows[i].limit == whole.rows[i].limit);
        }
      },
      programs_asked(kPrograms) / 10);
}
