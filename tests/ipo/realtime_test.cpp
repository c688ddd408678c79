// SPDX-License-Identifier: MIT
// What runs every period allocates nothing, whatever the method.
#include <catch2/catch.hpp>

#include "support/allocations.hpp"
#include "support/curves.hpp"
#include "support/run.hpp"

using namespace softcnc;

TEST_CASE("a period of interpolation allocates nothing", "[interpolator][realtime]") {
  Machine machine;
  machine.control.interpolation = static_cast<Method>(GENERATE(range(0, int(Method::sam))));
  CAPTURE(name(machine.control.interpolation));
  Diagnostics diagnostics;
  ipo::Planner planner(machine, 1, diagnostics);
  for (const Block& block : test::number_blocks(
           {Move{test::curve("butterfly"), false, 100, PathMode::follow}, Dwell{0.1},
            Move{Line({54.492, 52.139, 0}, {0, 0, 0}), true, 0, PathMode::follow}}))
    planner.push(block);
  planner.finish();
  ipo::BlockQueue queue(1, 1);
  while (auto timed = planner.pop()) queue.push(std::move(*timed));
  ipo::Interpolator interpolator(queue, machine);
  int rows = 0;
  CHECK(test::allocations_during([&] {
          while (interpolator.step()) ++rows;
        }) == 0);
  CHECK(rows > 1000);
}
