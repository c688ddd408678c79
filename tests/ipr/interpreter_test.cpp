// SPDX-License-Identifier: MIT
// Lines as a whole: order of execution, modes over lines, recovery, the end.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"
#include "ipr/invariants.hpp"
#include "support/property.hpp"

namespace softcnc::ipr {
namespace {

/// "tool spindle move dwell": the kinds of blocks in their order.
std::string kinds_of(const std::vector<Block>& blocks) {
  const std::array<const char*, 5> names{"tool", "spindle", "coolant", "stop", "end"};
  std::string all;
  for (const Block& block : blocks) {
    if (!all.empty()) all += ' ';
    if (const auto* action = std::get_if<Action>(&block.what))
      all += names[static_cast<std::size_t>(action->kind)];
    else
      all += std::holds_alternative<Move>(block.what) ? "move" : "dwell";
  }
  return all;
}

AxisVector last_end(const Interpreted& result) {
  AxisVector end = AxisVector::Zero();
  for (const Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what)) end = softcnc::end(move->path);
  return end;
}

}  // namespace

TEST_CASE("the codes of a line act in the order of RS274, however they stand", "[ipr]") {
  CHECK(kinds_of(blocks_of("M30 G04 P1 M08 M03 S100 M06 T1 F100 G01 X1\n")) ==
        "tool spindle coolant dwell move end");
}

TEST_CASE("blocks are numbered from 1 and bear the place of their line", "[ipr]") {
  const auto blocks = blocks_of("(a)\nN10 M03 S100 G00 X1\n  X2\nM30\n");
  REQUIRE(blocks.size() == 4);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    CHECK(blocks[i].number == static_cast<int>(i) + 1);
  CHECK(blocks[0].source.line == 2);
  CHECK(blocks[0].source.column == 1);
  CHECK(blocks[1].source.line == 2);
  CHECK(blocks[2].source.line == 3);
  CHECK(blocks[2].source.column == 3);
}

TEST_CASE("the program of the floor plan gives the block it shows", "[ipr]") {
  const auto blocks =
      blocks_of("G21 G90 G94\nG00 X40 Y40\n\nN40 G02 X60. Y20. I0 J-20. F1200\nM30\n");
  const Block& block = blocks[1];
  CHECK(block.source.line == 4);
  const auto& move = std::get<Move>(block.what);
  const auto& arc = std::get<Arc>(move.path);
  CHECK(arc.radius() == Approx(20.0).epsilon(1e-14));
  CHECK(arc.length() == Approx(31.41592653589793).epsilon(1e-14));
  CHECK(move.feed == 20.0);
  CHECK_FALSE(arc.ccw());
}

TEST_CASE("what follows M30 or M02 is not read", "[ipr]") {
  CHECK(kinds_of(blocks_of("G00 X1\nM30\nG00 X2 $ G99\n")) == "move end");
  CHECK(kinds_of(blocks_of("M02\nM30\n")) == "end");
}

TEST_CASE("a program without an end gets a note and ends as with M30", "[ipr]") {
  const Interpreted result = interpret("G00 X1\nX2");
  CHECK(places(result) == Places{"SC2205 2:0"});
  CHECK(result.diagnostics[0].severity() == Severity::note);
  const auto& end = std::get<Action>(result.blocks.back().what);
  CHECK(end.kind == Action::Kind::end);
  CHECK(end.code == 30);
  CHECK(result.blocks.back().source.line == 2);
}

TEST_CASE("an empty program has its end and its note", "[ipr]") {
  const Interpreted result = interpret("");
  CHECK(places(result) == Places{"SC2205 0:0"});
  CHECK(kinds_of(result.blocks) == "end");
}

TEST_CASE("block skip leaves lines out only when it is switched on", "[ipr]") {
  const std::string program = "G00 X1\n/X2\nM30\n";
  CHECK(kinds_of(blocks_of(program)) == "move move end");
  CHECK(kinds_of(blocks_of(program, {}, {.block_skip = true})) == "move end");
}

TEST_CASE("a line with an error gives no block at all", "[ipr]") {
  const Interpreted result = interpret("M03 S100 G01 X1\nF100\nG01 X2 Q1\nG01 X3\nM30\n");
  CHECK(places(result) == Places{"SC2102 1:10", "SC2004 3:8"});
  CHECK(kinds_of(result.blocks) == "move end");
}

TEST_CASE("after a bad line the position is where it led", "[ipr]") {
  const Interpreted result =
      interpret("G00 X10 Y0 Q1\nG02 F100 X20 Y0 I5 J0\nG91 G01 X1 D3\nG03 X10 I5\nM30\n");
  CHECK(places(result) == Places{"SC2004 1:12", "SC2004 3:12"});
  CHECK(last_end(result).x() == Approx(31));
}

TEST_CASE("modes of a bad line hold, so that the lines after it are read by them", "[ipr]") {
  const Interpreted result = interpret("G91 G18 G20 Q1\nG00 X1\nG02 X1 R.5 F10 \nX1 K.5 R\nM30\n");
  CHECK(places(result) == Places{"SC2004 1:13", "SC1002 4:8"});
  CHECK(last_end(result).x() == Approx(50.8));
}

TEST_CASE("after an unknown character words are looked at, but nothing it may explain is reported",
          "[ipr]") {
  const auto reported = [](const std::string& line) {
    return places(interpret("G00 F100\n" + line + "\nM30\n"));
  };
  CHECK(reported("X1 \u00e4 Y2 Y3") == Places{"SC1001 2:4"});
  CHECK(reported("X1 \u00e4 Y--2 G48") == Places{"SC1001 2:4"});
  CHECK(reported("X1,5 Y2,5 Y7") == Places{"SC1001 2:3"});
  CHECK(reported("X1 gr\u00f6\u00dfe l\u00e4nge") == Places{"SC1002 2:4"});
  CHECK(reported("\u00d75 X1 \u00d7[1+2] [") == Places{"SC1001 2:1"});
  CHECK(reported("? 5 Q") == Places{"SC1001 2:1"});
  CHECK(reported("? Q 5 WHILE X1") == Places{"SC1001 2:1"});
  CHECK(reported("G01 X1 ,A5 R3 Q--1") == Places{"SC1001 2:8"});
  CHECK(reported("// a comment") == Places{"SC1011 2:2"});
  CHECK(reported("X1 // 5 ? S-1 S2") == Places{"SC1011 2:4"});
  CHECK(reported("X1 ? #1=5 Y2 Y3") == Places{"SC1001 2:4"});
  CHECK(reported("X1 ? M99 M30 o1 if [1]") == Places{"SC1001 2:4"});
  CHECK(reported("M52 P X1 X2") == Places{"SC1002 2:5"});
  CHECK(reported("X1 / 2 Y3 Y4") == Places{"SC1011 2:4"});
}

TEST_CASE("words are judged by themselves whatever else is wrong with their line", "[ipr]") {
  const auto reported = [](const std::string& line) {
    return places(interpret("G00 F100\n" + line + "\nM30\n"));
  };
  CHECK(reported("S-1 T1.5 F-2 X1.2.3") == Places{"SC2007 2:1"});
  CHECK(reported("F-1 F-2 X1") == Places{"SC2007 2:1"});
  CHECK(reported("G10 L2 P99 X1 Q1") == Places{"SC2007 2:8"});
  CHECK(reported("G10 L5 P1 Q1") == Places{"SC2007 2:5"});
  CHECK(reported("G10 L5 L2 P99 X1") == Places{"SC2003 2:8"});
  CHECK(reported("G06.4 D-1 J0 H10 L.5 I1") == Places{"SC3124 2:7"});
  CHECK(reported("G04 P-1 Q2") == Places{"SC2007 2:5"});
  CHECK(reported("G02 X9 X8 R5 I5") == Places{"SC2003 2:8"});
  CHECK(reported("G02 X9 R5 R6 I5") == Places{"SC2003 2:11"});
  CHECK(reported("G02 X9 R5 I5 G48") == Places{"SC2001 2:14"});
  CHECK(reported("G02 X9 I5 K5 P.5") == Places{"SC2105 2:11"});
  CHECK(reported("G02 X9 Q5") == Places{"SC2107 2:5"});
  CHECK(reported("G83 X1 Z-5 R-9 Q0 J1") == Places{"SC2162 2:12"});
  CHECK(reported("G83 X1 Z-5 Q1 J1") == Places{"SC2005 2:1"});
  CHECK(reported("G41 D99 G01 X1 Q3") == Places{"SC2142 2:5"});
  CHECK(reported("G00 X[10**300] Q3") == Places{"SC3008 2:5"});
  CHECK(reported("G01 Xabc Y--1 Q3 Z1..2") == Places{"SC1020 2:5"});
  CHECK(reported("drill a hole X--1") == Places{"SC1020 2:1"});
}

TEST_CASE("all words that a code lacks, or cannot take, are reported", "[ipr]") {
  const auto reported = [](const std::string& line) {
    return places(interpret("G00 F100\n" + line + "\nM30\n"));
  };
  CHECK(reported("G83 X1 Q1") == Places{"SC2005 2:1"});
  CHECK(reported("G83 X1 Z-5 R-9 Q0") == Places{"SC2162 2:12"});
  CHECK(reported("G65 P7 A1 A2 N5") == Places{"SC2311 2:14"});
  CHECK(reported("G05 X1 Y1 I1 J1 P1 Q1 Z3 K2") == Places{"SC3117 2:23"});
  CHECK(reported("G02 X1 I[10**300] J[10**300]") == Places{"SC3008 2:8"});
  CHECK(reported("G06.2 P2 K0 X0\nK0 X1 P3 D1\nK1\nK1") == Places{"SC3110 3:7"});
}

TEST_CASE("what an error has left uncertain is not held against later lines", "[ipr]") {
  CHECK(places(interpret("G01 F1.2.3 X1\nX2\nG02 X4 I1\nM30\n")) == Places{"SC1004 1:6"});
  CHECK(places(interpret("G0.0.1 X1\nX2 Y3\nX3 I2 J1\nM30\n")) == Places{"SC1004 1:2"});
  CHECK(places(interpret("T--1\nM06\nM30\n")) == Places{"SC1003 1:2"});
  CHECK(places(interpret("G0X--#1\nX+-[1] Q1.2.3\nM30\n")) == Places{"SC1003 1:4", "SC1003 2:2"});
  CHECK(places(interpret("S1E3\nM03\nM30\n")) == Places{"SC1006 1:1"});
  CHECK(places(interpret("M66E0L0\nM30\n")) == Places{"SC2241 1:4"});  // its E is a word
  CHECK(places(interpret("F100\nG99.1 X5\nG03 X9 I1\nM30\n")) == Places{"SC2001 2:1"});
  CHECK(places(interpret("F100 G91\nG01 X1$\nG90 G02 Y1 R.1\nM30\n")) == Places{"SC1001 2:7"});
}

TEST_CASE("what is certain again is held against later lines", "[ipr]") {
  CHECK(places(interpret("F100\nG01 X1.2.3\nG01 X0 Y0\nG02 X9 I1\nM30\n")) ==
        Places{"SC1004 2:6", "SC2103 4:5"});
  CHECK(places(interpret("G01 F1.2.3 X1\nF0\nX2\nM30\n")) == Places{"SC1004 1:6"});
}

TEST_CASE("a program begins with the offsets that it is given, and gives them back", "[ipr]") {
  MachineState state;
  state.work[0].origin = {100, 20, 3};
  Diagnostics diagnostics;
  const Machine machine;
  Reader reader = Reader::from_text("G00 X1 Y1 Z1\nM30\n");
  Parser parser(reader, diagnostics);
  Interpreter interpreter(parser, machine, diagnostics, {}, state);
  const auto block = interpreter.next();
  REQUIRE(block);
  CHECK(end(std::get<Move>(block->what).path) == AxisVector(101, 21, 4));
  while (interpreter.next()) {
  }
  CHECK(interpreter.state() == state);
}

TEST_CASE("a reading failure is reported once, and not as a program without end", "[ipr]") {
  const Interpreted result = interpret(Reader(-2));
  CHECK(places(result).empty() == false);
  CHECK(result.diagnostics.size() == 1);
}

TEST_CASE("no sequence of bytes breaks what holds for every program", "[ipr][property]") {
  test::holds(
      [] {
        const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
        RC_ASSERT(broken_invariant(bytes) == "");
      },
      5000);
}

TEST_CASE("no sequence of words breaks what holds for every program", "[ipr][property]") {
  const auto piece = rc::gen::element<std::string>(
      "G00", "G01", "G02", "G03", "G4", "G06.2", "G17", "G18", "G19", "G20", "G21", "G80", "G90",
      "G91", "G61.1", "G64", "G43", "M03", "M06", "M08", "M01", "M30", "M99", "F100", "F0", "F-1",
      "S500", "T1", "X1", "X2", "X-3.5", "Y1", "Y0", "Z2", "I1", "J-1", "K0", "K1", "K2", "R1",
      "R-2", "P2", "P3", "N7", "O1", "Q1", "o1 ", "o2 ", "sub\n", "endsub\n", "call\n", "return\n",
      "if[1]\n", "if[0]\n", "else\n", "elseif[1]\n", "endif\n", "while[1]\n", "endwhile\n", "do\n",
      "repeat[2]\n", "endrepeat\n", "break\n", "continue\n", "GOTO7\n", "DO1\n", "DO2\n", "END1\n",
      "END2\n", "M98 P1\n", "G65 P1\n", "\nO1\n", "\nN7", "/", "%", "(c)", "(c", ")", ";", "#", "$",
      "X1.2.3", "X--1", "X1E5", "E", " ", "\n", "\n", "\n", "\n", "\r\n", "\r");
  test::holds(
      [&] {
        const auto pieces = *rc::gen::container<std::vector<std::string>>(piece);
        std::string text = "F100 G00 X0\n";
        for (const std::string& one : pieces) text += one;
        RC_ASSERT(broken_invariant(text) == "");
        RC_ASSERT(broken_invariant(text, {.block_skip = true, .optional_stop = true}) == "");
      },
      20000);
}

TEST_CASE("what is reported of one line comes in the order of its columns", "[ipr][interpreter]") {
  CHECK(places(interpret("G48 Q1 Y--2\nX1 G49.5\nM30")) == Places{"SC2001 1:1", "SC2001 2:4"});
  const Interpreted unended = interpret("G0 X1 X2 X--3");
  CHECK(places(unended) == Places{"SC2003 1:7", "SC2205 1:0"});
}

TEST_CASE("a '%' after a note that is no comment begins the program", "[ipr][interpreter]") {
  const Interpreted result = interpret("PART NO 12-B $\n%\nO1\nG0 X1\nM30\n%\nG0 X9\n");
  CHECK(std::all_of(result.diagnostics.begin(), result.diagnostics.end(),
                    [](const Diagnostic& d) { return d.pos.line == 1; }));
  CHECK_FALSE(result.diagnostics.empty());
  REQUIRE(result.blocks.size() == 2);
  CHECK(end(std::get<Move>(result.blocks[0].what).path).x() == 1);
}

}  // namespace softcnc::ipr
