// SPDX-License-Identifier: MIT
// G28 and G30, against LinuxCNC's rs274.
#include <catch2/catch.hpp>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

std::vector<AxisVector> places_of(const std::string& program, InterpreterOptions options = {}) {
  std::vector<AxisVector> all;
  for (const Move& move : moves_of(program + "M30\n", {}, options)) {
    CHECK(move.rapid);
    all.push_back(end(move.path));
  }
  return all;
}

}  // namespace

TEST_CASE("G28 goes by way of the point given, in the axes named", "[ipr][reference]") {
  CHECK(places_of("G00 X5 Y6 Z7\nG28 Z10\n") == Ends{{5, 6, 7}, {5, 6, 10}, {5, 6, 0}});
  CHECK(places_of("G00 X5 Y6 Z7\nG91 G28 Z0\n") == Ends{{5, 6, 7}, {5, 6, 0}});
  CHECK(places_of("G00 X5 Y6 Z7\nG91 G28 X0 Y1\n") == Ends{{5, 6, 7}, {5, 7, 7}, {0, 0, 7}});
  CHECK(places_of("G00 X5 Y6 Z7\nG28\n") == Ends{{5, 6, 7}, {0, 0, 0}});
}

TEST_CASE("G28 leaves the motion in force as it was", "[ipr][reference]") {
  CHECK(places_of("G00 X1 Y1\nG28 X2\nX3 Y3\n") ==
        Ends{{1, 1, 0}, {2, 1, 0}, {0, 1, 0}, {3, 3, 0}});
  CHECK(places(interpret("G28\nX5\nM30\n")) == Places{"SC2101 2:1"});
}

TEST_CASE("G28.1 and G30.1 keep the position in machine coordinates", "[ipr][reference]") {
  CHECK(places_of("G10 L2 P1 Z20\nG00 Z7\nG28.1\nZ0\nG10 L2 P1 Z0\nG28\n") ==
        Ends{{0, 0, 27}, {0, 0, 20}, {0, 0, 27}});
  CHECK(places_of("G00 Z7\nG30.1\nZ0\nG28 Z0\nG30 Z1\n") ==
        Ends{{0, 0, 7}, {0, 0, 0}, {0, 0, 1}, {0, 0, 7}});
  const Interpreted result = interpret("G00 X1 Y2\nG28.1\nX3\nG30.1\nM30\n");
  CHECK(result.state.home == AxisVector(1, 2, 0));
  CHECK(result.state.second_home == AxisVector(3, 2, 0));
}

TEST_CASE("in a turned work system the axes named are the program's", "[ipr][reference]") {
  const std::string start = "G10 L2 P1 X10 Y20 R90\nG00 X5 Y6 Z7\nG28.1\nX0 Y0\n";
  const auto one = places_of(start + "G28 X1\n");
  REQUIRE(one.size() == 4);
  CHECK(near(one[0], {4, 25, 7}));
  CHECK(near(one[2], {10, 21, 7}));
  CHECK(near(one[3], {10, 25, 7}));
  CHECK(near(places_of(start + "G28\n").back(), {4, 25, 7}));
}

TEST_CASE("after G40 the tool goes home from where it is", "[ipr][reference]") {
  const std::string contour = "F100 G00 X-20\nG41.1 D10 G01 X0 Y0\nX20\nG40\n";
  const auto across = moves_of(contour + "G91 G28 Z5\nM30\n");
  CHECK(near(end(across[across.size() - 2].path), {20, 5, 5}));
  CHECK(near(end(across.back().path), {20, 5, 0}));
  CHECK(near(start(moves_of(contour + "G28\nM30\n").back().path), {20, 5, 0}));
}

TEST_CASE("axes that the machine lacks do not go home", "[ipr][reference]") {
  Machine machine;
  machine.axes[2].present = false;
  CHECK(last_place("G00 X5\nG28\nM30\n", {}, machine) == AxisVector(0, 0, 0));
}

TEST_CASE("in the fanuc dialect G30 takes P2", "[ipr][reference][fanuc]") {
  CHECK(places_of("G00 Z7\nG30.1\nZ0\nG91 G30 P2 Z0\n", kFanuc) ==
        Ends{{0, 0, 7}, {0, 0, 0}, {0, 0, 7}});
  CHECK(places(interpret("G30 P2 Z0\nM30\n")) == Places{"SC2004 1:5"});
}

TEST_CASE("in the fanuc dialect all axes go home where none is named", "[ipr][reference][fanuc]") {
  CHECK(places_of("G00 X5 Y6 Z7\nG28\n", kFanuc) == Ends{{5, 6, 7}, {0, 0, 0}});
  CHECK(places_of("G00 X5 Y6 Z7\nG30.1\nX0\nG91 G30\n", kFanuc) ==
        Ends{{5, 6, 7}, {0, 6, 7}, {5, 6, 7}});
  CHECK(places_of("G00 X5 Y6 Z7\nG30 P2\n", kFanuc) == Ends{{5, 6, 7}, {0, 0, 0}});
}

TEST_CASE("in the fanuc dialect G30 P3 and P4 lead to places of the state",
          "[ipr][reference][fanuc]") {
  MachineState state;
  state.further_homes = {AxisVector(1, 2, 3), AxisVector(4, 5, 6)};
  Reader reader = Reader::from_text("G91 G30 P3 Z1\nG30 P4\nG28 X0\nM30\n");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, kFanuc, state);
  Ends all;
  while (auto block = interpreter.next())
    if (const auto* move = std::get_if<Move>(&block->what)) all.push_back(end(move->path));
  CHECK(diagnostics.all().empty());
  CHECK(all == Ends{{0, 0, 1}, {0, 0, 3}, {4, 5, 6}, {0, 5, 6}});
  CHECK(places(interpret("G30 P3\nG00 X0 Y0 Z0\nG30 P4\nX0 Y0 Z0\nG30 P5\nM30\n", {}, kFanuc)) ==
        Places{"SC2260 1:5", "SC2260 3:5", "SC2007 5:5"});
}

TEST_CASE("in the fanuc dialect G00 and G01 beside G28 are in force after it",
          "[ipr][reference][fanuc]") {
  CHECK(places_of("G0 X3 Y4 Z5\nG00 G91 G28 Z0.\nG90 X7\n", kFanuc) ==
        Ends{{3, 4, 5}, {3, 4, 0}, {7, 4, 0}});
  const auto moves = moves_of("F60 G0 X3 Y4\nG1 G30 X2 Y2\nX9\nM30\n", {}, kFanuc);
  REQUIRE(moves.size() == 4);
  CHECK((moves[1].rapid && moves[2].rapid && !moves[3].rapid));
  CHECK(near(end(moves[2].path), {0, 0, 0}));
  CHECK(near(end(moves[3].path), {9, 0, 0}));
  CHECK(places(interpret("G0 G28 X0 Y0\nM30\n")) == Places{"SC2110 1:1"});
  CHECK(places(interpret("F9\nG2 G28 X0 Y0\nM30\n", {}, kFanuc)) == Places{"SC2110 2:1"});
  CHECK(places(interpret("F9\nG92 X0 G0 Y0\nM30\n", {}, kFanuc)) == Places{"SC2110 2:8"});
}

}  // namespace softcnc::ipr
