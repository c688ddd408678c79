// SPDX-License-Identifier: MIT
#include "ipo/path/travel.hpp"

#include <catch2/catch.hpp>

namespace softcnc::ipo {

TEST_CASE("nothing is told of an axis whose place an error has left open", "[travel]") {
  Machine machine;
  for (Axis& axis : machine.axes) {
    axis.min = -12;
    axis.max = 12;
  }
  Move move{Line({0, 0, 0}, {13, 0, 14})};
  REQUIRE(check_travel(move, machine));
  move.unknown_axes = 0b100;
  const auto told = check_travel(move, machine);
  REQUIRE(told);
  CHECK(told->message == "X reaches 13 mm, 1 mm beyond its travel from -12 to 12 mm");
  move.unknown_axes = 0b101;
  CHECK_FALSE(check_travel(move, machine));
}

}  // namespace softcnc::ipo
