// SPDX-License-Identifier: MIT
#include "ipo/path/travel.hpp"

#include <catch2/catch.hpp>

namespace softcnc::ipo {

TEST_CASE("a move beyond the travel is reported with the axes that leave it", "[travel]") {
  Machine machine;
  for (Axis& axis : machine.axes) {
    axis.min = -12;
    axis.max = 12;
  }
  Move move{Line({0, 0, 0}, {13, 0, 14})};
  const auto outside = check_travel(move, machine);
  REQUIRE(outside);
  CHECK(outside->message ==
        "X reaches 13 mm, 1 mm beyond its travel from -12 to 12 mm; Z reaches 14 mm, 2 mm beyond "
        "its travel from -12 to 12 mm");
  machine.axes[2].present = false;
  CHECK(check_travel(move, machine)->message ==
        "X reaches 13 mm, 1 mm beyond its travel from -12 to 12 mm");
}

}  // namespace softcnc::ipo
