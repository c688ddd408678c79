// SPDX-License-Identifier: MIT
// Loops, branches, jumps and calls: in which order lines are executed.
#include <catch2/catch.hpp>
#include <filesystem>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"
#include "support/folder.hpp"

namespace softcnc::ipr {
namespace {

Stops fanuc_way(const std::string& text) { return places_along_x(text, Dialect::fanuc); }

/// A folder with files beside a program.
class ProgramFolder : public test::Folder {
 public:
  Interpreted run(const std::string& text, Dialect dialect = Dialect::linuxcnc) const {
    InterpreterOptions options = in(dialect);
    options.folder = path();
    return interpret(text, {}, options);
  }
};

Stops way_of(const Interpreted& result) {
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL_CHECK(render(diagnostic));
  Stops all;
  for (const Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what)) all.push_back(end(move->path)[0]);
  return all;
}

/// What is reported, "4:1 SC2301 text"; runs lines as often as 1000 times.
std::vector<std::string> reported_in_words(const std::string& text,
                                           Dialect dialect = Dialect::linuxcnc) {
  Machine machine;
  machine.program.block_limit = 1000;
  std::vector<std::string> all;
  for (const Diagnostic& d : interpret(text, machine, in(dialect)).diagnostics)
    all.push_back(std::to_string(d.pos.line) + ":" + std::to_string(d.pos.column) + " SC" +
                  std::to_string(static_cast<int>(d.code)) + " " + d.message);
  return all;
}

}  // namespace

TEST_CASE("if runs the first branch whose condition holds", "[ipr][flow]") {
  const auto branch = [](int n) {
    return places_along_x(
        "#1=" + std::to_string(n) +
        "\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nX2\nG0 X2\no1 elseif [#1 LE 2]\n"
        "G0 X9\no1 else\nG0 X3\no1 endif\nG0 X0\nM2\n");
  };
  CHECK(branch(1) == Stops{1, 0});
  CHECK(branch(0) == Stops{9, 0});
  CHECK(branch(3) == Stops{3, 0});
  CHECK(places_along_x("o1 if [0]\nG0 X1\no1 endif\nG0 X2\nM2") == Stops{2});
}

TEST_CASE("a line that is passed over is not evaluated", "[ipr][flow]") {
  CHECK(places_along_x("o1 if [0]\n#1=[1/0]\nG0 X#<nowhere>\no1 endif\nG0 X2\nM2") == Stops{2});
  CHECK(places_along_x("o1 if [1]\nG0 X1\no1 elseif [1/0]\no1 endif\nM2") == Stops{1});
}

TEST_CASE("branches within branches belong to their labels", "[ipr][flow]") {
  CHECK(places_along_x(
            "o1 if [0]\no2 if [1]\nG0 X1\no2 else\nG0 X2\no2 endif\no1 else\no3 if [1]\nG0 X3\n"
            "o3 endif\nG0 X4\no1 endif\nM2") == Stops{3, 4});
}

TEST_CASE("while asks before each round, do after it, repeat counts", "[ipr][flow]") {
  CHECK(places_along_x("#1=1\no1 while [#1 LT 4]\nG0 X#1\n#1=[#1+1]\no1 endwhile\nG0 X9\nM2") ==
        Stops{1, 2, 3, 9});
  CHECK(places_along_x("o1 while [0]\nG0 X1\no1 endwhile\nG0 X9\nM2") == Stops{9});
  CHECK(places_along_x("#1=5\no1 do\nG0 X#1\n#1=[#1+1]\no1 while [#1 LT 5]\nG0 X9\nM2") ==
        Stops{5, 9});
  CHECK(places_along_x("#1=1\no1 do\nG0 X#1\n#1=[#1+1]\no1 while [#1 LT 4]\nM2") == Stops{1, 2, 3});
  CHECK(places_along_x("G91 G0 X5\no1 repeat [3]\nX1\no1 endrepeat\nM2") == Stops{5, 6, 7, 8});
  CHECK(places_along_x(
            "o1 repeat [0]\nG0 X1\no1 endrepeat\no2 repeat [-2]\nG0 X1\no2 endrepeat\nG0 X9\nM2") ==
        Stops{9});
  CHECK(places_along_x("G91\no1 repeat [1.6]\nG0 X1\no1 endrepeat\nM2") == Stops{1, 2});
}

TEST_CASE("break leaves a loop, continue begins its next round", "[ipr][flow]") {
  CHECK(places_along_x("#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\n"
                       "o3 if [#1 EQ 4]\no1 break\no3 endif\nG0 X#1\no1 endwhile\nG0 X9\nM2") ==
        Stops{1, 3, 9});
  CHECK(places_along_x("#1=0\no1 do\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\nG0 X#1\n"
                       "o1 while [#1 LT 3]\nM2") == Stops{1, 3});
  CHECK(
      places_along_x("#1=0\no1 repeat [4]\n#1=[#1+1]\no2 if [#1 EQ 3]\no1 break\no2 endif\nG0 X#1\n"
                     "o1 endrepeat\nG0 X9\nM2") == Stops{1, 2, 9});
  CHECK(places_along_x(
            "o1 while [1]\no2 repeat [5]\nG0 X1\no1 break\no2 endrepeat\no1 endwhile\nG0 X2\nM2") ==
        Stops{1, 2});
}

TEST_CASE("loops within loops run as often as their product says", "[ipr][flow]") {
  CHECK(places_along_x(
            "G91\no1 repeat [3]\no2 repeat [4]\no3 repeat [5]\nG0 X1\no3 endrepeat\no2 endrepeat\n"
            "o1 endrepeat\nM2")
            .back() == 60);
}

TEST_CASE("a subprogram is run where it is called, before or after its definition", "[ipr][flow]") {
  CHECK(places_along_x(
            "o100 sub\nG0 X#1 Y#2\no100 endsub\nG0 X5\no100 call [1] [2]\no100 call [3]\nM2") ==
        Stops{5, 1, 3});
  CHECK(places_along_x("o100 call [7]\nM2\no100 sub\nG0 X#1\no100 endsub") == Stops{7});
  CHECK(places_along_x("o<Pocket> call [7]\nM2\no<pocket> sub\nG0 X#1\no<POCKET> endsub") ==
        Stops{7});
  CHECK(places_along_x("o100 sub\nG0 X1\no100 endsub\n#5=90\no[10+#5] call\nM2") == Stops{1});
}

TEST_CASE("each call has its own variables, and gives a value back", "[ipr][flow]") {
  CHECK(places_along_x(
            "o1 sub\n#1=[#1*2]\n#2=77\no1 return [#1+1]\no1 endsub\n#1=5 #2=6\no1 call [10]\n"
            "G0 X#1\nX#2\nX#<_value>\nX#<_value_returned>\nM2") == Stops{5, 6, 21, 1});
  CHECK(places_along_x(
            "o1 sub\nG0 X[#3+7]\no1 endsub\n#3=5\no1 call [1]\nG0 X#<_value_returned>\nM2") ==
        Stops{7, 0});
  CHECK(places_along_x("o1 sub\no2 if [#1 LE 1]\no1 return [1]\no2 endif\no1 call [#1-1]\n"
                       "o1 endsub [#1*#<_value>]\no1 call [5]\nG0 X#<_value>\nM2") == Stops{120});
}

TEST_CASE("the end of the program is the end, wherever it stands", "[ipr][flow]") {
  CHECK(places_along_x("o1 sub\nG0 X1\nM30\no1 endsub\no1 call\nG0 X2\nM2") == Stops{1});
  CHECK(places_along_x("o1 while [1]\nG0 X1\nM2\no1 endwhile\nG0 X2") == Stops{1});
  CHECK(places_along_x("G0 X1\nM30\no1 sub\nG0 X2\no1 endsub") == Stops{1});
}

TEST_CASE("a line that is left out has no statement either", "[ipr][flow]") {
  InterpreterOptions skip;
  skip.block_skip = true;
  const std::string text = "/o1 if [0]\nG0 X1\n/o1 endif\nM2";
  CHECK(places_along_x(text).empty());
  CHECK(blocks_of(text, {}, skip).size() == 2);
  CHECK(blocks_of("o1 if [0]\n/o1 else\nG0 X1\no1 endif\nM2", {}, skip).size() == 1);
}

TEST_CASE("statements stand between the blocks of a curve", "[ipr][flow]") {
  const auto looped = moves_of(
      "G6.2 P2 K0 X0 Y0 F100\n#1=0\no1 repeat [2]\nK#1 X[#1+1] Y#1\n"
      "#1=[#1+1]\no1 endrepeat\nK2\nK2\nM2");
  const auto plain = moves_of("G6.2 P2 K0 X0 Y0 F100\nK0 X1 Y0\nK1 X2 Y1\nK2\nK2\nM2");
  REQUIRE(looped.size() == 1);
  REQUIRE(plain.size() == 1);
  CHECK(std::get<Nurbs>(looped[0].path).spec().control ==
        std::get<Nurbs>(plain[0].path).spec().control);
}

TEST_CASE("FANUC: M98 calls a program after the main one, M99 leads back", "[ipr][flow]") {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc}) {
    CHECK(places_along_x("O1\nG0 X1\nM98 P1000\nG0 X2\nM30\nO1000\nG0 X7\nM99\nO2000\nG0 X8\nM99",
                         dialect) == Stops{1, 7, 2});
    CHECK(places_along_x("O1\nG91\nM98 P1000 L3\nM30\nO1000\nG0 X1\nM99", dialect) ==
          Stops{1, 2, 3});
    CHECK(places_along_x("O1\nM98 P1000 L0\nM30\nO1000\nG0 X1\nM99", dialect).empty());
    CHECK(places_along_x("O1\nG0 X1 M98 P5\nX3\nM30\nO5\nX2\nM98 P6\nM99\nO6\nX4\nM99", dialect) ==
          Stops{1, 2, 4, 3});
  }
}

TEST_CASE("FANUC: P of M98 may hold the count, as in old programs", "[ipr][flow]") {
  CHECK(fanuc_way("O1\nG91\nM98 P31000\nM30\nO1000\nG0 X1\nM99") == Stops{1, 2, 3});
  CHECK(fanuc_way("O1\nM98 P31000 L1\nM30\nO31000\nG0 X1\nM99") == Stops{1});
  CHECK(places_along_x("O1\nM98 P31000\nM30\nO31000\nG0 X1\nM99") == Stops{1});
}

TEST_CASE("FANUC: M98 shares the local variables, G65 has its own", "[ipr][flow]") {
  CHECK(fanuc_way("O1\n#1=5\nM98 P2\nG0 X#1\nM30\nO2\n#1=#1+1\nM99") == Stops{6});
  CHECK(fanuc_way("O1\n#1=5\nG65 P2 A1.\nG0 X#1\nM30\nO2\n#1=#1+1\nG0 X#1\nM99") == Stops{2, 5});
}

TEST_CASE("FANUC: the words of G65 are variables", "[ipr][flow]") {
  const auto taken = [](const std::string& words, int number) {
    return fanuc_way("O1\nG65 P2 " + words + "\nM30\nO2\nG0 X#" + std::to_string(number) + "\nM99");
  };
  const std::string letters = "ABCIJKDEFHMQRSTUVWXYZ";
  const int numbers[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  std::string all;
  for (std::size_t i = 0; i < letters.size(); ++i)
    all += letters[i] + std::to_string(numbers[i] + 100) + ". ";
  for (const int number : numbers) CHECK(taken(all, number) == Stops{number + 100.0});
  const std::string sets = "A1. B2. C3. I4. J5. K6. I7. J8. K9. I10. K12. J14. K15. I16.";
  for (const int number : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15, 16})
    CHECK(taken(sets, number) == Stops{static_cast<double>(number)});
  CHECK(fanuc_way("O1\nG91\nG65 P2 A3. L2\nM30\nO2\nG0 X#1\n#1=7\nM99") == Stops{3, 6});
  CHECK(taken("I1. I2. D9", 7) == Stops{9});
}

TEST_CASE("Haas: a repeated G65 keeps the local variables of the time before",
          "[ipr][flow][haas]") {
  const std::string text = "O1\n#1=50.\nG65 P2 L3 A1.\nG0 X#1\nM30\nO2\nG0 X#1\n#1=#1+1\nM99";
  CHECK(places_along_x(text, Dialect::haas) == Stops{1, 2, 3, 50});
  CHECK(fanuc_way(text) == Stops{1, 50});
  CHECK(places_along_x(
            "O1\n#1=7.\nG65 P2 L3 A1.\nG0 X#1\nM30\nO2\nG0 X#1\n#1=#1+1\nM99 P5\nX90.\nN5 M99",
            Dialect::haas) == Stops{1, 2, 3, 7});
}

TEST_CASE("FANUC: GOTO looks ahead first, then from the beginning", "[ipr][flow]") {
  CHECK(fanuc_way("N1 G0 X1\nGOTO 3\nN2 G0 X2\nN3 G0 X3\nM30") == Stops{1, 3});
  CHECK(fanuc_way("#1=0\nN10 #1=#1+1\nG0 X#1\nIF [#1 LT 3] GOTO 10\nM30") == Stops{1, 2, 3});
  CHECK(fanuc_way("#1=1\nN5 G0 X#1\n#1=#1+1\nIF [#1 GT 2] GOTO 9\nGOTO 5\nN5 G0 X7\nN9 M30") ==
        Stops{1, 7});
  CHECK(fanuc_way("#2=30\nGOTO #2\nG0 X1\nN30 G0 X2\nM30") == Stops{2});
  CHECK(fanuc_way("O1\nM98 P2\nN1 G0 X1\nM30\nO2\nGOTO 1\nG0 X5\nN1 G0 X6\nM99") == Stops{6, 1});
}

TEST_CASE("FANUC: WHILE and DO run to their END", "[ipr][flow]") {
  CHECK(fanuc_way("#1=1\nWHILE [#1 LT 4] DO 1\nG0 X#1\n#1=#1+1\nEND 1\nG0 X9\nM30") ==
        Stops{1, 2, 3, 9});
  CHECK(fanuc_way("WHILE [1 EQ 0] DO 1\nG0 X1\nEND 1\nG0 X9\nM30") == Stops{9});
  CHECK(fanuc_way("G91\n#1=0\nWHILE [#1 LT 2] DO 1\n#2=0\nWHILE [#2 LT 3] DO 2\nG0 X1\n#2=#2+1\n"
                  "END 2\n#1=#1+1\nEND 1\nM30")
            .back() == 6);
  CHECK(fanuc_way("#1=0\nDO 1\n#1=#1+1\nIF [#1 EQ 3] GOTO 7\nG0 X#1\nEND 1\nN7 G0 X9\nM30") ==
        Stops{1, 2, 9});
  CHECK(fanuc_way("#1=0\nWHILE [#1 LT 2] DO 1\n#1=#1+1\nDO 2\nGOTO 5\nEND 2\nN5 G0 X#1\nEND 1\n"
                  "M30") == Stops{1, 2});
}

TEST_CASE("FANUC: M99 leads where P says, and starts the main program again", "[ipr][flow]") {
  CHECK(fanuc_way("O1\nM98 P2\nG0 X1\nN50 G0 X2\nM30\nO2\nM99 P50") == Stops{2});
  CHECK(fanuc_way("O1\n#500=#500+1\nIF [#500 GT 3] GOTO 90\nG0 X#500\nM99\nN90 M30") ==
        Stops{1, 2, 3});
  CHECK(fanuc_way("O1\nG0 X1\nM99 P9\nX2\nN9 X3\nM30") == Stops{1, 3});
  CHECK(fanuc_way("O1\nM98 P2 Q5\nM30\nO2\nG0 X1\nN5 G0 X2\nM99") == Stops{2});
}

TEST_CASE("FANUC calls programs by name as well as by number", "[ipr][flow]") {
  const std::string subs = "\nM30\nO<Drill>\nG0 X#1\nM99\nO<other>\nG0 X9\nM99";
  CHECK(fanuc_way("O1\nG65 <DRILL> A1. L2\nM98 <Other>\nG0 X3" + subs) == Stops{1, 9, 3});
  CHECK(fanuc_way("O1\nN5 M98 < other > L2\nG0 X3" + subs) == Stops{9, 3});
  CHECK(fanuc_way("O1\n#1=4\nM98 <DRILL>\nIF [#1 EQ 5] GOTO 7\nG65 <DRILL> A#1 A5.\nN7" + subs) ==
        Stops{4, 5});
  ProgramFolder folder;
  folder.with("part.nc", "G0 X7\nM99\n");
  CHECK(way_of(folder.run("M98 <PART>\nM30\n", Dialect::fanuc)) == Stops{7});
}

TEST_CASE("of arguments of G65 with one letter the last counts", "[ipr][flow]") {
  const std::string sub = "\nM30\nO2\nG0 X#1\nX#4\nX#7\nM99";
  CHECK(fanuc_way("O1\nG65 P2 A1. A2. I3. I4." + sub) == Stops{2, 3, 4});
  CHECK(fanuc_way("O1\nG65 P2 D5 A1. I2. I6. D7 A3." + sub) == Stops{3, 2, 7});
}

TEST_CASE("a return leaves the subprogram whatever its label", "[ipr][flow]") {
  CHECK(way_of(interpret("o1 sub\nG0 X1\no5 if [1]\no5 return [3]\no5 endif\nX2\no1 endsub\n"
                         "o1 call\nG0 X#<_value>\nM2\n")) == Stops{1, 3});
  CHECK(reported_in_words("o1 if [1]\no1 return\no1 endif\nM2") ==
        Told{"2:1 SC2306 'o1 return' outside of 'o1 sub'"});
}

TEST_CASE("a call that cannot be read is reported, and leads nowhere", "[ipr][flow]") {
  CHECK(reported_in_words("M98\nG0 X1\nM30", Dialect::fanuc) ==
        Told{"1:1 SC2005 M98 needs P, the number of the subprogram"});
  CHECK(reported_in_words("G65 A1.\nM30", Dialect::fanuc) ==
        Told{"1:1 SC2005 G65 needs P, the number of the subprogram"});
  CHECK(reported_in_words("M98 P1 L1.5\nM30\nO1\nM99", Dialect::fanuc) ==
        Told{"1:8 SC2007 L takes a whole number from 0"});
  CHECK(reported_in_words("O1\nM99 P1.5\nO2\nM99", Dialect::fanuc) ==
        Told{"2:5 SC2007 P takes a whole number from 0"});
  CHECK(reported_in_words("O1\nM98 P2\nM30\nO2\nM99 P-1", Dialect::fanuc) ==
        Told{"5:5 SC2007 P takes a whole number from 0"});
}

TEST_CASE("what may be no label or argument of a call is reported", "[ipr][flow]") {
  const std::string sub = "o1 sub\no1 endsub\n";
  std::string call = "o1 call";
  for (int i = 1; i <= 30; ++i) call += " [" + std::to_string(i) + "]";
  CHECK(reported_in_words(sub + call + "\nM2").empty());
  CHECK(reported_in_words(sub + call + " [31]\nM2") ==
        Told{"3:150 SC1029 a call takes at most 30 arguments"});
  CHECK(reported_in_words("o[1.5] call\nM2") ==
        Told{"1:2 SC1029 a label is a whole number from 0"});
  CHECK(reported_in_words("o-1 call\nM2") == Told{"1:2 SC1029 a label is a whole number from 0"});
  CHECK(reported_in_words("o-1\nM2") == Told{"1:2 SC1029 a label is a whole number from 0"});
  CHECK(reported_in_words("o1 sub\no1 endsub\nG00 X1 o1 call\nM2") ==
        Told{"3:8 SC1029 'o1 call' after words: a statement begins its line"});
  CHECK(reported_in_words("o1 if [1]\nG00 X1 o1 endif\nM2") ==
        Told{"2:8 SC1029 'o1 endif' after words: a statement begins its line"});
  CHECK(reported_in_words("IF [1 EQ 1] THEN\nM2") ==
        Told{"1:16 SC1029 what THEN is to do is expected at the end of the line"});
  CHECK(reported_in_words("THEN #1=1\nM2") == Told{"1:1 SC1029 THEN without IF on its line"});
  CHECK(reported_in_words("o[-1] call\nM2") == Told{"1:2 SC1029 a label is a whole number from 0"});
  CHECK(reported_in_words("DO 1.2.3\nM30", Dialect::fanuc) ==
        Told{"1:4 SC1029 a label is a whole number from 0"});
}

TEST_CASE("a condition that fails in a later round is reported there, once", "[ipr][flow]") {
  const std::string failing = "[1/[2-#1] GT 0]", count = "#1=[#1+1]\nG0 X#1\n";
  CHECK(reported_in_words("o1 while " + failing + "\n" + count + "o1 endwhile\nG0 X?\nM2") ==
        Told{"1:13 SC1021 division by zero", "5:5 SC1001 unknown character '?'"});
  CHECK(reported_in_words("o1 do\n" + count + "o1 while " + failing + "\nG0 X?\nM2") ==
        Told{"4:13 SC1021 division by zero", "5:5 SC1001 unknown character '?'"});
}

TEST_CASE("an alarm to which an error may have led is not reported", "[ipr][flow]") {
  CHECK(reported_in_words("#1=[1/0]\no1 if [#1 GT 2]\n(ABORT,too large)\no1 endif\nG0 X--1\nM2") ==
        Told{"1:7 SC1021 division by zero", "5:5 SC1003 a sign inside the number '--1'"});
  CHECK(reported_in_words("#1=[1/0]\nIF [#1 GT 2] GOTO 9\nG0 X--1\nN9 #3000=1 (LARGE)\nM30",
                          Dialect::fanuc) ==
        Told{"1:7 SC1021 division by zero", "3:5 SC1003 a sign inside the number '--1'"});
  CHECK(reported_in_words(
            "o1 if [1/0]\n#2=1\no1 endif\no2 if [#2 EQ 1]\n(ABORT,it is)\no2 endif\nM2") ==
        Told{"1:10 SC1021 division by zero"});
  CHECK(reported_in_words("IF [1 EQ 1] GOTO 99\n#3000=1(NOT REACHED)\nN10 G0 X--1\nM30",
                          Dialect::fanuc) ==
        Told{"1:1 SC2308 no line N99 in the program", "3:9 SC1003 a sign inside the number '--1'"});
}

TEST_CASE("an alarm after an M code that could not be read is not reported", "[ipr][flow]") {
  CHECK(reported_in_words("M..9\n(ABORT,x)\nG0 Q1\nM2") ==
        Told{"1:2 SC1004 two decimal points in '..9'", "3:4 SC2004 unused word Q"});
  CHECK(reported_in_words("G0 X1 ? m30\n(ABORT,x)\nM2") ==
        Told{"1:7 SC1001 unknown character '?'"});
  CHECK(reported_in_words("G0 X--1\n(ABORT,x)\nM2") ==
        Told{"1:5 SC1003 a sign inside the number '--1'", "2:1 SC1031 the program aborts: x"});
}

TEST_CASE("an alarm to which no error has led is reported, and ends the program", "[ipr][flow]") {
  CHECK(reported_in_words("#1=[1/0]\nG0 X#1\n(ABORT,as always)\nG0 X--1\nM2") ==
        Told{"1:7 SC1021 division by zero", "3:1 SC1031 the program aborts: as always"});
}

TEST_CASE("a jump into a loop is reported at the jump, however often it jumps within",
          "[ipr][flow]") {
  const std::string loop =
      "WHILE [#1 LT 9] DO 1\nN5 #1=#1+1\nIF [#1 LT 4] GOTO 5\nIF [#1 LT 6] GOTO 6\nN6 #2=0\n"
      "END 1\nM30";
  const Told jump{"2:1 SC2304 the jump leads past 'DO 1' to before 'END 1'"};
  CHECK(reported_in_words("#1=0\nGOTO 5\n" + loop, Dialect::fanuc) == jump);
  CHECK(reported_in_words("#1=0\nGOTO 6\n" + loop, Dialect::fanuc) == jump);
  CHECK(reported_in_words("#1=0\n" + loop, Dialect::fanuc).empty());
}

TEST_CASE("an alarm of FANUC that cannot be read is reported", "[ipr][flow]") {
  CHECK(reported_in_words("#3000\nM30", Dialect::fanuc) ==
        Told{"1:5 SC1028 '=' and a value is expected at the end of the line"});
  CHECK(reported_in_words("#1=[1/0]\n#3000=#1\nM30", Dialect::fanuc) ==
        Told{"1:7 SC1021 division by zero"});
}

TEST_CASE("a branch after the last one is reported whichever is taken", "[ipr][flow]") {
  for (const std::string condition : {"1", "0"}) {
    CAPTURE(condition);
    const std::string begin = "o1 if [" + condition + "]\nG0 X1\no1 else\nG0 X2\n";
    CHECK(places(interpret(begin + "o1 else\no1 endif\nM2\n")) == Places{"SC2304 5:1"});
    CHECK(places(interpret(begin + "o1 elseif [1]\no1 endif\nM2\n")) == Places{"SC2304 5:1"});
    CHECK(places(interpret(begin + "o1 endif\nM2\n")).empty());
  }
}

TEST_CASE("a called file is found beside the program", "[ipr][flow]") {
  ProgramFolder folder;
  folder
      .with("pocket.ngc",
            "(comment)\no<pocket> sub\nG0 X#1\no<inner> call\no<pocket> endsub\n"
            "o<inner> sub\nG0 X8\no<inner> endsub\nM2\n")
      .with("100.nc", "o100 sub\nG0 X4\no100 endsub\n")
      .with("O0007.nc", "%\nO0007 (MACRO)\nG0 X#1\nM99\n%\n")
      .with("O1234", "G0 X6\nM99\n")
      .with("O0013.NC", "O0013\nG0 X9\nM99\n")
      .with("RIM.NGC", "o<rim> sub\nG0 X5\no<rim> endsub\nM2\n");
  CHECK(way_of(folder.run("o<Pocket> call [3]\no100 call\nG0 X0\nM2")) == Stops{3, 8, 4, 0});
  CHECK(way_of(folder.run("G65 P13\nM30\n", Dialect::fanuc)) == Stops{9});
  CHECK(way_of(folder.run("o<Rim> call\nM2\n")) == Stops{5});
  CHECK(way_of(folder.run("%\nO1\n#1=2\nM98 P7\nG65 P7 A3. L2\nM98 P1234\nM30\n%",
                          Dialect::fanuc)) == Stops{2, 3, 6});
}

TEST_CASE("the files that have been called are reported by their names", "[ipr][flow]") {
  ProgramFolder folder;
  folder.with("100.ngc", "o100 sub\nG0 X3\no100 endsub\n");
  InterpreterOptions options = in(Dialect::linuxcnc);
  options.folder = folder.path();
  Diagnostics diagnostics;
  Reader reader = Reader::from_text("o100 call\no100 call\nM2\n");
  Parser parser(reader, diagnostics);
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, options);
  while (interpreter.next()) {
  }
  REQUIRE(interpreter.called_files().size() == 1);
  CHECK(interpreter.called_files().front().name == "100.ngc");
  CHECK(interpreter.called_files().front().path == folder / "100.ngc");
}

TEST_CASE("a subprogram of the program itself comes before a file", "[ipr][flow]") {
  ProgramFolder folder;
  folder.with("a.ngc", "o<a> sub\nG0 X2\no<a> endsub\n");
  CHECK(way_of(folder.run("o<a> sub\nG0 X1\no<a> endsub\no<a> call\nM2")) == Stops{1});
}

TEST_CASE("what is wrong in a called file is reported with its name and line", "[ipr][flow]") {
  ProgramFolder folder;
  folder.with("bad.ngc", "o<bad> sub\nG0 X1\nG1 Y1\no<bad> endsub\n");
  const Interpreted result = folder.run("o<bad> call\no<bad> call\nG1 X5\nM2\n");
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics.front().file == folder / "bad.ngc");
  CHECK(places(result) == Places{"SC2102 3:1"});
  REQUIRE(result.blocks.size() >= 2);
  CHECK(result.blocks.front().source.line == 2);
  CHECK(result.blocks.front().source.file == 1);
  CHECK(result.blocks.back().source.file == 0);
}

TEST_CASE("a called file that cannot be read is SC6031, at the call", "[ipr][flow]") {
  ProgramFolder folder;
  std::filesystem::create_directory(folder / "dir.ngc");
  const Interpreted result = folder.run("o<dir> call\nM2\n");
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(render(result.diagnostics.front())
            .starts_with("softcnc:1:1: error: cannot read '" + folder / "dir.ngc" +
                         "': Is a directory [SC6031]\n"));
  CHECK(exit_status(result.diagnostics.front()) == 5);
}

TEST_CASE("a call does not lead out of the folder", "[ipr][flow]") {
  ProgramFolder folder;
  folder.with("a.ngc", "o<a> sub\nG0 X1\no<a> endsub\n");
  const std::string name = std::filesystem::path(folder.path()).filename();
  CHECK(places(folder.run("o<../" + name + "/a> call\nM2\n")) == Places{"SC2301 1:1"});
}

TEST_CASE("what a subprogram that is missing would have done is not missed", "[ipr][flow]") {
  const std::string missing = "1:1 SC2301 no subprogram O1000 in this program";
  CHECK(reported_in_words("M98 P1000\nG1 X1\nX[1/#100] Y[1/#1]\nG0 X[1/#5420] F#<_depth>\nM2") ==
        Told{missing});
  CHECK(reported_in_words("M98 P1000\nX1\nM6\nM3\nM72\nM2") == Told{missing});
  CHECK(reported_in_words("#1=0\no<init> call\n#2=[1/#<_depth>]\n#3=[1/#1]\nM2") ==
        Told{"2:1 SC2301 no subprogram o<init> in this program", "4:7 SC1021 division by zero"});
}

TEST_CASE("a subprogram whose beginning cannot be read is not missed", "[ipr][flow]") {
  CHECK(reported_in_words("o1 subx\nG0 X1\no1 endsub\no1 call\nM2").size() == 1);
}

TEST_CASE("an error in a loop is reported once", "[ipr][flow]") {
  CHECK(reported_in_words("o1 repeat [100]\nG1 X1\nG0 X1 Q1\no1 endrepeat\nM2") ==
        Told{"2:1 SC2102 G01 needs a feed, and F is not set", "3:7 SC2004 unused word Q"});
  CHECK(reported_in_words("N1 G0 X1 Q1\nGOTO 1\nM2").size() == 2);
}

TEST_CASE("a subprogram that is missing within a curve leaves the curve in force", "[ipr][flow]") {
  CHECK(reported_in_words("F100\nG06.2 P2 K0 X0\no<gone> call\nK0 X1\nK1\nK1\nM2") ==
        Told{"3:1 SC2301 no subprogram o<gone> in this program"});
  CHECK(reported_in_words("F100\nG05.2 X1 Y1 P1\no<gone> call\nX2 Y1 P1\nX3 Y2 P1\nG05.3\nM2") ==
        Told{"3:1 SC2301 no subprogram o<gone> in this program"});
}

TEST_CASE("the search for many things that are missing comes to an end", "[ipr][flow]") {
  std::string ifs, definitions, jumps;
  for (int i = 1; i <= 100; ++i) {
    const std::string label = std::to_string(i);
    ifs += "o" + label + " if [0]\n";
    definitions += "o" + label + " sub\n";
    jumps += "GOTO " + std::to_string(1000 + i) + "\n";
  }
  const auto first = [&](int last, const auto& message) {
    Told all;
    for (int i = 1; i <= last; ++i)
      all.push_back(std::to_string(i) + ":1 " + message(std::to_string(i)));
    return all;
  };
  // 100 lines after the first, 99 after the second, ... 90 after the eleventh
  CHECK(reported_in_words(ifs + "M2") == first(11, [](const std::string& label) {
          return "SC2302 'o" + label + " if' has no 'o" + label + " endif'";
        }));
  CHECK(reported_in_words(definitions + "M2") == first(11, [](const std::string& label) {
          return "SC2303 'o" + label + " sub' has no 'o" + label + " endsub'";
        }));
  CHECK(reported_in_words(jumps + "M30", Dialect::fanuc) ==  // 101 lines for each
        first(10, [](const std::string& label) {
          return "SC2308 no line N" + std::to_string(1000 + std::stoi(label)) + " in the program";
        }));
}

TEST_CASE("a loop without end is reported, and ends the program", "[ipr][flow]") {
  CHECK(reported_in_words("o1 while [1]\no1 endwhile\nG0 X1 Q1\nM2") ==
        Told{"1:1 SC2310 'o1 while' has run more than 1000 blocks"});
  CHECK(reported_in_words("o1 do\nG0 X1\no1 while [1]\nM2") ==
        Told{"1:1 SC2310 'o1 do' has run more than 1000 blocks"});
  CHECK(reported_in_words("o1 repeat [1000000]\no1 endrepeat\nM2") ==
        Told{"1:1 SC2310 'o1 repeat' has run more than 1000 blocks"});
  CHECK(reported_in_words("DO 1\nEND 1\nM30", Dialect::fanuc) ==
        Told{"1:1 SC2310 'DO 1' has run more than 1000 blocks"});
  CHECK(reported_in_words("G0 X1\nN5 G0 X2\nGOTO 5\nM30", Dialect::fanuc) ==
        Told{"3:1 SC2310 jumping back to line 2 has run more than 1000 blocks"});
  CHECK(reported_in_words("O1\nN5 G0 X2\nM99 P5", Dialect::fanuc) ==
        Told{"3:1 SC2310 jumping back to line 2 has run more than 1000 blocks"});
  CHECK(reported_in_words("O1\n#100=#100+1\nIF [#100 LT 0] GOTO 9\nM99\nN9 M30", Dialect::fanuc) ==
        Told{"4:1 SC2310 the program, which M99 starts again, has run more than 1000 blocks"});
  CHECK(reported_in_words("O1\nM98 P2 L9999\nM30\nO2\nG0 X1\nM99", Dialect::fanuc) ==
        Told{"2:1 SC2310 the call of O2 has run more than 1000 blocks"});
  CHECK(reported_in_words(
            "o1 sub\no2 if [#1 GT 0]\no1 call [#1-1]\no1 call [#1-1]\no2 endif\no1 endsub\n"
            "o1 call [40]\nM2") ==
        Told{"7:1 SC2310 the call of 'o1 sub' has run more than 1000 blocks"});
}

TEST_CASE("programs of FANUC have numbers after a colon, names and a title", "[ipr][flow][fanuc]") {
  const auto told_in_fanuc = [](const std::string& text) {
    return reported_in_words(text, Dialect::fanuc);
  };
  CHECK(told_in_fanuc("% TITLE (1\nO0001\nG0 X1\nM30\n%").empty());
  CHECK(told_in_fanuc("%\n:0001\nM98 P2\nM30\n:0002 (two)\nG0 X1\nM99\n%").empty());
  CHECK(told_in_fanuc("O<TEST>\nG0 X1\nM30").empty());
  CHECK(told_in_fanuc("<PART-1> (a part)\nM98 P2\nM30\nO2\nM99\n<B>\nM99").empty());
  CHECK(told_in_fanuc("<PART-1> X5\nM30") == Told{"1:1 SC1001 '<' has no place here"});
  CHECK(told_in_fanuc("G0 X1 :2\nM30") == Told{"1:7 SC1001 unknown character ':'"});
  CHECK(reported_in_words("% TITLE\nM2").size() == 1);
  CHECK(reported_in_words(":0001\nM2").size() == 1);
  CHECK(reported_in_words("<A>\nM2").size() == 1);
}

TEST_CASE("blocks of cycles count as lines of a loop", "[ipr][flow]") {
  const std::string drill = "G83 X1. Y1. Z-10. R1. Q0.1";
  const std::string start = "G21 G90 F100 G0 Z5.\n";
  CHECK(reported_in_words(start + "N10 " + drill + "\nGOTO 10\nM30", Dialect::fanuc) ==
        Told{"3:1 SC2310 jumping back to line 2 has run more than 1000 blocks"});
  CHECK(reported_in_words(start + "o1 repeat [5]\n" + drill + "\no1 endrepeat\nM2") ==
        Told{"2:1 SC2310 'o1 repeat' has run more than 1000 blocks"});
  std::string plain = start;
  for (int i = 0; i < 20; ++i) plain += drill + "\n";
  CHECK(reported_in_words(plain + "#1=0\nN5 #1=#1+1\nIF [#1 LT 5] GOTO 5\nM30", Dialect::fanuc)
            .empty());
}

TEST_CASE("a program that M99 starts again without end is run once", "[ipr][flow]") {
  const std::string once =
      " SC2172 M99 starts the program again, and nothing in the program would end that; it is run "
      "once";
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc}) {
    CHECK(reported_in_words("O1\nG0 X2\nM99", dialect) == Told{"3:1" + once});
    CHECK(reported_in_words("G0 X2\nM98 P2 L3\nM99\nO2\nG0 X1\nM99", dialect) ==
          Told{"3:1" + once});
    CHECK(reported_in_words("G0 X#1\n#1=[#1+1]\nM98 P2\nM99\nO2\nG0 X1\nM99", dialect) ==
          Told{"4:1" + once});
  }
  // A condition that no pass changes
  CHECK(reported_in_words("O9\nIF [#1 EQ #0] GOTO 5\nG0 X#1\nN5 G0 X1\nM99", Dialect::fanuc) ==
        Told{"5:1" + once});
  const auto run = interpret("O1\nG91 G0 X2\nG0 X3\nM99", {}, in(Dialect::fanuc));
  REQUIRE(run.blocks.size() == 3);
  CHECK(std::get<Action>(run.blocks[2].what).kind == Action::Kind::end);
}

TEST_CASE("a program that M99 starts again ends where a value says so", "[ipr][flow]") {
  const std::string counts = "\nM99\nN9 M30";
  CHECK(fanuc_way("#100=#100+1\nG0 X#100\nIF [#100 GE 3] GOTO 9" + counts) == Stops{1, 2, 3});
  CHECK(fanuc_way("G91 G0 X1\nIF [#5041 GT 2.5] GOTO 9" + counts) == Stops{1, 2, 3});
  CHECK(fanuc_way("G91 G0 X1.\n#1=#1+1\nGOTO [8+FIX[#1/3]]\nN8 G0 X0.5" + counts) ==
        Stops{1, 1.5, 2.5, 3, 4});
  CHECK(places_along_x("#<_n>=[EXISTS[#<_n>]]\nG91 G0 X1\no1 if [#<_x> GE 2]\nM2\no1 endif\nM99") ==
        Stops{1, 2});
  CHECK(fanuc_way("G91 G0 X1\n#1=#1+1\nM98 P#1\nM99\nO1\nG0 X5\nM99\nO2\nM30") == Stops{1, 6, 7});
}

TEST_CASE("a loop may run as many lines as the limit says", "[ipr][flow]") {
  CHECK(reported_in_words(
            "o1 repeat [499]\nG0 X1\no1 endrepeat\no2 repeat [499]\nG0 X1\no2 endrepeat\nM2")
            .empty());
  std::string plain = "o1 sub\nG0 X1\no1 endsub\no1 call\n";
  for (int i = 0; i < 5000; ++i) plain += "G0 X1\n";
  CHECK(reported_in_words(plain + "M2").empty());
}

TEST_CASE("calls may be 64 deep", "[ipr][flow]") {
  const std::string sub = "o1 sub\no2 if [#1 GT 1]\no1 call [#1-1]\no2 endif\nG0 X#1\no1 endsub\n";
  CHECK(places_along_x(sub + "o1 call [64]\nM2").size() == 64);
  CHECK(reported_in_words(sub + "o1 call [65]\nM2") ==
        Told{"3:1 SC2309 more than 64 calls within each other; 'o1 sub' is among them 64 times"});
}

}  // namespace softcnc::ipr
