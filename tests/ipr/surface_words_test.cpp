// SPDX-License-Identifier: MIT
// G06.4 and G06.5: the roughness asked for, and when it is not any more.
#include <catch2/catch.hpp>

#include "ipr/curves.hpp"

namespace softcnc::ipr {
namespace {

std::vector<Move> moves_at_speed(const std::string& program, const Machine& machine = {}) {
  Interpreted result = interpret("S6000 M03\n" + program, machine);
  CHECK(places(result) == Places{});
  std::vector<Move> moves;
  for (Block& block : result.blocks)
    if (auto* move = std::get_if<Move>(&block.what)) moves.push_back(std::move(*move));
  return moves;
}

Machine with_tool() {
  Machine machine;
  machine.tools[3] = {5, 2};
  machine.tools[4] = {0, 3};
  return machine;
}

}  // namespace

TEST_CASE("G06.4 holds for cutting moves until G06.5", "[ipr][surface]") {
  const auto moves = moves_at_speed(
      "F600 G01 X1\nG06.4 D5 J.5 H10 L2\nX2\nG00 X3\nG02 X5 I1\nG06.4 D6 J.25 H7 L3\nG01 X6\n"
      "G06.5 X7\nM30\n");
  CHECK_FALSE(moves[0].surface);
  REQUIRE(moves[1].surface);
  CHECK(moves[1].surface->tool_radius == 5);
  CHECK(moves[1].surface->pick_feed == 0.5);
  CHECK(moves[1].surface->rmax == Approx(0.010));
  CHECK(moves[1].surface->teeth == 2);
  CHECK_FALSE(moves[2].surface);  // a rapid
  CHECK(moves[3].surface);
  REQUIRE(moves[4].surface);
  CHECK(moves[4].surface->teeth == 3);
  CHECK_FALSE(moves[5].surface);
}

TEST_CASE("D and J are in program units, H in um always", "[ipr][surface]") {
  const auto moves = moves_at_speed("G20 F60 G06.4 D.25 J.02 H10 L2 G01 X1\nM30\n");
  REQUIRE(moves[0].surface);
  CHECK(moves[0].surface->tool_radius == Approx(6.35));
  CHECK(moves[0].surface->pick_feed == Approx(0.508));
  CHECK(moves[0].surface->rmax == Approx(0.010));
}

TEST_CASE("R bends the surface across the feed, in program units", "[ipr][surface]") {
  const auto moves = moves_at_speed(
      "F600 G06.4 D5 J.5 H10 L2\nG01 X1\nG06.4 D5 J.5 H10 L2 R20\nX2\nG06.4 D5 J.5 H10 L2 R-20\n"
      "X3\nG20 G06.4 D.2 J.02 H10 L2 R1\nX4\nG21 G06.5\nM30\n");
  CHECK(moves[0].surface->transverse_curvature == 0);
  CHECK(moves[1].surface->transverse_curvature == Approx(0.05));
  CHECK(moves[2].surface->transverse_curvature == Approx(-0.05));
  CHECK(moves[3].surface->transverse_curvature == Approx(1 / 25.4));
  // On a hill the passes may leave what they could not on a flat surface.
  CHECK(places(interpret("G06.4 D5 J.5 H6 L2\nM30\n")) == Places{"SC3126 1:14"});
  CHECK(places(interpret("G06.4 D5 J.5 H6 L2 R20\nM30\n")) == Places{});
}

TEST_CASE("Q is the largest slope across the feed, in degrees", "[ipr][surface]") {
  const auto moves = moves_at_speed(
      "F600 G06.4 D5 J.5 H10 L2\nG01 X1\nG06.4 D5 J.5 H10 L2 Q20\nX2\nG20 G06.4 D.2 J.02 H10 L2 "
      "Q5 R-1\nX3\nG21 G06.4 D5 J.5 H10 L2 Q0\nX80\nG06.5\nM30\n");
  CHECK(moves[0].surface->slope_across == 0);
  CHECK(moves[1].surface->slope_across == Approx(20 * 3.14159265 / 180));
  CHECK(moves[2].surface->slope_across == Approx(5 * 3.14159265 / 180));
  CHECK(moves[3].surface->slope_across == 0);
  CHECK(places(interpret("G06.4 D5 J.5 H10 L2 Q90\nM30\n")) == Places{"SC3124 1:21"});
  CHECK(places(interpret("G06.4 D5 J.5 H10 L2 Q-1\nM30\n")) == Places{"SC3124 1:21"});
}

TEST_CASE("what is out of reach is what lies over the chord of the ball, on its slope too",
          "[ipr][surface]") {
  // 5 - sqrt(25 - 1/16) mm are 6.2539 um; 0.5^2 / 8 5 would be 6.25.
  CHECK(places(interpret("G06.4 D5 J.5 H6.2538 L2\nM30\n")) == Places{"SC3126 1:14"});
  CHECK(places(interpret("S600 M03 G06.4 D5 J.5 H6.28 L2\nM30\n")) == Places{});
  // A ball of 1 mm, passes 1.6 mm apart: 0.4 mm, not 0.32.
  CHECK(places(interpret("G06.4 D1 J1.6 H399.9 L2\nM30\n")) == Places{"SC3126 1:15"});
  CHECK(places(interpret("G06.4 D1 J1.6 H401 L2\nM30\n")) == Places{});
  // At 60 degrees passes 0.5 mm apart from above are 1 mm apart: 25.06 um.
  CHECK(places(interpret("G06.4 D5 J.5 H25 L2 Q60\nM30\n")) == Places{"SC3126 1:14"});
  CHECK(places(interpret("G06.4 D5 J.5 H25.5 L2 Q60\nM30\n")) == Places{});
  CHECK(places(interpret("G06.4 D5 J6 H1000 L2 Q60\nM30\n")) == Places{"SC3124 1:22"});
}

TEST_CASE("how far passes lie apart is judged without what it does not depend on",
          "[ipr][surface]") {
  CHECK(places(interpret("G06.4 D1 J5 H5\nM30\n")) == Places{"SC3125 1:1"});
  CHECK(places(interpret("G06.4 D1 J5 H5 L2 Q95\nM30\n")) == Places{"SC3124 1:10"});
}

TEST_CASE("in the first block of a NURBS R is the weight", "[ipr][surface]") {
  const auto moves = moves_at_speed("F600 G06.2 P2 K0 X0 D5 J.5 H10 L2 R2\nK0 X1\nK1\nK1\nM30\n");
  REQUIRE(moves[0].surface);
  CHECK(moves[0].surface->transverse_curvature == 0);
}

TEST_CASE("radius and teeth left out are those of the tool in the spindle", "[ipr][surface]") {
  const auto moves =
      moves_at_speed("T3 M06\nM03\nT4 F600 G06.4 J.5 H10\nG01 X1\nM30\n", with_tool());
  REQUIRE(moves[0].surface);
  CHECK(moves[0].surface->tool_radius == 5);
  CHECK(moves[0].surface->teeth == 2);
  CHECK(places(interpret("T4 M06\nG06.4 J.5 H10\nM30\n", with_tool())) == Places{"SC3125 2:1"});
  CHECK(places(interpret("G06.4 J.5 H10 L2\nM30\n", with_tool())) == Places{"SC3125 1:1"});
}

TEST_CASE("a tool change ends what was asked for", "[ipr][surface]") {
  const auto moves =
      moves_at_speed("F600 G06.4 D5 J.5 H10 L2\nG01 X1\nT3 M06\nX2\nM30\n", with_tool());
  CHECK(moves[0].surface);
  CHECK_FALSE(moves[1].surface);
}

TEST_CASE("the words in the first block of a G06.2 mean G06.4 before it", "[ipr][surface]") {
  const auto moves =
      moves_at_speed("F600 G06.2 P2 K0 X0 D5 J.5 H10 L2\nK0 X1\nK1\nK1\nG01 X2\nM30\n");
  REQUIRE(moves[0].surface);
  CHECK(moves[0].surface->pick_feed == 0.5);
  CHECK(moves[1].surface);
}

TEST_CASE("curves over several lines carry the roughness in force", "[ipr][surface]") {
  for (const char* curve : {"G06.1 X1\nX2 Y1\nG80\n", "G05.2 X1 Y0 P1\nX2 Y1 P1\nG05.3\n"}) {
    const auto moves = moves_at_speed(std::string("F600 G06.4 D5 J.5 H10 L2\n") + curve + "M30\n");
    CHECK(moves[0].surface);
  }
}

TEST_CASE("J0.5E10.7 is no number", "[ipr][surface]") {
  CHECK(places(interpret("G06.4 D5 J0.5E10.7 L2\nM30\n")) == Places{"SC1006 1:10"});
}

TEST_CASE("what is refused leaves no roughness in force", "[ipr][surface]") {
  const Interpreted result =
      interpret("F600 G06.4 D5 J.5 H10 L2\nG06.4 D5 J.5 H6 L2\nG01 X1\nM30\n");
  CHECK(places(result) == Places{"SC3126 2:14"});
  CHECK_FALSE(std::get<Move>(result.blocks[0].what).surface);
}

TEST_CASE("a move knows the speed of the spindle under it", "[ipr][surface]") {
  const auto moves = moves_at_speed(
      "F600 G06.4 D5 J.5 H10 L2\nG01 X1\nS3000 X2\nM04 X3\nG06.2 P2 K0 X3\nK0 X4\nK1\nK1\nM30\n");
  REQUIRE(moves.size() == 4);
  CHECK(moves[0].surface->spindle == 100);
  CHECK(moves[1].surface->spindle == 50);
  CHECK(moves[2].surface->spindle == 50);
  CHECK(moves[3].surface->spindle == 50);
  CHECK(moves[3].surface->tooth_rate() == 100);
}

TEST_CASE("a spindle at rest is reported once a G06.4, and no cut is made", "[ipr][surface]") {
  const Interpreted result = interpret("F600 G06.4 D5 J.5 H10 L2\nG01 X1\nX2\nG00 X3\nM30\n");
  CHECK(places(result) == Places{"SC3128 2:1"});
  CHECK(result.diagnostics.front().message ==
        "a roughness is asked for, and the spindle does not turn: S is not set");
  CHECK(std::get<Move>(result.blocks[0].what).rapid);
}

TEST_CASE("an S that is wrong is not reported again by what needs it", "[ipr][surface]") {
  const Interpreted result = interpret("S-5 M03\nF600 G06.4 D5 J.5 H10 L2\nG01 X1\nM30\n");
  CHECK(places(result) == Places{"SC2007 1:1"});
}

TEST_CASE("the model of the machine decides whether teeth would rub", "[ipr][surface]") {
  const std::string program = "S6000 M03 F600\nG06.4 D5 J.5 H6.25393 L2\nG01 X1\nM30\n";
  CHECK(places(interpret(program)) == Places{"SC3129 2:14"});
  Machine machine;
  machine.surfacing.model = RoughnessModel::paper;
  CHECK(places(interpret(program, machine)) == Places{});
}

}  // namespace softcnc::ipr
