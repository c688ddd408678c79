// SPDX-License-Identifier: MIT
// G00, G01, G80.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

TEST_CASE("G00 and G01 lead straight to the point named", "[ipr][moves]") {
  const auto moves = moves_of("G00 X1 Y2 Z3\nG01 X4 F600\nY-5\nM30\n");
  REQUIRE(moves.size() == 3);
  CHECK(moves[0].rapid);
  CHECK(end(moves[0].path) == AxisVector(1, 2, 3));
  CHECK_FALSE(moves[1].rapid);
  CHECK(start(moves[1].path) == AxisVector(1, 2, 3));
  CHECK(end(moves[1].path) == AxisVector(4, 2, 3));
  CHECK(moves[1].feed == 10.0);
  CHECK(end(moves[2].path) == AxisVector(4, -5, 3));
}

TEST_CASE("a move to where the machine stands is no block", "[ipr][moves]") {
  CHECK(moves_of("G00 X0 Y0\nG01 X1 F100\nX1\nG00 X1.\nM30\n").size() == 1);
}

TEST_CASE("rounding of summed distances makes no move", "[ipr][moves]") {
  const auto moves = moves_of("G91 F100\nG01 X.1\nX.2\nX-.3\nG90 X0\nX1\nM30\n");
  REQUIRE(moves.size() == 4);
  CHECK(start(moves[3].path) == end(moves[2].path));
}

TEST_CASE("a code alone on a line moves nothing and stays in force", "[ipr][moves]") {
  const auto moves = moves_of("G01 F100\nG02\nG01\nX1\nM30\n");
  REQUIRE(moves.size() == 1);
  CHECK(std::holds_alternative<softcnc::Line>(moves[0].path));
}

TEST_CASE("after G80 no motion is in force, unless it stands beside one", "[ipr][moves]") {
  CHECK(moves_of("G80 G00 X1\nX2\nM30\n").size() == 2);
  CHECK(places(interpret("G00 X1\nG80\nX2\nM30\n")) == Places{"SC2101 3:1"});
}

}  // namespace softcnc::ipr
