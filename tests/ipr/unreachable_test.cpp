// SPDX-License-Identifier: MIT
// Subprograms that nothing calls, and branches never taken, are read all the same, where that is
// asked for.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

namespace {

Told reported_unreachable(std::string text, Dialect dialect = Dialect::linuxcnc) {
  InterpreterOptions options;
  options.dialect = dialect;
  options.unreachable_too = true;
  return places(interpret(std::move(text), Machine{}, options));
}

}  // namespace

TEST_CASE("what cannot be read is reported in a subprogram that nothing calls",
          "[ipr][unreachable]") {
  CHECK(reported_unreachable("o<a> sub\nG01 X..1\nG999\n#1=[1+\nG17 G18\no<a> endsub\nM30\n") ==
        Told{"SC1004 2:6", "SC2001 3:1", "SC1016 4:6", "SC2002 5:5"});
  CHECK(reported_unreachable("M30\nO2\nG00 X1..2\nM99\nO3\nG999\nM99\n", Dialect::fanuc) ==
        Told{"SC1004 3:6", "SC2001 6:1"});
  CHECK(reported_unreachable("G00 X1\no<a> sub\nX1..2\no<a> endsub\n") ==
        Told{"SC2205 4:0", "SC1004 3:2"});
}

TEST_CASE("a refused code on a line that is never run is a warning", "[ipr][unreachable]") {
  const auto found = [](const std::string& text, Dialect dialect = Dialect::linuxcnc) {
    InterpreterOptions options;
    options.dialect = dialect;
    options.unreachable_too = true;
    Told all;
    for (const Diagnostic& d : interpret(text, Machine{}, options).diagnostics)
      all.push_back(code_name(d.code) + " " + std::to_string(d.pos.line) + " " +
                    std::string(name(d.severity())));
    return all;
  };
  CHECK(found("o<touch> sub\nG33.1 Z-5 K1\nG999\nG33 Z-1 K1\nX1\no<touch> endsub\nM2\n") ==
        Told{"SC2114 2 warning", "SC2001 3 error", "SC2114 4 warning"});
  CHECK(found("o1 if [0]\nG33 Z-5 K1\nG76 Z1 P1 I1 J1 K1\no1 endif\nG0 X1\nM2\n") ==
        Told{"SC2114 2 warning", "SC2114 3 warning"});
  CHECK(found("O1\nGOTO 9\nG33 Z-5. F1.\nG76 Z-1. R1. Q1.\nM29 S9\nN9 M30\nO2\nG33 Z#1\nG96\nM99\n",
              Dialect::fanuc) == Told{"SC2114 8 warning", "SC2221 9 warning", "SC2114 3 warning",
                                      "SC2161 4 warning", "SC2114 5 warning"});
  CHECK(found("G33 Z-5 K1\nM2\n") == Told{"SC2114 1 error"});
  CHECK(found("o<a> sub\nG33 Z..5\no<a> endsub\nM2\n") ==
        Told{"SC2114 2 warning", "SC1004 2 error"});

  InterpreterOptions options;
  options.unreachable_too = true;
  const auto one = interpret("o<a> sub\nG33 Z-5\no<a> endsub\nM2\n", Machine{}, options);
  REQUIRE(one.diagnostics.size() == 1);
  CHECK(one.diagnostics[0].message ==
        "G33 is refused: threads need a spindle with an encoder, which the axes could follow; "
        "nothing runs this line");
  CHECK(exit_status(one.diagnostics[0]) == 0);
  CHECK(one.diagnostics[0].source_line == "G33 Z-5");
}

TEST_CASE("what depends on how a subprogram is called is not reported", "[ipr][unreachable]") {
  CHECK(
      reported_unreachable("o<a> sub\n#1=0\no<b> if [#2 EQ 1]\nG01 X[1/#1] Y#<depth>\no<b> endif\n"
                           "(ABORT,never)\no<a> endsub\nM30\n") == Told{});
  CHECK(reported_unreachable("O1\nM30\nO2\nX5 R3\nGOTO 77\n#3000=1\nM99\n", Dialect::fanuc) ==
        Told{});
}

TEST_CASE("after a computed label nothing is reported of how a subprogram that nothing calls nests",
          "[ipr][unreachable]") {
  const auto within = [](const std::string& lines) {
    return reported_unreachable("o<a> sub\n" + lines + "\no<a> endsub\nM30\n");
  };
  CHECK(within("#1=7\no#1 repeat [2]\nG00 X1\no#1 endrepeat") == Told{});
  CHECK(within("#<x>=7\no#<x> repeat [2]\nG00 X1\no#<x> endrepeat") == Told{});
  CHECK(within("#1=7\no#1 if [#2]\nG00 X3\no#1 else\nG00 X4\no#1 endif") == Told{});
  CHECK(within("o[#1+10] if [#2]\nG00 X3\no[#1+20] if [#3]\no[#1+20] endif\no[#1+10] endif") ==
        Told{});
  CHECK(within("o#1 repeat [2]\nG00 X..1\no#1 endrepeat\no1 endif") == Told{"SC1004 3:6"});
  CHECK(reported_unreachable(
            "o<a> sub\no#1 if [#2]\no#1 endif\no<a> endsub\no<b> sub\no1 endif\no<b> endsub\n"
            "M30\n") == Told{"SC2304 6:1"});
}

TEST_CASE("a label on a line that is passed over is not compared with the other dialect",
          "[ipr][unreachable]") {
  const auto compared = [](const std::string& text) {
    InterpreterOptions options;
    options.unreachable_too = options.compare_dialects = true;
    return places(interpret(text, Machine{}, options));
  };
  CHECK(compared("o<a> sub\no[#1] call\no<a> endsub\no7 sub\no7 endsub\nG00 X1\no<a> call [7]\n"
                 "M02\n") == Told{});
  CHECK(compared("o<a> sub\no[#1] call\no<a> endsub\nG00 X1\nM02\n") == Told{});
}

TEST_CASE("a subprogram that is called is reported once, as it runs", "[ipr][unreachable]") {
  CHECK(reported_unreachable("o<a> sub\nG00 X..1\no<a> endsub\no<a> call\nM30\n") ==
        Told{"SC1004 2:6"});
  CHECK(reported_unreachable("M98 P2\nM30\nO2\nG00 X..1\nM99\n") == Told{"SC1004 4:6"});
}

TEST_CASE("loops and branches of a subprogram that nothing calls have both their ends",
          "[ipr][unreachable]") {
  const auto within = [](const std::string& lines) {
    return reported_unreachable("o<a> sub\n" + lines + "\no<a> endsub\nM30\n");
  };
  CHECK(within("o1 if [#1]\no1 else\no1 endif\no2 do\no2 while [#1]\no3 repeat [2]\no3 endrepeat\n"
               "o4 while [#1]\no4 endwhile") == Told{});
  CHECK(within("o1 if [#1]\nG00 X1") == Told{"SC2302 2:1"});
  CHECK(within("o1 endif") == Told{"SC2304 2:1"});
  CHECK(within("o1 if [#1]\no2 while [1]\no1 endif") == Told{"SC2302 3:1"});
  CHECK(within("?o1 if [#1]\no1 endif") == Told{"SC1001 2:1"});
  CHECK(reported_unreachable("M30\nO2\nWHILE [#1] DO 1\nWHILE [#2] DO 2\nEND 1\nEND 2\nM99\n",
                             Dialect::fanuc) == Told{"SC2312 5:1"});
}

TEST_CASE("labels used again are no error where no call looks for them", "[ipr][unreachable]") {
  CHECK(reported_unreachable("O0001\nG00 X1\nM30\nO0001\nG00 X2\nM30\n") == Told{});
  CHECK(reported_unreachable("M30\no<a> sub\no<a> endsub\no<a> sub\no<a> endsub\n") == Told{});
  CHECK(reported_unreachable("O1\nM30\nO2\nG00 X..1\nM99\nO2\nG00 X..2\nM99\n", Dialect::fanuc) ==
        Told{"SC1004 4:6", "SC1004 7:6"});
  CHECK(reported_unreachable("o<a> sub\no<a> endsub\no<a> sub\no<a> endsub\no<b> call\nM30\n") ==
        Told{"SC2314 3:1"});
}

TEST_CASE("subprograms are left unread where nobody asks for them, or the program broke off",
          "[ipr][unreachable]") {
  CHECK(places(interpret("o<a> sub\nG999\no<a> endsub\nM30\n")) == Told{});
  CHECK(reported_unreachable("o<a> sub\nG999\no<a> endsub\n(ABORT,here)\n") == Told{"SC1031 4:1"});
}

TEST_CASE("a '%' that ends the program leaves what stands before it as it is",
          "[ipr][unreachable]") {
  CHECK(reported_unreachable("G00 X1\nM30\nO2\nX..1\nM99\n%\n") == Told{"SC1004 4:2"});
  CHECK(reported_unreachable("G00 X1\n%\n") == Told{"SC2205 2:0"});
}

TEST_CASE("what cannot be read is reported on lines that are passed over", "[ipr][unreachable]") {
  CHECK(reported_unreachable(
            "o1 if [0]\nG00 X..1\nG999\no1 elseif [0]\n#1=[1+\no1 else\nG01 Y1 F60\no1 endif\n"
            "M30\n") == Told{"SC1004 2:6", "SC2001 3:1", "SC1016 5:6"});
  CHECK(reported_unreachable("o1 if [1]\nG00 X1\no1 elseif [1+]\nG00 X..2\no1 endif\nM30\n") ==
        Told{"SC1016 3:14", "SC1004 4:6"});
  CHECK(reported_unreachable("o1 while [0]\nG17 G18\no1 endwhile\nM30\n") == Told{"SC2002 2:5"});
  CHECK(reported_unreachable("o1 repeat [1]\no1 break\nG999\no1 endrepeat\nM30\n") ==
        Told{"SC2001 3:1"});
  CHECK(reported_unreachable("GOTO 7\nG00 X..1\nN7 G00 X1\nM30\n", Dialect::fanuc) ==
        Told{"SC1004 2:6"});
  CHECK(reported_unreachable("WHILE [0 EQ 1] DO 1\nG999\nEND 1\nM30\n", Dialect::fanuc) ==
        Told{"SC2001 2:1"});
}

TEST_CASE("after an end that may not be reached, lines are read all the same",
          "[ipr][unreachable]") {
  CHECK(reported_unreachable("o1 if [#1 gtt 3]\nM2\no1 endif\nG0 X..\nG0 X1\nM2\n") ==
        Told{"SC1018 1:13", "SC1004 4:5"});
  CHECK(reported_unreachable("IF [#2 EQQ 2] GOTO 10\nM30\nN10 G0 X..\nM30\n", Dialect::fanuc) ==
        Told{"SC1018 1:10", "SC1004 3:9"});
  CHECK(reported_unreachable("G0 X1\nM2\nG0 X..\n") == Told{});
}

TEST_CASE("where a subprogram's first line is misspelt, it is reported and not the call",
          "[ipr][unreachable]") {
  const std::string program = "o200 call\nM2\no200 suub\nG0 X1\no200 endsub\n";
  CHECK(reported_unreachable(program) == Told{"SC1020 3:6"});
  CHECK(places(interpret(program)) == Told{"SC2301 1:1"});
}

TEST_CASE("lines that are only read leave the order of the blocks as it is", "[ipr][unreachable]") {
  InterpreterOptions options;
  options.unreachable_too = true;
  for (const std::string end : {"M2\n", ""}) {
    const auto ran = interpret("F100\nG41.1 D4\nG1 X5\nX9\n" + end + "o1 sub\nG0 X..1\no1 endsub\n",
                               Machine{}, options);
    REQUIRE(ran.blocks.size() == 3);
    CHECK(std::holds_alternative<Move>(ran.blocks[1].what));
    CHECK(std::holds_alternative<Action>(ran.blocks[2].what));
  }
}

TEST_CASE("what is passed over at one time and run at another is reported once",
          "[ipr][unreachable]") {
  CHECK(reported_unreachable(
            "#1=0\no1 repeat [2]\no2 if [#1]\nG00 X..1\no2 else\nG00 X..2\no2 endif\n#1=1\n"
            "o1 endrepeat\nM30\n") == Told{"SC1004 6:6", "SC1004 4:6"});
  CHECK(reported_unreachable("GOTO 2\nN1 G00 X1\nGOTO 3\nG00 X..1\nN2 GOTO 1\nG00 X..2\nN3 M30\n",
                             Dialect::fanuc) == Told{"SC1004 4:6", "SC1004 6:6"});
}

TEST_CASE("nothing is reported of a branch never taken that rests on variables, modes or nesting",
          "[ipr][unreachable]") {
  CHECK(reported_unreachable(
            "#1=0\no1 if [#1]\nX[1/#1] Y#<depth>\nG01 X1\n(ABORT,never)\no2 if [1]\no1 endif\n"
            "M30\n") == Told{});
  CHECK(reported_unreachable("o1 if [0]\nM30\no1 endif\nG00 X1\nM30\n") == Told{});
}

TEST_CASE("branches never taken of a called subprogram are read, what stands between two is not",
          "[ipr][unreachable]") {
  CHECK(reported_unreachable(
            "O1\nM98 P2\nG00 X1\nM30\nleft over X..1\nO2\nIF [1 EQ 1] GOTO 5\nG00 X..2\n"
            "N5 M99\nleft over X..3\nO3\nG00 X..4\nM99\n",
            Dialect::fanuc) == Told{"SC1004 12:6", "SC1004 8:6"});
  CHECK(reported_unreachable(
            "o<a> sub\no1 if [#1]\nG00 X..1\no1 endif\no<a> endsub\no<a> call [0]\nM30\n") ==
        Told{"SC1004 3:6"});
}

TEST_CASE("what stands after a THEN that does not count is read all the same",
          "[ipr][unreachable]") {
  const auto fanuc = [](const std::string& text) {
    return reported_unreachable(text, Dialect::fanuc);
  };
  CHECK(fanuc("IF [1 EQ 2] THEN #1=1..2\nM30\n") == Told{"SC1004 1:21"});
  CHECK(fanuc("N5 IF [1 EQ 2] THEN #1=[2+\nG0 X..1\nM30\n") == Told{"SC1004 2:5", "SC1016 1:26"});
  CHECK(fanuc("#1=0\nIF [#1 NE 0] THEN #2=[10/#1]\nG0 X#2\nM30\n") == Told{});
  CHECK(fanuc("#1=7\nIF [#1 EQ 0] THEN #3000=1(NEVER)\nIF [#1 EQ 0] THEN #1=99\n"
              "IF [#1 EQ 99] GOTO 77\nM30\n") == Told{});
  CHECK(fanuc("IF [1 EQ 2] THEN #1=1..2") == Told{"SC1004 1:21", "SC2205 1:0"});
  CHECK(fanuc("O1\nM30\nO2\nIF [#1 EQ 2] THEN #1=1..2\nM99\n") == Told{"SC1004 4:22"});
  CHECK(fanuc("#1=0\nWHILE [#1 LT 2] DO 1\nIF [#1 EQ 1] THEN #2=1..2\n#1=#1+1\nEND 1\nM30\n") ==
        Told{"SC1004 3:22"});
  CHECK(fanuc("#1=1..2\nIF [#1 EQ 2] THEN #2=3..4\nM30\n") == Told{"SC1004 1:4"});
  CHECK(places(interpret("IF [1 EQ 2] THEN #1=1..2\nM30\n")) == Told{});
}

TEST_CASE("lines passed over at the end of the text are read as well", "[ipr][unreachable]") {
  CHECK(reported_unreachable("o1 if [0]\nG00 X..1\no1 endif\n") ==
        Told{"SC2205 3:0", "SC1004 2:6"});
}
