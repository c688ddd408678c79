// SPDX-License-Identifier: MIT
// Methods that ignore the plan, on random programs: they end where the program ends, stay among its
// positions, and give the same samples however its blocks arrive.
#include <catch2/catch.hpp>

#include "motion/geometry/extent.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

Extent extent_of(const std::vector<Block>& blocks) {
  Extent all = bounds(std::get<Move>(blocks.front().what).path);
  for (const Block& block : blocks)
    if (const Move* move = std::get_if<Move>(&block.what)) {
      const Extent box = bounds(move->path);
      all.min = all.min.cwiseMin(box.min);
      all.max = all.max.cwiseMax(box.max);
    }
  return all;
}

AxisVector end_of(const std::vector<Block>& blocks) {
  AxisVector at = AxisVector::Zero();
  for (const Block& block : blocks)
    if (const Move* move = std::get_if<Move>(&block.what)) at = end(move->path);
  return at;
}

Machine unplanned_machine(std::mt19937& random) {
  Machine machine = random_machine(random);
  machine.control.backend = BackendKind::none;
  machine.control.interpolation = static_cast<Method>(
      integer(static_cast<int>(Method::chords), static_cast<int>(Method::two_step)));
  machine.control.acc_dec = 1e-3 * integer(1, 200);
  machine.control.rough_period = machine.control.period * integer(1, 10);
  return machine;
}

}  // namespace

TEST_CASE("methods without a plan run random programs to their end", "[methods][property]") {
  holds(
      [] {
        std::mt19937 random(static_cast<unsigned>(integer(1, 1'000'000'000)));
        const Machine machine = unplanned_machine(random);
        auto blocks = random_program(random, integer(1, 6));
        const bool moves = std::holds_alternative<Move>(blocks.front().what);
        const auto run = test::run(machine, blocks, Controls{}, 1);
        RC_ASSERT(run.rows.back().position == end_of(blocks));
        RC_ASSERT(run.rows.back().v == 0);
        if (!moves) return;
        const Extent box = extent_of(blocks);
        for (const Setpoint& row : run.rows) {
          RC_ASSERT((row.position - box.min).minCoeff() > -1e-9);
          RC_ASSERT((box.max - row.position).minCoeff() > -1e-9);
        }
        const auto apart = test::run(machine, blocks, Controls{}, kSlowly);
        RC_ASSERT(apart.rows.size() == run.rows.size());
        for (std::size_t i = 0; i < run.rows.size(); ++i) {
          RC_ASSERT(apart.rows[i].position == run.rows[i].position);
          RC_ASSERT(apart.rows[i].block == run.rows[i].block);
        }
      },
      100);
}

TEST_CASE("methods without a plan take override, hold and resume anywhere", "[methods][property]") {
  holds(
      [] {
        std::mt19937 random(static_cast<unsigned>(integer(1, 1'000'000'000)));
        const Machine machine = unplanned_machine(random);
        const auto blocks = random_program(random, integer(1, 6));
        Controls controls;
        const int first = integer(1, 200), second = first + integer(1, 200);
        controls[first] = {0.01 * integer(0, 200), integer(0, 2) == 0, false};
        controls[second] = {0.01 * integer(1, 200), false, false};
        if (integer(0, 3) == 0) controls[second + integer(1, 100)] = {1, false, true};
        const auto run = test::run(machine, blocks, controls);
        RC_ASSERT(run.rows.back().v == 0);
        const bool stopped = controls.size() == 3;
        if (!stopped) RC_ASSERT(run.rows.back().position == end_of(blocks));
      },
      200);
}
