// SPDX-License-Identifier: MIT
// Dwell, tool, spindle, coolant, stops.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

std::vector<Action> actions_of(const std::string& program, InterpreterOptions options = {}) {
  std::vector<Action> actions;
  for (const Block& block : blocks_of(program, {}, options))
    if (const auto* action = std::get_if<Action>(&block.what)) actions.push_back(*action);
  return actions;
}

void check(const Action& action, Action::Kind kind, int code, double value) {
  CHECK(action.kind == kind);
  CHECK(action.code == code);
  CHECK(action.value == value);
}

}  // namespace

TEST_CASE("G04 waits P seconds, and P0 is no block", "[ipr][actions]") {
  const auto blocks = blocks_of("G04 P1.5\nG04 P0\nM30\n");
  REQUIRE(blocks.size() == 2);
  CHECK(std::get<Dwell>(blocks[0].what).duration == 1.5);
}

TEST_CASE("the spindle has its speed and its sense", "[ipr][actions]") {
  const auto actions = actions_of("S1000\nM03\nS2000\nM04\nM05\nS500\nM03 S10\nM30\n");
  REQUIRE(actions.size() == 6);
  check(actions[0], Action::Kind::spindle, 3, 1000);
  check(actions[1], Action::Kind::spindle, 0, 2000);
  check(actions[2], Action::Kind::spindle, 4, -2000);
  check(actions[3], Action::Kind::spindle, 5, 0);
  check(actions[4], Action::Kind::spindle, 3, 10);
}

TEST_CASE("S is held within the machine's range, with one warning a file", "[ipr][actions]") {
  Machine machine;
  machine.spindle = {100, 6000};
  const Interpreted result = interpret("M03 S50\nS9000\nS0\nM30\n", machine);
  CHECK(places(result) == Places{"SC2202 1:5"});
  CHECK(std::get<Action>(result.blocks[0].what).value == 100);
  CHECK(std::get<Action>(result.blocks[1].what).value == 6000);
  CHECK(std::get<Action>(result.blocks[2].what).value == 0);
}

TEST_CASE("T selects and M06 changes", "[ipr][actions]") {
  const auto actions = actions_of("T3\nT5 M06\nM06\nM30\n");
  REQUIRE(actions.size() == 3);
  check(actions[0], Action::Kind::tool, 6, 5);
  check(actions[1], Action::Kind::tool, 6, 5);
}

TEST_CASE("M06 stops the spindle, M61 does not", "[ipr][actions]") {
  const auto actions = actions_of("M03 S100\nT1 M06\nT2 M06\nM04 M06\nS50 M61 Q3\nM30\n");
  REQUIRE(actions.size() == 9);
  check(actions[1], Action::Kind::spindle, 6, 0);
  check(actions[2], Action::Kind::tool, 6, 1);
  check(actions[3], Action::Kind::tool, 6, 2);
  check(actions[4], Action::Kind::tool, 6, 2);
  check(actions[5], Action::Kind::spindle, 4, -100);
  check(actions[6], Action::Kind::spindle, 0, -50);
  check(actions[7], Action::Kind::tool, 61, 3);
}

TEST_CASE("what needs a turning spindle does not have one after M06", "[ipr][actions]") {
  const std::string start = "F100 S500 M03\nG00 Z5\nT1 M06\n";
  CHECK(places(interpret(start + "G84 X1 Z-1 R1\nM30\n")) == Places{"SC2163 4:1"});
  CHECK(places(interpret(start + "G86 X1 Z-1 R1 P0\nM30\n")) == Places{"SC2163 4:1"});
  CHECK(places(interpret("F100 S500 M04\nG00 Z5\nT1 M06\nG74 X1 Z-1 R1\nM30\n")) ==
        Places{"SC2163 4:1"});
  CHECK(places(interpret(start + "G95 F0.1\nG01 X1\nM30\n")) == Places{"SC2222 5:1"});
  CHECK(places(interpret(start + "G06.4 D5 J0.5 H10 L2\nG01 X1\nM30\n")) == Places{"SC3128 5:1"});
  CHECK(places(interpret(start + "M03\nG84 X1 Z-1 R1\nM30\n")).empty());
  CHECK(last_place(start + "G00 X[1+#<_spindle_on>] Y[1+#<_spindle_cw>] Z1\nM30\n") ==
        AxisVector(1, 1, 1));
}

TEST_CASE("M72 turns the spindle on again that M06 has stopped", "[ipr][actions]") {
  const auto actions = actions_of("M03 S100\nM70\nT1 M06\nM72\nM30\n");
  REQUIRE(actions.size() == 5);
  check(actions[1], Action::Kind::spindle, 6, 0);
  check(actions[3], Action::Kind::spindle, 3, 100);
}

TEST_CASE("coolant and stops are reported by their code", "[ipr][actions]") {
  const auto actions = actions_of("M07\nM08\nM09\nM00\nM02\n");
  REQUIRE(actions.size() == 5);
  check(actions[0], Action::Kind::coolant, 7, 0);
  check(actions[1], Action::Kind::coolant, 8, 0);
  check(actions[2], Action::Kind::coolant, 9, 0);
  check(actions[3], Action::Kind::stop, 0, 0);
  check(actions[4], Action::Kind::end, 2, 0);
}

TEST_CASE("M01 stops only when optional stops are switched on", "[ipr][actions]") {
  CHECK(actions_of("M01\nM30\n").size() == 1);
  InterpreterOptions options;
  options.optional_stop = true;
  const auto actions = actions_of("M01\nM30\n", options);
  REQUIRE(actions.size() == 2);
  check(actions[0], Action::Kind::stop, 1, 0);
}

TEST_CASE("in the fanuc dialect P is in milliseconds, X and U in seconds",
          "[ipr][actions][fanuc]") {
  const auto blocks = blocks_of("G04 P1500\nG01 F60 X1\nG04 X1.5\nG04 U2\nM30\n", {}, kFanuc);
  REQUIRE(blocks.size() == 5);
  CHECK(std::get<Dwell>(blocks[0].what).duration == 1.5);
  CHECK(std::get<Dwell>(blocks[2].what).duration == 1.5);
  CHECK(std::get<Dwell>(blocks[3].what).duration == 2);
}

TEST_CASE("X beside G04 P is for the motion in force", "[ipr][actions]") {
  const auto blocks = blocks_of("G01 F100 X1\nG04 P1 X5\nM30\n");
  REQUIRE(blocks.size() == 4);
  CHECK(std::holds_alternative<Dwell>(blocks[1].what));
  CHECK(end(std::get<Move>(blocks[2].what).path).x() == 5);
}

TEST_CASE("M60 stops, M61 names the tool in the spindle", "[ipr][actions]") {
  const auto actions = actions_of("M60\nM61 Q7\nM06\nM30\n");
  REQUIRE(actions.size() == 4);
  check(actions[0], Action::Kind::stop, 60, 0);
  check(actions[1], Action::Kind::tool, 61, 7);
  check(actions[2], Action::Kind::tool, 6, 7);
}

}  // namespace softcnc::ipr
