// SPDX-License-Identifier: MIT
// Units, distances, path control, feed.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {

TEST_CASE("the start state is mm and absolute", "[ipr][modes]") {
  const auto moves = moves_of("G00 X1\nX1 Y1\nM30\n");
  CHECK(end(moves[1].path) == AxisVector(1, 1, 0));
  CHECK(moves[1].path_mode == PathMode::follow);
}

TEST_CASE("inches count for every word of their line, F too", "[ipr][modes]") {
  const auto moves = moves_of("G01 X1 F60 G20\nG21 X0 F60\nM30\n");
  CHECK(end(moves[0].path).x() == 25.4);
  CHECK(moves[0].feed == 25.4);
  CHECK(end(moves[1].path).x() == 0);
  CHECK(moves[1].feed == 1.0);
}

TEST_CASE("a feed keeps its speed when units change", "[ipr][modes]") {
  const auto moves = moves_of("G20 F60\nG21 G01 X1\nM30\n");
  CHECK(moves[0].feed == 25.4);
}

TEST_CASE("G91 adds to the position, G90 does not", "[ipr][modes]") {
  const auto moves = moves_of("G91 G00 X1 Y1\nX1\nG90 X1 Z5\nM30\n");
  CHECK(end(moves[1].path) == AxisVector(2, 1, 0));
  CHECK(end(moves[2].path) == AxisVector(1, 1, 5));
}

TEST_CASE("in the fanuc dialect G61 stops at every end", "[ipr][modes][fanuc]") {
  const auto moves = moves_of("G61 G00 X1\nX2\nG64 X3\nM30\n", {}, {.dialect = Dialect::fanuc});
  CHECK(moves[0].path_mode == PathMode::stop);
  CHECK(moves[1].path_mode == PathMode::stop);
  CHECK(moves[2].path_mode == PathMode::follow);
}

TEST_CASE("G61.1 stops at every end, G61 and G64 follow the path", "[ipr][modes]") {
  const auto moves = moves_of("G00 X1\nG61.1 X2\nX3\nG61 X4\nG61.1\nG64 X5\nM30\n");
  CHECK(moves[0].path_mode == PathMode::follow);
  CHECK(moves[1].path_mode == PathMode::stop);
  CHECK(moves[2].path_mode == PathMode::stop);
  CHECK(moves[3].path_mode == PathMode::follow);
  CHECK(moves[4].path_mode == PathMode::follow);
}

TEST_CASE("a feed above the limit is held at it, with one warning a file", "[ipr][modes]") {
  Machine machine;
  machine.limits.feed = 50;
  const Interpreted result = interpret("F6000\nG01 X1\nF9000 X2\nF600 X3\nM30\n", machine);
  CHECK(places(result) == Places{"SC2201 1:1"});
  CHECK(std::get<Move>(result.blocks[0].what).feed == 50);
  CHECK(std::get<Move>(result.blocks[1].what).feed == 50);
  CHECK(std::get<Move>(result.blocks[2].what).feed == 10);
  const auto message = [&](const std::string& program) {
    return interpret(program, machine).diagnostics.front().message;
  };
  const std::string held = " exceeds the machine's 3000 mm/min; 3000 is used from here on";
  CHECK(message("F6000\nM30\n") == "F6000" + held);
  CHECK(message("G20 F200\nM30\n") == "F200, 5080 mm/min," + held);
  CHECK(message("G93 G01 X1000 F9\nM30\n") == "a feed of 9000 mm/min" + held);
  machine.limits.feed = 0;
  CHECK(places(interpret("F900000\nM30\n", machine)).empty());
}

TEST_CASE("G64 takes its tolerances in the units in force", "[ipr][modes]") {
  Machine machine;
  machine.control.corner_tolerance = 0.25;
  const auto moves = moves_of(
      "G00 X1\nG64 P0.5\nX2\nG64 P0.5 Q0.125\nX3\nG20 G64 P1\nX4\nG61\nX5\nG64 X6\nG64 Q1\nX7\n"
      "G61.1\nX8\nM30\n",
      machine);
  const auto check = [&](std::size_t move, double corner, double chord) {
    INFO("move " << move);
    CHECK(moves[move].corner_tolerance == corner);
    CHECK(moves[move].chord_tolerance == chord);
  };
  check(0, 0.25, 0.25);
  check(1, 0.5, 0.5);
  check(2, 0.5, 0.125);
  check(3, 25.4, 25.4);
  check(4, 0, 0);
  check(5, 0.25, 0.25);
  check(6, 0.25, 25.4);
  check(7, 0, 0);
  CHECK(moves[7].path_mode == PathMode::stop);
}

TEST_CASE("codes of other controls ask for smoothing within a tolerance", "[ipr][modes]") {
  Machine machine;
  machine.control.corner_tolerance = 0.25;
  machine.control.smoothing_tolerance = 0.5;
  const auto tolerances = [&](const std::string& program, const InterpreterOptions& options) {
    const Interpreted read = interpret(program, machine, options);
    CHECK(places(read).empty());
    std::vector<double> found;
    for (const Block& block : read.blocks)
      if (const Move* move = std::get_if<Move>(&block.what)) {
        CHECK(move->corner_tolerance == move->chord_tolerance);
        found.push_back(move->corner_tolerance);
      }
    return found;
  };
  using Tolerances = std::vector<double>;
  CHECK(tolerances("G01 X1. F600.\nG05.1 Q1\nX2.\nG05.1 Q0\nX3.\nM30\n", kFanuc) ==
        Tolerances{0.25, 0.5, 0.25});
  CHECK(tolerances("G01 X1. F600.\nG187 E0.1\nX2.\nG187 P1\nX3.\nG187\nX4.\nM30\n", kHaas) ==
        Tolerances{0.25, 0.1, 0.5, 0.25});
  CHECK(tolerances("G20 G01 X1. F60.\nG187 P3 E0.1\nX2.\nM30\n", kHaas) == Tolerances{0.25, 2.54});
  // What is followed exactly stays so.
  CHECK(tolerances("G61 G01 X1. F600.\nG187 E0.1\nX2.\nM30\n", kHaas) == Tolerances{0, 0});
  CHECK(tolerances("G61 G01 X1. F600.\nG05.1 Q1\nX2.\nM30\n", kFanuc) == Tolerances{0, 0});
  CHECK(places(interpret("G187 E-1.\nM30\n", machine, kHaas)) == Places{"SC2007 1:6"});
  CHECK(places(interpret("G187 P4\nM30\n", machine, kHaas)) == Places{"SC2007 1:6"});
}

TEST_CASE("R of G64 has no effect, which is noted once", "[ipr][modes]") {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc}) {
    const auto read =
        interpret("F100\nG64 P0.01 R0.5\nG64 P0.2 R1.\nG01 X1.\nM30\n", {}, {.dialect = dialect});
    CHECK(places(read) == Places{"SC2170 2:11"});
    CHECK(std::get<Move>(read.blocks[0].what).corner_tolerance == 0.2);
  }
  CHECK(places(interpret("F100 G64 G02 X10 R5\nM30\n")).empty());
}

TEST_CASE("M49 and M50 P0 take the feed override away, M48 and M50 give it back", "[ipr][modes]") {
  const auto moves = moves_of(
      "F100 G01 X1\nM49 X2\nM48 X3\nM50 P0 X4\nM50 X5\nM50 P0\nM50 P1 X6\nM51 P0 X7\nM52 P0\n"
      "M53 P0 X8\nM30\n");
  const std::vector<bool> expected{true, false, true, false, true, true, true, true};
  REQUIRE(moves.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(moves[i].feed_override == expected[i]);
  const std::vector<bool> speeds{true, false, true, true, true, true, false, false};
  for (std::size_t i = 0; i < speeds.size(); ++i) CHECK(moves[i].speed_override == speeds[i]);
}

TEST_CASE("in the fanuc dialect a line that switches all off is read", "[ipr][modes][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  const auto read = interpret("G0 G17 G40 G49 G50 G69 G80 G90 G15\nG50 G50 X1\nM30\n", {}, fanuc);
  CHECK(places(read) == Places{"SC2002 2:5"});
}

TEST_CASE("in the fanuc dialect G09 ends its own block at rest", "[ipr][modes][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  const auto moves = moves_of("F100\nG09 G1 X1\nX2\nG09 G0 X3\nG1 X4\nM30\n", {}, fanuc);
  REQUIRE(moves.size() == 4);
  CHECK(moves[0].path_mode == PathMode::stop);
  CHECK(moves[1].path_mode == PathMode::follow);
  CHECK(moves[2].path_mode == PathMode::stop);
  CHECK(moves[3].path_mode == PathMode::follow);
}

}  // namespace softcnc::ipr
