// SPDX-License-Identifier: MIT
// M codes that the machine file defines.
#include <algorithm>
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

MachineCode code_that(MachineCodeAct act) {
  MachineCode code;
  code.act = act;
  return code;
}
MachineCode sets(const std::string& output, double value) {
  MachineCode code = code_that(MachineCodeAct::output);
  code.output = output;
  code.value = value;
  return code;
}
MachineCode switches(CoolantSwitch coolant) {
  MachineCode code = code_that(MachineCodeAct::coolant);
  code.coolant = coolant;
  return code;
}
MachineCode turns(SpindleTurn direction) {
  MachineCode code = code_that(MachineCodeAct::spindle);
  code.direction = direction;
  return code;
}

Machine machine_with_codes() {
  Machine machine;
  machine.outputs["conveyor"] = {3, SignalKind::digital};
  machine.m_codes[31] = sets("conveyor", 1);
  machine.m_codes[33] = sets("3", 0);
  machine.m_codes[87] = switches(CoolantSwitch::mist);
  machine.m_codes[88] = switches(CoolantSwitch::flood);
  machine.m_codes[89] = switches(CoolantSwitch::off);
  machine.m_codes[103] = turns(SpindleTurn::cw);
  machine.m_codes[104] = turns(SpindleTurn::ccw);
  machine.m_codes[105] = turns(SpindleTurn::off);
  machine.m_codes[40] = code_that(MachineCodeAct::dwell);
  machine.m_codes[40].seconds = 1.5;
  machine.m_codes[41] = code_that(MachineCodeAct::dwell);
  machine.m_codes[101].words = "PQ";
  machine.m_codes[110] = code_that(MachineCodeAct::stop);
  return machine;
}

std::vector<Block> blocks_with_codes(const std::string& program, InterpreterOptions options = {}) {
  return blocks_of(program, machine_with_codes(), options);
}

const Action& action(const Block& block) { return std::get<Action>(block.what); }
double x_of(const Block& block) { return end(std::get<Move>(block.what).path).x(); }

}  // namespace

TEST_CASE("the M codes that a machine cannot define are those of the table", "[ipr][mcode]") {
  std::vector<int> own;
  for (const GCode& code : gcode_table())
    if (code.letter == 'M' && !is_of_haas(code)) own.push_back(code.number / 10);
  CHECK(std::vector<int>(kOwnMCodes.begin(), kOwnMCodes.end()) == own);
  CHECK(std::is_sorted(kOwnMCodes.begin(), kOwnMCodes.end()));
}

TEST_CASE("a machine may define Haas' M109, in every dialect", "[ipr][mcode][haas]") {
  Machine machine = machine_with_codes();
  machine.m_codes[109] = sets("conveyor", 1);
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::haas})
    CHECK(action(blocks_of("M109\nM30\n", machine, {.dialect = dialect}).at(0)).value == 1);
}

TEST_CASE("an M code of the machine may be ignored, with its words", "[ipr][mcode]") {
  const auto blocks = blocks_with_codes("M101 P1 Q-2.5\nG0 X10 M101\nM2\n");
  REQUIRE(blocks.size() == 2);
  CHECK(x_of(blocks[0]) == 10);
  CHECK(places(interpret("M101 P1 R2\nM31 P1\nM2\n", machine_with_codes())) ==
        Places{"SC2004 1:9", "SC2004 2:5"});
}

TEST_CASE("an M code of the machine may stop the program, after the move", "[ipr][mcode]") {
  const auto blocks = blocks_with_codes("M110 G0 X1\nX2\nM30\n");
  REQUIRE(blocks.size() == 4);
  CHECK(x_of(blocks[0]) == 1);
  CHECK(action(blocks[1]).kind == Action::Kind::stop);
  CHECK(action(blocks[1]).code == 110);
  CHECK(blocks[1].source.line == 1);
}

TEST_CASE("an M code of the machine may dwell, as G04 before the move", "[ipr][mcode]") {
  const auto blocks = blocks_with_codes("G0 X1 M40\nM41 X2\nM30\n");
  REQUIRE(blocks.size() == 4);
  CHECK(std::get<Dwell>(blocks[0].what).duration == 1.5);
  CHECK(x_of(blocks[1]) == 1);
  CHECK(x_of(blocks[2]) == 2);
}

TEST_CASE("an M code of the machine may turn the spindle at S", "[ipr][mcode]") {
  const auto blocks = blocks_with_codes("M103 S500\nS600\nM104\nM105\nS700\nM03\nM30\n");
  const std::vector<std::pair<int, double>> expected{
      {103, 500}, {0, 600}, {104, -600}, {105, 0}, {3, 700}};
  REQUIRE(blocks.size() == expected.size() + 1);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(action(blocks[i]).kind == Action::Kind::spindle);
    CHECK(action(blocks[i]).code == expected[i].first);
    CHECK(action(blocks[i]).value == expected[i].second);
  }
  CHECK(places(interpret("M104\nM2\n", machine_with_codes())) == Places{"SC2203 1:1"});
  CHECK(places(interpret("S1 M103 M03\nM2\n", machine_with_codes())) == Places{"SC2002 1:9"});
}

TEST_CASE("an M code of the machine may switch the coolant", "[ipr][mcode]") {
  const auto blocks = blocks_with_codes(
      "M87\nG0 X[1+#<_mist>] Y#<_flood>\nM88\nX[3+#<_mist>] Y#<_flood>\nM89\nX[5+#<_mist>] "
      "Y#<_flood>\nM30\n");
  REQUIRE(blocks.size() == 7);
  CHECK(action(blocks[0]).kind == Action::Kind::coolant);
  CHECK(action(blocks[0]).code == 87);
  CHECK(action(blocks[0]).value == 7);
  CHECK(end(std::get<Move>(blocks[1].what).path) == AxisVector(2, 0, 0));
  CHECK(action(blocks[2]).value == 8);
  CHECK(end(std::get<Move>(blocks[3].what).path) == AxisVector(4, 1, 0));
  CHECK(action(blocks[4]).value == 9);
  CHECK(end(std::get<Move>(blocks[5].what).path) == AxisVector(5, 0, 0));
}

TEST_CASE("an M code of the machine may set an output, by its name or number", "[ipr][mcode]") {
  const auto blocks = blocks_with_codes("G0 X1 M31\nM33\nM30\n");
  REQUIRE(blocks.size() == 4);
  CHECK(action(blocks[0]).kind == Action::Kind::output);
  CHECK(action(blocks[0]).code == 31);
  CHECK(action(blocks[0]).port.number == 3);
  CHECK(action(blocks[0]).value == 1);
  CHECK(x_of(blocks[1]) == 1);
  CHECK(action(blocks[2]).value == 0);
}

TEST_CASE("M codes of the machine work in loops, in calls and in fanuc", "[ipr][mcode][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  CHECK(blocks_with_codes("G65 P9 A2.\nM30\nO9\nWHILE [#1 GT 0] DO 1\nM31\n#1=#1-1\nEND 1\nM99\n",
                          fanuc)
            .size() == 3);
  CHECK(blocks_with_codes("%\nO1 (conveyor)\nN10 M31\n/N20 M33\nM[30+1] X0 G0\nM30\n%\n", fanuc)
            .size() == 4);
}

TEST_CASE("an M code of the machine stands within a contour", "[ipr][mcode]") {
  const auto blocks =
      blocks_with_codes("F100 G41.1 D2\nG1 X10\nX20\nM31\nM40\nX30\nG40 X40 Y5\nM30\n");
  REQUIRE(blocks.size() == 7);
  CHECK(action(blocks[2]).code == 31);
  CHECK(std::get<Dwell>(blocks[3].what).duration == 1.5);
  CHECK(x_of(blocks[4]) == 30);
}

TEST_CASE("an M code of the machine that shows an error leaves its line out", "[ipr][mcode]") {
  Machine machine = machine_with_codes();
  machine.outputs.clear();
  CHECK(places(interpret("G0 X1\nM31 X2\nX3\nM30\n", machine)) == Places{"SC2240 2:1"});
}

TEST_CASE("an unknown M code says how a machine file defines it", "[ipr][mcode]") {
  const auto message = [](const std::string& program) {
    return interpret(program).diagnostics.front().message;
  };
  CHECK(message("M31\nM30\n") ==
        "M31 is not supported; if the machine has it, its machine file says so in three lines: "
        "[mcode.31] | do = \"ignore\" | words = \"\"");
  CHECK(message("G0 X1 M101 P1 Q2\nM30\n") ==
        "M101 is not supported; if the machine has it, its machine file says so in three lines: "
        "[mcode.101] | do = \"ignore\" | words = \"PQ\"");
  CHECK(message("M1.5\nM30\n") == "M01.5 is not supported");
  CHECK(message("M-3\nM30\n") == "M-3 is not supported");
  CHECK(message("G48\nM30\n") == "G48 is not supported");
}

}  // namespace softcnc::ipr
