// SPDX-License-Identifier: MIT
// One letter or digit that is wrong is one error, whatever else it makes of its line and of those
// behind it; what is wrong beside it is told all the same.
#include <catch2/catch.hpp>

#include "ipr/told.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

namespace {

Places told_of_commands(std::string text) {
  return places(interpret(std::move(text), Machine{}, InterpreterOptions{}));
}

}  // namespace

TEST_CASE("a word given twice may be any that is missing", "[ipr][consequences]") {
  CHECK(told("G0 X1\nX6.2 P2 F500 K0 X0 Y0") == Places{"SC2003 2:17"});
  CHECK(told("G1 F9 X1\nI2 X50 Y45 I5 J0") == Places{"SC2003 2:12"});
  CHECK(told("G1 X5 X100") == Places{"SC2003 1:7"});
  CHECK(told("F9\nG6.2 Y3 K0 X0 Y0\nK0 X1 Y1\nK1 X2\nK1\nK1\nK1") == Places{"SC2003 2:15"});
  CHECK(told("G0 X1 X2 Q5") == Places{"SC2003 1:7", "SC2004 1:10"});
}

TEST_CASE("an O before words may be the letter of their code", "[ipr][consequences]") {
  CHECK(told("G1 F9 X1\nO3 X0 Y10 I-10 J0") == Places{"SC2006 2:4"});
  CHECK(told("O0 X5 Y5") == Places{"SC2006 1:4"});
  CHECK(told("O3 S500\nG95 F1\nG1 X1") == Places{"SC2006 1:4"});
  CHECK(told("O7777 G0 X1\nY1 Q3") == Places{"SC2006 1:7", "SC2004 2:4"});
}

TEST_CASE("of two codes of a group nobody knows which is meant", "[ipr][consequences]") {
  CHECK(told("F9\nG5 G1 X10\nX0\nX1") == Places{"SC2002 2:4"});
  CHECK(told("F9\nG6.2 P2 K-1 G0\nX5\nK-.5\nG6.2 P2 K0 X1\nK0 X2\nK1\nK1") ==
        Places{"SC2002 2:13"});
  CHECK(told("G0 G1 X10\nG1 Q1 X2 F9") == Places{"SC2002 1:4", "SC2004 2:4"});
}

TEST_CASE("an unknown code may be another word of its line", "[ipr][consequences]") {
  CHECK(told("G3 F9 X1 I.5\nM28 Y-1") == Places{"SC2001 2:1"});
  CHECK(told("G3 F9 X1 I.5\nG0 X0\nG3 X1 I.5\nG0 8X0 Y0") == Places{"SC2001 4:1"});
  CHECK(told("G70\nM72") == Places{"SC2001 1:1"});
  CHECK(told("M100\nG1 X1") == Places{"SC2001 1:1"});
  CHECK(told("M99.5\nG1 X1") == Places{"SC2001 1:1", "SC2102 2:1"});
  CHECK(
      told(
          "F9\nG682 P3 X0 Y0 R1 K0\nG6.2 X1 K0\nG6.2 X2 K0\nG6.2 K1\nG6.2 K1\nG6.2 K1\nG0 X1 Q2") ==
      Places{"SC2001 2:1", "SC2004 8:7"});
}

TEST_CASE("a block of a curve without its knot has no other error", "[ipr][consequences]") {
  const std::string f = "F9\n";
  CHECK(told(f + "G6.2 X0 Y1 P1 L3\nX2 Y2 P1\nX2 Y0 P1\nG0 X1") == Places{"SC3102 2:1"});
  const std::string begin = f + "G6.2 P2 K0 X0\n";
  CHECK(told(begin + "Y5 R0 X2\nK1\nK1") == Places{"SC3102 3:1"});
  CHECK(told(begin + "K0 X1\nR2\nK1") == Places{"SC3102 4:1"});
  CHECK(told(begin + "Z0 X12\nK1\nK1") == Places{"SC3102 3:1"});
  CHECK(told(begin + "K0 X1\ny1\nK1\nG6.2 P2 K0 X1 Y0\nK0 X2\nK1\nK1") == Places{"SC3102 4:1"});
  CHECK(told(begin + "X12\nX13\nK1\nK1") == Places{"SC3102 3:1", "SC3102 4:1"});
}

TEST_CASE("F within a curve where the next one begins is its own", "[ipr][consequences]") {
  const std::string begin = "F9\nG6.2 P2 K-1 X0\nK-1 X1\nK0\n";
  CHECK(told(begin + "G6.2 P3 K0 X1 F9\nK0 X2\nK0 X3\nK1\nK1\nK1") == Places{"SC3104 5:1"});
  CHECK(told("G6.2 P4 K0 X0 F9\nG6.2 P4 K0 X0 F9\nK0 X1\nK0 X2\nK0 X3\nK1\nK1\nK1\nK1") ==
        Places{"SC3110 2:15"});
  CHECK(told("F9\nG6.2 P2 K0 X0 F0\nK0 X1 Y0\nK1\nK1") == Places{"SC2102 2:15"});
}

TEST_CASE("words that no code takes are told once while none of them changes",
          "[ipr][consequences]") {
  CHECK(told("G1 F9 X1\nG52. P1 L3\nX5 Y3 P1\nX2 P2\nG1 P2") == Places{"SC2004 2:6", "SC2004 5:4"});
  CHECK(told("T6.2 P3 K0 X0 Y0") == Places{"SC2007 1:1"});
  CHECK(told("G0 X0\nM3 S100 P5\nG54 P5\nG17 P5") ==
        Places{"SC2004 2:9", "SC2004 3:5", "SC2004 4:5"});
  CHECK(told("G0 X0\nP5\nG4 P1 R7\nG92 X1 P5") == Places{"SC2004 2:1", "SC2004 3:7", "SC2004 4:8"});
}

TEST_CASE("an end whose letter is wrong may be one", "[ipr][consequences]") {
  CHECK(told("G0 X1\nH2\n(ABORT,not behind the end)") == Places{"SC2004 2:1"});
  CHECK(told("G0 X1\nQ30\nthis is never read (nor this") == Places{"SC2004 2:1"});
  CHECK(told("G0 X1\nQ31\n(ABORT,here)") == Places{"SC2004 2:1", "SC1031 3:1"});
}

TEST_CASE("digits around the letter of a code may be those of another", "[ipr][consequences]") {
  const std::string arc = "\nF9\nG3 Y20 Z0 J10 K0";
  CHECK(told("1G9" + arc) == Places{"SC1007 1:1"});
  CHECK(told("G1G9" + arc) == Places{"SC2001 1:3"});
  CHECK(told("G21 G90 /19" + arc) == Places{"SC1011 1:9"});
  CHECK(told("1G7" + arc) == Places{"SC1007 1:1"});
}

TEST_CASE("a fault right behind another one is of the same mistake", "[ipr][consequences]") {
  CHECK(told("M2e)") == Places{"SC1006 1:1"});
  CHECK(told("#1=1-#2=2") == Places{"SC1017 1:4"});
  CHECK(told("G06.*") == Places{"SC1001 1:5"});
  CHECK(told("G6]2 K1") == Places{"SC1017 1:3"});
  CHECK(told("M98 P2#000 L3", Dialect::fanuc) == Places{"SC1028 1:12"});
  CHECK(told("G0 Z-qrt[4]") == Places{"SC1002 1:5"});
  CHECK(told("G0 X[1 AND 0]  OR 0]") == Places{"SC1002 1:16"});
  CHECK(told("G0 X1.2.3 Y1.2.3") == Places{"SC1004 1:5", "SC1004 1:12"});
  CHECK(told("G0 X1 hello G1 X9 (") == Places{"SC1020 1:7"});
}

TEST_CASE("a keyword or a label with a stray character is the one that is meant",
          "[ipr][consequences]") {
  const std::string branch = "o1 if [1]\nG0 X1\n";
  for (const std::string end : {"e9ndif", "e-dif", "e.ndif", "en dif"}) {
    CAPTURE(end);
    CHECK(told(branch + "o1 " + end).size() <= 1);
  }
  const std::string sub = "o100 sub\nG0 X1\n";
  CHECK(told(sub + "o100 e.ndsub\no100 call") == Places{"SC1020 3:6"});
  CHECK(told(sub + "o10I0 endsub\no100 call") == Places{"SC1020 3:4"});
  CHECK(told("o<down> sub\nG0 X1\no<dow>n endsub\no<down> call") == Places{"SC1020 3:7"});
  CHECK(told("o<down> sub\nG0 X1\no<down> endsub\neo<down> call") == Places{"SC1002 4:1"});
  CHECK(told(branch + "o2 e.ndif") == Places{"SC1020 3:4", "SC2302 1:1"});
}

TEST_CASE("an assignment whose number runs into its value leaves both open",
          "[ipr][consequences]") {
  CHECK(told("F9\n#510\nG3 X0 Y#5 I[-#5] J0") == Places{"SC1028 2:4"});
  CHECK(told("F9\n#5=1\nG3 X0 7#5 I[-#5] J0") == Places{"SC1028 3:11"});
  CHECK(told("F9\n#510\nG0 X[1/#6]") == Places{"SC1028 2:4", "SC1021 3:8"});
  CHECK(told("#1=10 210=25\nG0 X#1\nG0 Y#210") == Places{"SC1001 1:10"});
}

TEST_CASE("a curve whose first block could not be read goes on in its second one",
          "[ipr][consequences]") {
  const std::string rest =
      "G6.2 P3 X0 Y10 R0.7 K0\nG6.2 P3 X10 Y10 K0\nG6.2 K1\nG6.2 K1\nG6.2 K1\nG1 X0\n";
  CHECK(told("F9\nG6.2# P3 X0 Y0 K0\n" + rest) == Places{"SC1018 2:7"});
  CHECK(told("F9\nG6.2 P-- X0 Y0 K0\n" + rest) == Places{"SC1003 2:7"});
  CHECK(told("F9\nG6.2 P3 X0 Y0 K0\n" + rest).empty());
}

TEST_CASE("a number with a blank may hide the letter of the feed", "[ipr][consequences]") {
  CHECK(told("G1 X2 100") == Places{"SC2102 1:1"});
  CHECK(told("G1 X2") == Places{"SC2102 1:1"});
  CHECK(told("G21 O500\nG1 X2") == Places{"SC2006 1:5"});
  CHECK(told("G1 X20 3000\nF9\nG1 Y1\nG2 X0 R5") == Places{"SC2102 1:1"});
  CHECK(told("G93\nG1 X20 F3\nX60 3000\nY1 F3") == Places{"SC2102 3:1"});
}

TEST_CASE("commands with a wrong letter are commands all the same", "[ipr][consequences]") {
  for (const std::string feed : {"f3 00", "f 3J0", "O 1200"}) {
    CAPTURE(feed);
    CHECK(told_of_commands(feed + "\nl 20 0\npcw 10 0 5 0\n").size() == 1);
  }
  CHECK(told_of_commands("f 9\ns 3\n1 1\nJ0\n2 2\n3 1\n") == Places{"SC1050 4:1"});
  CHECK(told_of_commands("f 9\nl -o0 10\nl 1 1\n") == Places{"SC1002 2:3"});
}

TEST_CASE("lines that may be of either language leave that to the next one",
          "[ipr][consequences]") {
  CHECK(told_of_commands("f 1M00\nl 20 0\npcw 10 0 5 0\n").size() == 1);
  CHECK(told_of_commands("l 20 M\nl 5 5\npcw 10 0 5 0\nf 9\n").front() == "SC1053 1:6");
  CHECK(told_of_commands("/F 600\nL 10, 5\nPCW 10,0,5,0\n") == Places{"SC1001 1:1"});
  CHECK(told_of_commands("f 9\ns N\n1 1\n2 2\n3 1\nl 4 2\n") == Places{"SC1053 2:3"});
  CHECK(told_of_commands("f 9\nG 20 0\npcw 10 0 5 0\nl 1 1\n") == Places{"SC1050 2:1"});
  CHECK(told_of_commands("f\nl 20 0\nl 0 10\ndcw 0 90 5\n") == Places{"SC1052 1:1"});
  CHECK(told_of_commands("f 3O00\nl 2O 0\nl 1 1\npcw 10 0 5 0\n") ==
        Places{"SC1053 1:4", "SC1053 2:4"});
  CHECK(told("/F 600\nG0 X1\n").empty());
  CHECK(told("S6000 03\nG0 X1\nG0 X2").size() == 1);
  CHECK(told("S1000\n903\nG0 X1\nG0 X2").size() == 1);
}

TEST_CASE("what one line lacks is told where it is met first", "[ipr][consequences]") {
  CHECK(told("G93\nG1 X1\nX2\nX3 F1\nX4") == Places{"SC2102 2:1", "SC2102 5:1"});
  CHECK(told("M70\nG1 X1\nM72\nG1 X2") == Places{"SC2102 2:1"});
  CHECK(told("M70\nG1 X1 F9\nM72\nG1 X2") == Places{"SC2102 4:1"});
  CHECK(told("G95 F9\nM70\nG1 X1\nM72\nG1 X2") == Places{"SC2222 3:1"});
  CHECK(told("o7 call\no7 call") == Places{"SC2301 1:1"});
  CHECK(told("F9\nG2 X5 K1\nG3 X1 K1\nG17 G3 X2 K1") == Places{"SC2105 2:7", "SC2105 4:11"});
  CHECK(told("o1 sub\no1 sub\nG0 X1\no1 endsub\no1 call") == Places{"SC2314 2:1"});
}

TEST_CASE("behind an end that cannot be read prose and rulers are not told",
          "[ipr][consequences]") {
  for (const std::string end : {"M22", "M/", "M62"})
    CHECK(told("G0 X1\n" + end + "\n===\nthis is prose\nG0 X1..2").size() == 2);
}

TEST_CASE("a digit on the wrong side of a letter leaves the word before it open",
          "[ipr][consequences]") {
  CHECK(told("F9\nG03 0X. Y30. R10.") == Places{"SC1002 2:7"});
  CHECK(told("F9\nG6.2 P2 K0 X0 Y0\nK1 1X. Y0\nK2 X2\nK2\nK2") == Places{"SC1002 3:6"});
}

TEST_CASE("what a code leaves behind that cannot act on its line is told once",
          "[ipr][consequences]") {
  CHECK(told("G80 X1\nX2") == Places{"SC2101 1:5"});
  CHECK(told("G21 G90 100\nG1 X1") == Places{"SC2001 1:5"});
}
