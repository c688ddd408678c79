// SPDX-License-Identifier: MIT
// What follows from an error that has been told is not told, and nothing else is lost for it.
#include <catch2/catch.hpp>

#include "ipr/told.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

TEST_CASE("a variable whose assignment is broken has no known value", "[ipr][consequences]") {
  CHECK(told("#1=[3+4\nG00 X[1/#1]") == Places{"SC1017 1:4"});
  CHECK(told("#1=SINE[3]\nG00 X[1/#1]") == Places{"SC1018 1:4"});
  CHECK(told("#5=1.2.3\nG00 X[1/#5]") == Places{"SC1004 1:4"});
  CHECK(told("#1==5\nG00 X[1/#1]") == Places{"SC1016 1:4"});
  CHECK(told("#<a> 5\nG00 X#<a>") == Places{"SC1028 1:6"});
  CHECK(told("##1=4\nG00 X[1/#3]") == Places{"SC1025 1:1"});
  CHECK(told("IF [1 EQ 1] THN #2=1\nG00 X[1/#2]") == Places{"SC1029 1:13"});
  CHECK(told("? #2=1\nG00 X[1/#2]") == Places{"SC1001 1:1"});
  CHECK(told("G10 L2 P1 X--5\nG00 X[1/#5221]") == Places{"SC1003 1:12"});
  CHECK(told("#5003=0 ?\n#5003=1 ?\nG00 X[1/#5003]") == Places{"SC1001 1:9", "SC1001 2:9"});
}

TEST_CASE("a variable that a broken line does not assign to keeps its value",
          "[ipr][consequences]") {
  CHECK(told("#1=0\n#2=[3+4\nG00 X[1/#1]") == Places{"SC1017 2:4", "SC1021 3:9"});
  CHECK(told("? #<b>=1\nG00 X#<a>") == Places{"SC1001 1:1", "SC1024 2:6"});
}

TEST_CASE("a loop that a broken assignment would have ended does not run on",
          "[ipr][consequences]") {
  CHECK(told("#1=1\no1 while [#1 LT 5]\n#1=[#1+1\no1 endwhile") == Places{"SC1017 3:4"});
  CHECK(told("o<f> sub\no1 if [#1 GT 0\no<f> call [#1-1]\no1 endif\no<f> endsub\no<f> call [4]") ==
        Places{"SC1017 2:7"});
}

TEST_CASE("behind a broken expression in brackets the line is read on", "[ipr][consequences]") {
  CHECK(told("G00 X[1+] Y1.2.3 Q5") == Places{"SC1016 1:9", "SC1004 1:12", "SC2004 1:18"});
  CHECK(told("#1=[1+] #2=[2+]\nG00 X[1/#1]") == Places{"SC1016 1:7", "SC1016 1:15"});
  CHECK(told("G00 X[ATAN[1+]/[2]] Y..1") == Places{"SC1016 1:14", "SC1004 1:22"});
  CHECK(told("G00 X[1+ Y1.2.3") == Places{"SC1018 1:10"});
}

TEST_CASE("an operation without brackets is told once, with a bracket at its end too",
          "[ipr][consequences]") {
  CHECK(told("#1=1\nG0 X#1+2] Y..1") == Places{"SC1017 2:5", "SC1004 2:12"});
  CHECK(told("#1=1\nG0 X#1+2 ]") == Places{"SC1017 2:5"});
}

TEST_CASE("a code of any size is only one that there is not", "[ipr][consequences]") {
  CHECK(told("G[10**308] X1") == Places{"SC2001 1:1"});
  CHECK(told("G[-10**308] X1") == Places{"SC2001 1:1"});
}

TEST_CASE("a condition without brackets and a loop without its number are told as such",
          "[ipr][consequences]") {
  CHECK(told("N10 IF (#1 GT 0) GOTO 10", Dialect::fanuc) == Places{"SC1029 1:5"});
  CHECK(told("IF THEN #1=2", Dialect::fanuc) == Places{"SC1029 1:1"});
  CHECK(told("WHILE [1 EQ 2] DO1\nEND1\nDO", Dialect::fanuc) == Places{"SC1029 3:1"});
  CHECK(told("WHILE [1 EQ 2] DO1\nEND1\nEND #1", Dialect::fanuc) == Places{"SC1029 3:1"});
}

TEST_CASE("where a refused probing move would have ended is not known", "[ipr][consequences]") {
  CHECK(told("G38.2 Z-5 F100\no1 while [#5070 EQ 0]\nG0 X1\no1 endwhile") == Places{"SC2001 1:1"});
  CHECK(told("G38.2 Z-5 F100\n#1=[1/#5063]") == Places{"SC2001 1:1"});
  CHECK(told("G38.2 Z-5 F100\n#5070=0\n#1=[1/#5070]") == Places{"SC2001 1:1", "SC1021 3:7"});
  CHECK(told("#1=[1/#5063]") == Places{"SC1021 1:7"});
  CHECK(told("G31 Z-5 F100\nG0 X#5061", Dialect::fanuc) == Places{"SC2001 1:1"});
  CHECK(told("G0 X#5061", Dialect::fanuc) == Places{"SC1025 1:5"});
}

TEST_CASE("an argument that cannot be read has no known value", "[ipr][consequences]") {
  const std::string subprogram = "\nM30\nO1\n#3=[1/#2]\nM99";
  CHECK(told("G65 P1 A1 B2..0" + subprogram, Dialect::fanuc) == Places{"SC1004 1:12"});
  CHECK(told("G65 P1 A1" + subprogram, Dialect::fanuc) == Places{"SC1021 4:7"});
}

TEST_CASE("what a call would have done that cannot be made is not known", "[ipr][consequences]") {
  CHECK(told("M98\nX3") == Places{"SC2005 1:1"});
  CHECK(told("M98 P1.5\nG01 X3") == Places{"SC2007 1:5"});
}

TEST_CASE("a statement that cannot be read may have begun or ended what is open",
          "[ipr][consequences]") {
  CHECK(told("?o2 repeat [6]\nG00 X1\no2 endrepeat") == Places{"SC1001 1:1"});
  CHECK(told("oO1 sub\nG00 X1\no1 endsub") == Places{"SC1029 1:2"});
  CHECK(told("o sub\nG00 X1\no endsub") == Places{"SC1002 1:1", "SC1002 3:1"});
  CHECK(told("o1.2.3 while [1]\no1 endwhile") == Places{"SC1004 1:2"});
  CHECK(told("o  if [1]") == Places{"SC1002 1:1"});
  CHECK(told("IF 1 EQ 2 GOTO 99") == Places{"SC1017 1:4"});
}

TEST_CASE("a keyword that is none is told where it stands, whether its branch is run or not",
          "[ipr][consequences]") {
  CHECK(told("o1 if [0]\nG00 X1\no1 elsif [1]\nG00 X1..2\no1 endif") ==
        Places{"SC1020 3:4", "SC1004 4:6"});
  CHECK(told("o1 if [1]\nG00 X1\no1 els\nG00 X1..2\no1 endif") ==
        Places{"SC1020 3:4", "SC1004 4:6"});
  CHECK(told("o1 if [0]\nG00 X1\no1 endiff\nG00 X1..2") == Places{"SC1020 3:4", "SC1004 4:6"});
  CHECK(told("o1 while [0]\nG00 X1\no1 endwhil") == Places{"SC1020 3:4"});
  CHECK(told("o1 while [1]\no1 continue\no1 endwhil") == Places{"SC1020 3:4"});
  CHECK(told("o1 while [1]\nM30\no1 endwhil") == Places{"SC1020 3:4"});
  CHECK(told("o7 sub\nG00 X1\no7 endsb\nG00 X1..2") == Places{"SC1020 3:4", "SC1004 4:6"});
  CHECK(told("o7 call\no7 sub\nG00 X1\no7 endsb\nG00 X1..2") == Places{"SC1020 4:4", "SC1004 5:6"});
}

TEST_CASE("a line number that cannot be read may be the one a jump looks for",
          "[ipr][consequences]") {
  CHECK(told("GOTO 10\nN10.. G00") == Places{"SC1004 2:2"});
  CHECK(told("GOTO 99\n?N99 G00 X1") == Places{"SC1001 2:1"});
  CHECK(told("GOTO 98\n?N99 G00 X1") == Places{"SC2308 1:1", "SC1001 2:1"});
}

TEST_CASE("behind a G code that cannot be read it is not known what it has set",
          "[ipr][consequences]") {
  const std::string f = "F100\n";
  CHECK(told(f + "G..18\nG02 X10 I5 K5") == Places{"SC1004 2:2"});
  CHECK(told(f + "Gl8\nG02 X10 I5 K5") == Places{"SC1002 2:1"});
  CHECK(told(f + "G[18\nG02 X10 I5 K5") == Places{"SC1017 2:2"});
  CHECK(told(f + "G1,8\nG02 X10 I5 K5") == Places{"SC1001 2:3"});
  CHECK(told(f + "G9l\nG02 X1 Y1 I1 J0\nX1 Y1 I1 J0") == Places{"SC1002 2:3"});
  CHECK(told(f + "G..2 X10 I5\nG02 X20 Y1 I5") == Places{"SC1004 2:2"});
  CHECK(told("G..93\nG01 X1") == Places{"SC1004 1:2"});
  CHECK(told(f + "G41.1 D2\nG01 X10\nG..40\nG53 G00 X0") == Places{"SC1004 4:2"});
  CHECK(told("G01 X#<_plane> F100\nG..18\nX[1/[#<_plane>-170]]") == Places{"SC1004 2:2"});
}

TEST_CASE("codes of one group leave open which of them is in force", "[ipr][consequences]") {
  const std::string f = "F100\n";
  CHECK(told(f + "G17 G18\nG02 X10 I5 K5") == Places{"SC2002 2:5"});
  CHECK(told(f + "G20 G21\nG02 X1 Y1 I1 J0\nX1 Y1 I1 J0") == Places{"SC2002 2:5"});
  CHECK(told("G93 G94\nG01 X1") == Places{"SC2002 1:5"});
  CHECK(told("M03 M04\nS1000 G95 F.1\nG01 X1") == Places{"SC2002 1:5"});
  CHECK(told("MO3\nS1000 G95 F.1\nG01 X1") == Places{"SC1002 1:1"});
}

TEST_CASE("a G code that cannot be read leaves in force what it cannot have set",
          "[ipr][consequences]") {
  const std::string f = "G01 F100\n";
  CHECK(told(f + "G..18\nX10 Q1") == Places{"SC1004 2:2", "SC2004 3:5"});
  CHECK(told(f + "G..20\nG02 X10 I5 K5") == Places{"SC1004 2:2", "SC2105 3:12"});
  CHECK(told(f + "G..18\nG17\nG02 X10 I5 K5") == Places{"SC1004 2:2", "SC2105 4:12"});
  CHECK(told(f + "M777\nX10 Q1") == Places{"SC2001 2:1", "SC2004 3:5"});
}

TEST_CASE("words of a cycle that cannot be read are not missing", "[ipr][consequences]") {
  const std::string begin = "F100\nG81 X1 ";
  CHECK(told(begin + "Z--1 R1\nX2") == Places{"SC1003 2:9"});
  CHECK(told(begin + "Z[1/0] R1\nX2") == Places{"SC1021 2:12"});
  CHECK(told(begin + "ZO R1\nX2") == Places{"SC1002 2:8"});
  CHECK(told(begin + "? Z-1 R1\nX2") == Places{"SC1001 2:8"});
  CHECK(told(begin + "Z-1 R1\nG82 X2 Z-1 R1 P..5\nX3") == Places{"SC1004 3:16"});
  CHECK(told(begin + "R1\nX2") == Places{"SC2005 2:1"});
}

TEST_CASE("a block of a curve that cannot be read lacks nothing", "[ipr][consequences]") {
  const std::string curve = "F100\nG06.2 P2 K0 X0 Y0\nX1 Y1 K0\n";
  CHECK(told(curve + "K1\nK1.2.3\nG01 X1") == Places{"SC1004 5:2"});
  CHECK(told("F100\nG06.2 P2..0 K0 X0\nX1 K0\nK1\nK1") == Places{"SC1004 2:8"});
  CHECK(told("F100\nG06.2 P2 K0 X0 Y2..0\nX1 Y1 K0\nK1\nK1") == Places{"SC1004 2:17"});
}

TEST_CASE("an M code that cannot be read may have been the end", "[ipr][consequences]") {
  const auto without_end = [](const char* text) { return places(interpret(text)); };
  CHECK(without_end("G00 X1\nMO30\n") == Places{"SC1002 2:1"});
  CHECK(without_end("M98 P2\nM30\nO2\nG00 X1\nM99.9.\n") == Places{"SC1004 5:2"});
  CHECK(without_end("G00 X1\n") == Places{"SC2205 1:0"});
}

TEST_CASE("a feed that is missing does not hide behind other words of a curve",
          "[ipr][consequences]") {
  CHECK(told("G05 X1 Y1") == Places{"SC2102 1:1", "SC2005 1:1"});
  CHECK(told("G05.1 X1 Y1") == Places{"SC2102 1:1", "SC2005 1:1"});
}

TEST_CASE("where an arc cannot lead is told beside what has no part in it", "[ipr][consequences]") {
  const std::string f = "F100\n";
  CHECK(told(f + "M03 M04 G02 X1 Y0 I9 J9") == Places{"SC2002 2:5", "SC2103 2:13"});
  CHECK(told(f + "G02 X9 Y9 R1 M..4") == Places{"SC2109 2:11", "SC1004 2:15"});
  CHECK(told(f + "G02 M03 M04 X1") == Places{"SC2002 2:9", "SC2107 2:13"});
  CHECK(told(f + "G02 X1 Y0 I9 Q9") == Places{"SC2004 2:14"});
  CHECK(told(f + "G17 G18 G02 X1 Y0 I9 J9") == Places{"SC2002 2:5"});
  CHECK(told(f + "G02 X1 Y0 I9 Q..9") == Places{"SC1004 2:15"});
}

TEST_CASE("words of a curve are looked at beside one that does not belong there",
          "[ipr][consequences]") {
  const std::string f = "F100\n";
  CHECK(told(f + "G06.1 X1 Y1\nX1 Y1 F5\nX2") == Places{"SC2351 3:1", "SC3110 3:7"});
  const std::string curve = f + "G06.2 P2 X0 Y0 K0\n";
  CHECK(told(curve + "X2..1 K-1\nX2 K1 F5\nK1\nK0.5") ==
        Places{"SC1004 3:2", "SC3004 3:7", "SC3110 4:7", "SC3004 6:1"});
}

TEST_CASE("every knot that falls is told, and no knot for another one", "[ipr][consequences]") {
  const std::string first = "F100\nG06.2 P2 X0 Y0 K0\nX1 K0\n";
  CHECK(told(first + "X2 K5\nX3 K1\nX4 K2\nX5 K1\nX6 K6\nK7\nK7") ==
        Places{"SC3004 5:4", "SC3004 7:4"});
  CHECK(told(first + "X2 K5\nX3\nX4 K2\nK7\nK6") ==
        Places{"SC3102 5:1", "SC3004 6:4", "SC3004 8:1"});
  CHECK(told(first + "X2 K5\nX3 K..9\nX4 K2\nK7\nK7") == Places{"SC1004 5:5", "SC3004 6:4"});
  CHECK(told("F100\nG06.2 P3 X0 K0\nX1 K0\nX2 K2\nX3 K1\nX4 K0.5\nK2\nK2\nK2") ==
        Places{"SC3005 4:4", "SC3004 6:4"});
  CHECK(told("F100\nG06.2 P3 X0 K0\nX1 K0\nX2 K0\nX3 K1\nK2\nK3\nK2") == Places{"SC3005 7:1"});
  CHECK(told("F100\nG06.2 P11 X0 K0\nX1 K2\nX2 K1\nG00 X1") == Places{"SC3001 2:7", "SC3004 4:4"});
  CHECK(told(first + "K1\nX2 K3\nX3 K2\nK4\nG00 X1") == Places{"SC3104 5:1"});
  CHECK(told(first + "M08\nX2 K5\nX3 K4\nK6\nK6") == Places{"SC3105 4:1", "SC3004 6:4"});
}

TEST_CASE("pecks that are too many are told at the line of their words", "[ipr][consequences]") {
  CHECK(told("F100\nG83 X1 Y1 R2 Z-500 Q.001\nX2\nX3") == Places{"SC2007 2:1"});
  CHECK(told("F100\nG83 X1 Y1 R2 Z-500 Q.001\nX2\nX3 Q.002") == Places{"SC2007 2:1", "SC2007 4:1"});
}

TEST_CASE("a keyword that is none may be a call", "[ipr][consequences]") {
  const std::string sub = "o<a> sub\n#100=1\nG18 G01 F100\no<a> endsub\n";
  CHECK(told(sub + "o<a> cal\nX1 Y1\nG00 X[1/#100]\nG03 X5 I2 K0") == Places{"SC1020 5:6"});
  CHECK(told("#100=0\no1 if [1]\no1 els\nG00 X[1/#100]\no1 endif") ==
        Places{"SC1020 3:4", "SC1021 4:9"});
}

TEST_CASE("a jump that leads nowhere does not hide how loops stand to each other",
          "[ipr][consequences]") {
  CHECK(told("GOTO 99\nDO 5\nWHILE [1] DO 1\nWHILE [1] DO 2\nEND 1\nEND 2", Dialect::fanuc) ==
        Places{"SC2308 1:1", "SC2312 2:1"});
  CHECK(told("GOTO 99\nWHILE [1] DO 1\nWHILE [1] DO 2\nEND 1\nEND 2", Dialect::fanuc) ==
        Places{"SC2308 1:1", "SC2312 4:1"});
  CHECK(told("WHILE [1] DO 1\nGOTO 99\nEND 1", Dialect::fanuc) == Places{"SC2308 2:1"});
}

TEST_CASE("a '%' behind a subprogram without its end says nothing of its caller",
          "[ipr][consequences]") {
  CHECK(places(interpret("M98 P2\nM30\nO2\nG00 X1\n%\n")) == Places{"SC2303 5:0"});
}

TEST_CASE("the values behind a G10 L50 that is refused are passed over", "[ipr][consequences]") {
  CHECK(told("G10 L50\nN1020 P1 R2\nN1021 R3\nG11\nG01 X1", Dialect::fanuc) ==
        Places{"SC2007 1:5", "SC2102 5:1"});
  CHECK(told("G10 L52\nN1020 P1 R2\nG00 X1 Q2", Dialect::fanuc) ==
        Places{"SC2007 1:5", "SC2004 3:8"});
  CHECK(told("G11") == Places{"SC2001 1:1"});
}

TEST_CASE("names behind a code that is unknown may be its text", "[ipr][consequences]") {
  CHECK(told("M117 hello world\nG00 X1 foo") == Places{"SC2001 1:1", "SC1020 2:8"});
  CHECK(told("M00 hello") == Places{"SC1020 1:5"});
}

TEST_CASE("a curve that begins where a broken line would have led is not off the position",
          "[ipr][consequences]") {
  const std::string curve = "G6.2 P2 K0 X10 Y0 F100\nK0 X20\nK1\nK1";
  CHECK(told("G0 X10\n" + curve) == Places{});
  CHECK(told("G0 X9\n" + curve) == Places{"SC3109 2:12"});
  CHECK(told("G0 X1..0\n" + curve) == Places{"SC1004 1:5"});
}

TEST_CASE("what a broken code would have set is unknown to what rests on it",
          "[ipr][consequences]") {
  CHECK(told("G18\nG..17 G3 X10 Y0 I5 J0 F100") == Places{"SC1004 2:2"});
  CHECK(told("G93 G1 X60 F5\nG..94 F300\nG1 X70\nX80") == Places{"SC1004 2:2"});
  CHECK(told("G..64 P0.1\nG0 X1") == Places{"SC1004 1:2"});
  CHECK(told("G6..4 D5 J0.5 H10 L2\nG0 X1") == Places{"SC1004 1:2"});
  CHECK(told("G98 G..81 X1 Z-5 R2 F100\nG83 X2 Q2", Dialect::fanuc) == Places{"SC1004 1:6"});
  CHECK(told("G0 X-20 Y-20\nG1 Z-2 F100\nG..42 X0 Y0\nX50\nG3 X60 Y10 I0 J10") ==
        Places{"SC1004 3:2"});
  CHECK(told("F100\nG6..1 X1 Y1\nX2 Y2\nG1 X5") == Places{"SC1004 2:2"});
  CHECK(told("G6.1 X1 Y1 F100\nX..5 Y1\nX1 Y1\nX2 Y2") == Places{"SC1004 2:2"});
}

TEST_CASE("a contour that begins where a broken line would have led has no short first move",
          "[ipr][consequences]") {
  CHECK(told("G10 L1 P1 R3\nT1 M6\nG0 X-1..0\nG41 G1 X1 F100\nY10\nX-20\nG40 X-30") ==
        Places{"SC1004 3:5"});
  CHECK(told("G41.1 D6 G1 X10 Y10 F100\nX30\nG40 X4..0\nG41.1 D6 X31\nY50\nG40 X20") ==
        Places{"SC1004 3:6"});
}

TEST_CASE("a tool whose radius is broken has one that is not known", "[ipr][consequences]") {
  CHECK(told("G10 L1 P1 R2..0\nG41 D1 G1 X20 F100\nX40\nG40 X60") == Places{"SC1004 1:12"});
  CHECK(told("G10 L1 P1 R2\nT1 M..6\nG41 G1 X20 F100\nX40\nG40 X60") == Places{"SC1004 2:5"});
}

TEST_CASE("a spline whose start is not known is not too short", "[ipr][consequences]") {
  CHECK(told("G0 X1\nG6.1 X1 Y0 F100") == Places{"SC2350 2:1"});
  CHECK(told("G0 X1..0\nG6.1 X0 Y0 F100") == Places{"SC1004 1:5"});
}

TEST_CASE("behind an order that cannot be read the next curve is no part of the one before",
          "[ipr][consequences]") {
  const std::string next = "G6.2 P3 K0 X2 Y0 F100\nK0 X3\nK0 X4\nK1\nK1\nK1";
  CHECK(told("G6.2 P..2 K0 X0 Y0 F100\nK0 X2\nK1\nK1\n" + next) == Places{"SC1004 1:7"});
  CHECK(told("G6.2 P2 K0 X0 Y0 F100\nK0 X2\nK1\nK1..\n" + next) == Places{"SC1004 4:2"});
}

TEST_CASE("an error in how loops and branches begin and end hides no other one",
          "[ipr][consequences]") {
  CHECK(told("o1 endif\no2 endwhile\no3 endrepeat\no4 break\no5 else") ==
        Places{"SC2304 1:1", "SC2304 2:1", "SC2304 3:1", "SC2305 4:1", "SC2304 5:1"});
  CHECK(told("o1 if [1]\no2 repeat [2]\no3 while [0]\no3 endwhile\no4 do") ==
        Places{"SC2302 1:1", "SC2302 2:1", "SC2302 5:1"});
  CHECK(told("o1 if [1]\no2 repeat [2]\no3 while [1]\no1 endif\no7 break") ==
        Places{"SC2302 2:1", "SC2302 3:1", "SC2305 5:1"});
  CHECK(told("o9 endif\no1 if [0]\nG0 X1\no1 endif\no2 if [0]\nG0 X1") ==
        Places{"SC2304 1:1"});  // the label of either may be wrong
  CHECK(told("o9 endif\no1 if [0]\nG0 X1\no2 if [0]\nG0 X1") == Places{"SC2304 1:1", "SC2302 4:1"});
  CHECK(told("o1 whle [1]\no1 endwhile\no2 endif") == Places{"SC1020 1:4", "SC2304 3:1"});
}

TEST_CASE("a wrong label or keyword is one error, whatever lacks its other end for it",
          "[ipr][consequences]") {
  CHECK(told("o1 if [1]\no2 endif") == Places{"SC2304 2:1"});
  CHECK(told("o1 while [0]\nG0 X1\no2 endwhile") == Places{"SC2302 1:1"});
  CHECK(told("o1 while [1]\no1 endif") == Places{"SC2304 2:1"});
  CHECK(told("o1 if [0]\nG0 X1\no1 else\nG0 X2\no1 endwhile") == Places{"SC2304 5:1"});
  CHECK(told("o1 if [1]\nG0 X1\no2 else\nG0 X2\no1 endif") == Places{"SC2304 3:1"});
  CHECK(told("o2 if [1]\nG0 X1\no1 else\nG0 X2\no1 endif") == Places{"SC2304 3:1"});
  CHECK(told("o1 do\nG0 X1\no2 while [0]") == Places{"SC2302 3:1"});
  CHECK(told("o2 while [1]\no1 break\no1 endwhile") == Places{"SC2305 2:1"});
  CHECK(told("o1 if [1]\no2 repeat [2]\no3 endrepeat\no1 endif") == Places{"SC2304 3:1"});
}

TEST_CASE("behind a subprogram without its end the program is read on", "[ipr][consequences]") {
  InterpreterOptions options;
  options.unrun_too = true;
  const auto checked = [&](const std::string& text) {
    return places(interpret(text, Machine{}, options));
  };
  CHECK(checked("o1 sub\nG0 X1\no2 sub\nG0 X2\no2 endsub\nG0 X..1\nM2\n") ==
        Places{"SC2303 1:1", "SC1004 6:5"});
  CHECK(checked("o1 sub\nG0 X1..2\nG0 X1\nM2\n") == Places{"SC2303 1:1", "SC1004 2:5"});
  CHECK(checked("o1 sub\nG0 X1\no2 endsub\nG0 X..1\no1 call\nX5\nM2\n") ==
        Places{"SC2303 1:1", "SC1004 4:5"});
}

TEST_CASE("a word that no code takes may have been meant for any that is missing",
          "[ipr][consequences]") {
  const std::string f = "F100\n";
  CHECK(told(f + "G1 X10\nE10\nG2 X20 Y0 I5 J0") == Places{"SC2004 3:1"});
  CHECK(told(f + "G1 X10 E6\nG2 X20 Y6 I5 J0") == Places{"SC2004 2:8"});
  CHECK(told(f + "G1 X10 E6\nG2 X20 Y6 I9 J0") == Places{"SC2004 2:8"});
  CHECK(told(f + "G1 X10 Q6\nX0 Y0\nG2 X20 Y6 I9 J0") == Places{"SC2004 2:8", "SC2103 4:4"});
  CHECK(told("D500 M3\nG95 F.1\nG1 X5") == Places{"SC2004 1:1"});
  CHECK(told("H3 S500\nG95 F.1\nG1 X5\nG84 X1 Z-1 R1") == Places{"SC2004 1:1"});
  CHECK(told("R1 M6\nM6") == Places{"SC2004 1:1"});
  CHECK(told("G1 X1 E100\nX2") == Places{"SC2004 1:7"});
  CHECK(told("G92 E0\nG1 X10 F100\nG53 G0 X0\nG0 X5\nG2 X20 Y6 I9 J0") == Places{"SC2004 1:5"});
  CHECK(told(f + "G81 X1 Z-5 E2\nX2\nX3") == Places{"SC2004 2:12"});
  CHECK(told("G0 E5\nG6.2 P2 K0 X5 Y0 F100\nX2 K0\nK1\nK1") == Places{"SC2004 1:4"});
  CHECK(told(f + "G6.2 P2 K0 X0 Y0\nE1 K0\nX2 K1\nK2\nK2\nG1 X5") == Places{"SC2004 3:1"});
  CHECK(told(f + "G6.2 P2 K0 X0 Y0\nX1 K0\nE1\nK1\nG1 X5") == Places{"SC2004 4:1"});
}

TEST_CASE("an M code that may have been M73 leaves open what its call restores",
          "[ipr][consequences]") {
  const auto program = [](const std::string& saves) {
    return "G21 G94 F100\nM98 P2\nG1 X1\nM30\nO2\n" + saves + "\nG93\nM99";
  };
  CHECK(told(program("M73")) == Places{});
  CHECK(told(program("M70")) == Places{"SC2102 3:1"});
  CHECK(told(program("M..73")) == Places{"SC1004 6:2"});
  CHECK(told(program("M..8")) == Places{"SC1004 6:2", "SC2102 3:1"});
}

TEST_CASE("a label with an unknown character is told where it stands alone",
          "[ipr][consequences]") {
  InterpreterOptions options;
  options.unrun_too = true;
  const auto checked = [&](const std::string& text) {
    return places(interpret(text, Machine{}, options));
  };
  CHECK(checked("o1?00 sub\nG0 X1\no100 endsub\no100 call\nM2\n") == Places{"SC1001 1:3"});
  CHECK(checked("o100 sub\nG0 X1\no1?0 endsub\no100 call\nM2\n") == Places{"SC1001 3:3"});
  CHECK(checked("o100 call\nM2\no1?00 sub\nG0 X1\no100 endsub\n") == Places{"SC1001 3:3"});
  CHECK(checked("o100 call\nM2\n?o100 sub\nG0 X1\no100 endsub\n") == Places{"SC1001 3:1"});
  CHECK(checked("o1 if [0]\nG0 X1\no1$ endif\nM2\n") == Places{"SC1001 3:3"});
  CHECK(checked("o$1 while [0]\nG0 X1\no1 endwhile\nM2\n") == Places{"SC1001 1:2"});
  CHECK(checked("o1?0 sub\nG0 X1\no10 endsub\no2 endif\nM2\n") ==
        Places{"SC1001 1:3", "SC2304 4:1"});
}

TEST_CASE("a misspelt END may be that of a loop that is passed over", "[ipr][consequences]") {
  for (const std::string end : {"EDN1", "EN1", "ENDD 1", "EMD1"})
    CHECK(told("WHILE [1 EQ 2] DO 1\nG0 X1\n" + end + "\nG0 X2", Dialect::fanuc).size() == 1);
  CHECK(told("WHILE [1 EQ 2] DO 1\nG0 X1\nEDN1\nG0 X..2", Dialect::fanuc) ==
        Places{"SC1020 3:1", "SC1004 4:5"});
}

TEST_CASE("behind a broken word in the first line of a curve its blocks are not counted",
          "[ipr][consequences]") {
  CHECK(told("G6.2 P2 K0 X0 Y$0 F100\nX2 K0\nK1\nK1\nG1 X5 F100") == Places{"SC1001 1:16"});
  CHECK(told("G6.2 X0 Y$0 K0 P2 F100\nX2 K0\nK1\nK1\nG1 X5 F100") == Places{"SC1001 1:10"});
  for (const std::string line : {"G6.2 P2 X$2 K", "G..6.2 P2 X2 K", "$G6.2 P2 X2 K", "G6.2 P2 $2 K",
                                 "G6.2 P2 E2 K", "G6.2 $2 X2 K"})
    for (int at = 1; at < 5; ++at) {
      std::string text = "F100\n";
      for (int i = 0; i < 5; ++i)
        text += (i == at ? line : "G6.2 P2 X" + std::to_string(i) + " K") +
                std::to_string(i < 2 ? 0 : i) + "\n";
      CAPTURE(line, at);
      CHECK(told(text + "K5\nK5\nG1 X7").size() == 1);
    }
}

TEST_CASE("one letter or digit out of its place is one error", "[ipr][consequences]") {
  const std::string f = "G1 F100\n";
  CHECK(told(f + "X1 Z-O.03") == Places{"SC1002 2:5"});
  CHECK(told(f + "X1 Z+O.") == Places{"SC1002 2:5"});
  CHECK(told(f + "X-?2 Y..1") == Places{"SC1001 2:3", "SC1004 2:7"});
  CHECK(told(f + "6G.2 P3 K0 X0 Y0") == Places{"SC1007 2:1"});
  CHECK(told(f + "19 X1..2") == Places{"SC1007 2:1", "SC1004 2:5"});
  CHECK(told(f + "19\nG2 Y1 Z1 J1 K0") == Places{"SC1007 2:1"});
  CHECK(told("1#=[#1+0.2]") == Places{"SC1007 1:1"});
  CHECK(told(f + "G I5") == Places{"SC1002 2:1"});
  CHECK(told(f + "F3 X35 Y40 I-5 J0") == Places{"SC2004 2:12"});
  CHECK(told(f + "G1 G28 Z0") == Places{"SC2110 2:1"});
  CHECK(told("G1 G28 Z0") == Places{"SC2110 1:1"});
  CHECK(told("F100\nG5'.2 X0 Y1 P1 L3\nX2 Y8 P2\nX9 Y7 P1\nG5.3") == Places{"SC1001 2:3"});
  CHECK(told("F100\nG5.2 X0 Y1 P1 L3\nX2 Y8 O2\nX9 Y7 P1\nG5.3") == Places{"SC2006 3:7"});
}

TEST_CASE("another letter in the place of G leaves open what it may have set",
          "[ipr][consequences]") {
  CHECK(told("G1 X1 F100\nF3 X4 Y4 R4\nX5 Y5 R4\nX6 Y6 R4\nG2 X9 Y9 I5") == Places{"SC2004 2:10"});
  CHECK(told("G1 X1 F100\nX4 R4\nG1 X5 R4") == Places{"SC2004 2:4", "SC2004 3:7"});
  CHECK(told("H18\nG2 X1 Z1 I1 K0 F100") == Places{"SC2004 1:1"});
  CHECK(told("N5 H21\nG2 X1 Z1 I1 K0 F100") == Places{"SC2004 1:4", "SC2105 2:13"});
  CHECK(told("G06.2 P2 J0 X0 Y0 F100\nX2 K0\nK1\nK1") == Places{"SC3102 1:1"});
}

TEST_CASE("another letter in the place of a knot is one error", "[ipr][consequences]") {
  const std::string curve = "G6.2 P2 K0 X0 Y0 F100\nX2 K0\n";
  CHECK(told(curve + "L1\nK1\nG1 X5") == Places{"SC3110 3:1"});
  CHECK(told(curve + "X3 L1\nK1\nK1\nG1 X5") == Places{"SC3110 3:4"});
  CHECK(told(curve + "X3 L1 K1\nK2\nG1 X5") == Places{"SC3110 3:4", "SC3104 5:1"});
  CHECK(told(curve + "X3\nK2\nK2\nG1 X5") == Places{"SC3102 3:1"});
}

TEST_CASE("a subprogram whose first line is wrong is told once", "[ipr][consequences]") {
  InterpreterOptions options;
  options.unrun_too = true;
  const auto checked = [&](const std::string& text) {
    return places(interpret(text, Machine{}, options));
  };
  const std::string call = "o<a> call\n", body = "G0 X1\no<a> endsub\n", end = "M2\n";
  CHECK(checked("o<b> sub\n" + body + call + end) == Places{"SC2303 1:1"});
  CHECK(checked(call + end + "o<b> sub\n" + body) == Places{"SC2301 1:1"});
  CHECK(checked(body + call + end) == Places{"SC2304 2:1"});
  CHECK(checked(call + body + end) == Places{"SC2301 1:1"});
  CHECK(checked("o<b> sub\n" + body + "o<c> call\n" + end) == Places{"SC2303 1:1", "SC2301 4:1"});
}

TEST_CASE("an end that cannot be read is looked for before its beginning is told",
          "[ipr][consequences]") {
  for (const std::string end :
       {"o endif", "p1 endif", "1 endif", "1o endif", "o1 e$ndif", "o1 endi"})
    CHECK(told("o1 if [0]\nG0 X1\n" + end + "\nG0 X2").size() == 1);
  CHECK(told("o1 do\nG0 X1\np1 while [0]") == Places{"SC1020 3:4"});
  CHECK(told("p1 while [1]\nG0 X1\no1 endwhile") == Places{"SC1020 1:4"});
  CHECK(told("DO 1\nG0 X1\nEND", Dialect::fanuc) == Places{"SC1029 3:1"});
  CHECK(told("o<a> sub\nG0 X1\np<a> endsub\no<a> call") == Places{"SC1001 3:2"});
  CHECK(told("p1 if [0]\n(ABORT,never)\no1 endif") == Places{"SC1020 1:4"});
}

TEST_CASE("a keyword that is none is no end where there is one", "[ipr][consequences]") {
  CHECK(told("o<a> sub\no1 if [#1 GT 0]\no<a> cqll [#1-1]\no1 endif\no<a> endsub\no<a> call [2]") ==
        Places{"SC1020 3:6"});
  CHECK(told("o1 while [0]\no3 if [1]\no1 brek\no3 endif\no1 endwhile\nG0 X..1") ==
        Places{"SC1004 6:5"});
}

TEST_CASE("the label of a beginning that is wrong is one error", "[ipr][consequences]") {
  CHECK(told("o2 if [0]\nG0 X1\no1 elseif [0]\nG0 X2\no1 endif") == Places{"SC2302 1:1"});
  CHECK(told("o2 repeat [2]\nG0 X1\no1 endrepeat\no2 do\no2 while [0]") == Places{"SC2304 3:1"});
}

TEST_CASE("words that one missing code leaves without a use are told as one",
          "[ipr][consequences]") {
  CHECK(told("N98 P2000 L3") == Places{"SC2004 1:5"});
  const auto told_of = interpret("G0 X1 Q1 P2 L3\nM30\n").diagnostics;
  REQUIRE(told_of.size() == 1);
  CHECK(told_of[0].message == "L, P and Q are used by no code of this line");
  CHECK(told("1#0=0") == Places{"SC1007 1:1"});
  CHECK(told("G0 X3#0 Y20") == Places{"SC1028 1:9"});
  CHECK(told("2\n(ABORT,not behind the end)") == Places{"SC1007 1:1"});
}

TEST_CASE("a letter in the place of a digit of a label is told there, and at no other end",
          "[ipr][consequences]") {
  InterpreterOptions options;
  options.unrun_too = true;
  const auto checked = [&](const std::string& text) {
    return interpret(text, Machine{}, options).diagnostics;
  };
  const auto only = [&](const std::string& text, int line, int column, const std::string& meant) {
    const auto all = checked(text);
    REQUIRE(all.size() == 1);
    CHECK(all[0].code == Code::SC1029);
    CHECK((all[0].pos.line == line && all[0].pos.column == column));
    CHECK(all[0].message == "a letter in the label; is " + meant + " meant?");
  };
  const std::string call = "o100 call\n", end = "M2\n";
  only(call + end + "o1OO sub\nG0 X0\no100 endsub\n", 3, 3, "o100");
  only(call + end + "ol00 sub\nG0 X0\no100 endsub\n", 3, 2, "o100");
  only("o1O0 sub\nG0 X1\no100 endsub\n" + call + end, 1, 3, "o100");
  only("o100 sub\nG0 X1\no1O0 endsub\n" + call + end, 3, 3, "o100");
  only("o<a> sub\nG0 X1\no<a> endsub\noo<a> call\n" + end, 4, 2, "o<a>");
  for (const std::string holds : {"0", "1"}) {
    only("o10 if [" + holds + "]\nG0 X1\no1O endif\n" + end, 3, 3, "o10");
    only("o1O if [" + holds + "]\nG0 X1\no10 endif\n" + end, 1, 3, "o10");
  }
  only("ol while [0]\nG0 X1\no1 endwhile\n" + end, 1, 2, "o1");
  const auto both = checked("ol while [0]\nG0 X1\no1 endwhile\no2 endif\n" + end);
  REQUIRE(both.size() == 2);
  CHECK(both[1].message == "'o2 endif' without 'o2 if'");
}

TEST_CASE("of two beginnings of one label one has a wrong label: what it was meant for follows",
          "[ipr][consequences]") {
  const std::string begin = "#1=1\no1 while [#1 LT 3]\n", end = "#1=[#1+1]\no1 endwhile\n";
  const std::string broken = begin + "o1 repeat [3]\nG0 X1\no2 break\no2 endrepeat\n" + end;
  CHECK(told(broken) == Places{"SC2313 3:1"});
  CHECK(told(broken + "o3 break") == Places{"SC2313 3:1", "SC2305 9:1"});
  CHECK(told(broken + "o3 endif") == Places{"SC2313 3:1", "SC2304 9:1"});
  CHECK(told(begin + "o1 if [1]\nG0 X1\no2 endif\n" + end) == Places{"SC2313 3:1"});
  CHECK(told(begin + "o1 if [1]\nG0 X1\no2 endrepeat\n" + end) ==
        Places{"SC2313 3:1", "SC2304 5:1"});
  CHECK(told("o2 while [1]\no2 if [1]\nG0 X1\no1 continue\no2 endif\no1 endwhile") ==
        Places{"SC2313 2:1"});
  CHECK(told("WHILE [1] DO 1\nWHILE [1] DO 1\nG0 X1\nEND 2\nEND 1", Dialect::fanuc) ==
        Places{"SC2312 2:1"});
}

TEST_CASE("a letter in the place of a digit belongs to the number", "[ipr][consequences]") {
  const std::string f = "G1 F100\n";
  for (const std::string line : {"G1 X1 Yp", "G1 X1 Ye0", "Nw0 G1 X1", "G1 Xq0", "Gq X1", "G6q",
                                 "X1 Sq0", "G1i G2 X1 I0.5", "Xy0 Y1", "G1 X1 Yt.5", "Zq."}) {
    CAPTURE(line);
    CHECK(told(f + line).size() == 1);
  }
  CHECK(told(f + "Gq8\nG2 X10 I5 K0") == Places{"SC1002 2:1"});
  CHECK(told(f + "G1i G2 X10 I5 K0") == Places{"SC1002 2:3"});
  CHECK(told(f + "Gq X1\nX2 Y3") == Places{"SC1002 2:1"});
  CHECK(told(f + "X1 Yp Q..5") == Places{"SC1002 2:4", "SC1004 2:8"});
  CHECK(told("#1=5\n" + f + "XX-#1") == Places{"SC1002 3:1"});
  CHECK(told(f + "XY1.2.3") == Places{"SC1002 2:1", "SC1004 2:3"});
  CHECK(told(f + "Yp X1\nX1 Q5") == Places{"SC1002 2:1", "SC2004 3:4"});
  CHECK(told(f + "Y X1 Zq\nX..5") == Places{"SC1002 2:1", "SC1002 2:6", "SC1004 3:2"});
}

TEST_CASE("a comment that has lost its beginning is one error", "[ipr][consequences]") {
  CHECK(told("G0 X1\nin force until another code, say G1)") == Places{"SC1002 2:1"});
  CHECK(told("9G01: straight to the point)\nG0 X..1") == Places{"SC1007 1:1", "SC1004 2:5"});
  CHECK(told("Lines in Y and Z.)") == Places{"SC1020 1:1"});
  CHECK(told(")G01: straight, at the feed)") == Places{"SC1001 1:1"});
  CHECK(told("G0 X..1 to the left, then up)") == Places{"SC1004 1:5", "SC1002 1:9"});
  CHECK(told("G0 X? Y..1 (left)") == Places{"SC1001 1:5", "SC1004 1:8"});
}

TEST_CASE("an arc that cannot be may end elsewhere, where the next one begins",
          "[ipr][consequences]") {
  const std::string f = "F100\n", far = "G2 X9 Y0 I1 J0\n";
  CHECK(told(f + far + "G2 X4 Y0 I1 J0") == Places{"SC2103 2:4"});
  CHECK(told(f + far + "G2 X20 Y0 I1 J0\nG2 X30 Y0 I1 J0") == Places{"SC2103 2:4", "SC2103 4:4"});
  CHECK(told(f + far + "G1 X2 Y0\nG2 X20 Y0 I1 J0") == Places{"SC2103 2:4", "SC2103 4:4"});
  CHECK(told(f + far + "G2 X4 Y0") == Places{"SC2103 2:4", "SC2107 3:4"});
  CHECK(told(f + far + "G2 X4 K1 Q..4") == Places{"SC2103 2:4", "SC2105 3:7", "SC1004 3:11"});
  CHECK(told("X40 Y40\nG2 X41 Y41 I1 J0 F100") == Places{"SC2101 1:1"});
  CHECK(told("X40 Y40\nG1 X2 Y0 F100\nG2 X20 Y0 I1 J0") == Places{"SC2101 1:1", "SC2103 3:4"});
}

TEST_CASE("lines behind an arc without a centre, which its code makes arcs, are not told",
          "[ipr][consequences]") {
  const std::string f = "F100\n";
  CHECK(told(f + "G2 X1\nX2\nY3") == Places{"SC2107 2:4"});
  CHECK(told(f + "G2 X1\nX2\nG3 Y3") == Places{"SC2107 2:4", "SC2107 4:4"});
  CHECK(told(f + "G2 X1\nX2 Q..3") == Places{"SC2107 2:4", "SC1004 3:5"});
  CHECK(told(f + "G2 X2 Y0 I1\nX4\nG1 X9") == Places{"SC2107 3:1"});
}

TEST_CASE("a name that nothing has set is told once", "[ipr][consequences]") {
  CHECK(told("#<widht>=4\nG0 X#<width>\nG0 Y[2*#<width>]") == Places{"SC1024 2:5"});
  CHECK(told("G0 X#<width>\nG0 Y#<depth>") == Places{"SC1024 1:5", "SC1024 2:5"});
  CHECK(told("G0 X#<width>\n#<width>=0\nG0 X[1/#<width>]") == Places{"SC1024 1:5", "SC1021 3:8"});
}

TEST_CASE("behind an M30 with a letter for its zero there is no program", "[ipr][consequences]") {
  const auto checked = [](const std::string& text) {
    InterpreterOptions options;
    options.unrun_too = true;
    return places(interpret(text, Machine{}, options));
  };
  CHECK(checked("G0 X1\nM3O\nthis is prose\nand more of it\n") == Places{"SC1002 2:3"});
  CHECK(checked("G0 X1\nMO2\nthis is prose\n") == Places{"SC1002 2:1"});
  CHECK(checked("G0 X1\nMO8\nG0 X..1\nM2\n") == Places{"SC1002 2:1", "SC1004 3:5"});
  CHECK(checked("o1 call\nM3O\no1 sub\nG0 X..1\no1 endsub\n") ==
        Places{"SC1004 4:5", "SC1002 2:3"});
}

TEST_CASE("a line number that is doubled is the one a jump looks for", "[ipr][consequences]") {
  CHECK(told("GOTO 99\nG0 X1\nNN99 G0 X1", Dialect::fanuc) == Places{"SC1002 3:1"});
  CHECK(told("GOTO 98\nG0 X1\nNN99 G0 X1", Dialect::fanuc) == Places{"SC2308 1:1", "SC1002 3:1"});
}

TEST_CASE("a jump back that a broken one would have left does not run on", "[ipr][consequences]") {
  const std::string begin = "N10 #1=#1+1\n", end = "GOTO 10\nN20 G0 X1\n";
  CHECK(told(begin + "IF [#1 GT 5] GTO 20\n" + end, Dialect::fanuc) == Places{"SC1029 2:14"});
  CHECK(told(begin + "IF [#1 GT 5] GOTO 30\n" + end, Dialect::fanuc) == Places{"SC2308 2:1"});
  CHECK(told(begin + "IF [#1 GT 5] GTO 20\n" + end + "G0 X..1", Dialect::fanuc) ==
        Places{"SC1029 2:14", "SC1004 5:5"});
  CHECK(told(begin + end, Dialect::fanuc) == Places{"SC2310 2:1"});
}

TEST_CASE("a THEN of which nobody knows whether it counts hides no structure",
          "[ipr][consequences]") {
  const std::string then = "IF [#1 EQ 1..2] THEN #2=1\n";
  CHECK(told(then + "o1 endif", Dialect::linuxcnc) == Places{"SC1004 1:11", "SC2304 2:1"});
  CHECK(told(then + "WHILE [1 EQ 2] DO 1\nG0 X1", Dialect::fanuc) ==
        Places{"SC1004 1:11", "SC2302 2:1"});
  CHECK(told(then + "G0 X[1/#2]", Dialect::fanuc) == Places{"SC1004 1:11"});
  const std::string unknown = "#1=1..2\nIF [#1 EQ 1] THEN #2=1\n";
  CHECK(told(unknown + "o1 endif") == Places{"SC1004 1:4", "SC2304 3:1"});
  CHECK(told(" if [1 EQ 1]\nG0 X1\no1 endif") == Places{"SC1029 1:12"});
  CHECK(told("91 if [1]\nG0 X1\no1 endif") == Places{"SC1007 1:1"});
  CHECK(told("IF [#1 EQ 1] GTO 20\no1 endif\nN20 G0 X1") == Places{"SC1029 1:14", "SC2304 2:1"});
}

TEST_CASE("a letter behind a sign belongs to the number", "[ipr][consequences]") {
  const std::string f = "G1 F100\n";
  CHECK(told(f + "Y-q0 X1") == Places{"SC1002 2:2"});
  CHECK(told(f + "Y-w") == Places{"SC1002 2:2"});
  CHECK(told(f + "Y-q1.2.3 X..1") == Places{"SC1002 2:2", "SC1004 2:4", "SC1004 2:11"});
}

TEST_CASE("a code so large that there is none may be a word with another letter",
          "[ipr][consequences]") {
  CHECK(told("G400\nG1 X1") == Places{"SC2001 1:1"});
  CHECK(told("G400 F0\nG1 X1") == Places{"SC2001 1:1", "SC2102 2:1"});
  CHECK(told("G68\nG1 X1") == Places{"SC2001 1:1", "SC2102 2:1"});
  CHECK(told("G1 F100\nB02 X1 I5") == Places{"SC2008 2:1"});
  CHECK(told("F100\nG1 B02 X1 Q5") == Places{"SC2008 2:4", "SC2004 2:11"});
}

TEST_CASE("a loop that an unread name or number would have left does not run on",
          "[ipr][consequences]") {
  CHECK(told("#1=1\no1 while [#1 LT 5]\n31=[#1+1]\no1 endwhile") == Places{"SC1007 3:1"});
  CHECK(told("#1=1\nWHILE [#1 EQ 1] DO 2\nGOT 15\nEND 2\nN15 G0 X..1", Dialect::fanuc) ==
        Places{"SC1020 3:1", "SC1004 5:9"});
}

TEST_CASE("that no tool is in the spindle is told once of the words it would give",
          "[ipr][consequences]") {
  CHECK(told("N06 T7\nG06.4 J.5 H10\nG06.4 J.5 H20") == Places{"SC3125 2:1"});
  CHECK(told("G06.4 J.5 H10\nG06.4 D5 H10 L2") == Places{"SC3125 1:1", "SC3125 2:1"});
}

TEST_CASE("an M99 that cannot be read may have been the end before the next program",
          "[ipr][consequences]") {
  const std::string call = "M98 P2\nM30\nO2\nG0 X1\n", next = "O3\nG0 X2\nM99";
  CHECK(told(call + "MM99\n" + next) == Places{"SC1002 5:1"});
  CHECK(told(call + next) == Places{"SC2303 5:1"});
}

TEST_CASE("a word that no code in force takes is told, whatever motion that is",
          "[ipr][consequences]") {
  const Places words{"SC2008 3:4", "SC2008 4:5", "SC2008 5:7", "SC2008 6:4"};
  for (const std::string line : {"5", "?", "G", "-30"}) {
    CAPTURE(line);
    Places all = told("G0 X1 F100\n" + line + "\nX2 B5\nG54 B5\nG61.1 B5\nM5 B5");
    REQUIRE(all.size() == words.size() + 1);
    all.erase(all.begin());
    CHECK(all == words);
  }
  CHECK(told("5\nG54 E5\nT1 B5\nX2 P5") == Places{"SC1007 1:1", "SC2004 2:5", "SC2008 3:4"});
  CHECK(told("5\nX2 B5", Dialect::fanuc) == Places{"SC1007 1:1"});
  const auto all = interpret("5\nX2 B5 E1\nM2\n").diagnostics;
  REQUIRE(all.size() == 3);
  CHECK(all[1].message == "the machine has no axis B");
  CHECK(all[2].message == "E is used by no code of this line");
}

TEST_CASE("an end that may be another word of its line does not end the program",
          "[ipr][consequences]") {
  const std::string f = "G1 X1 F100\n";
  CHECK(told(f + "G10 M2 P1 X0\nG123\nG1 X1 Q1") ==
        Places{"SC2005 2:1", "SC2001 3:1", "SC2004 4:7"});
  CHECK(told(f + "G10 L2 P1 X0 M2\nG123") == Places{});
  CHECK(told(f + "G0 X..1 M2\nG123") == Places{"SC1004 2:5"});
}

TEST_CASE("what stands behind an end is no program, though one before it cannot be read",
          "[ipr][consequences]") {
  const auto checked = [](const std::string& text) {
    InterpreterOptions options;
    options.unrun_too = true;
    return places(interpret(text, Machine{}, options));
  };
  CHECK(checked("G0 X1\n5\nM2\ntext is here\n") == Places{"SC1007 2:1"});
  CHECK(checked("2G1 G90 G0 X1\nG0 X2\nM2\nG0 X99\nthis is no program\n") == Places{"SC1007 1:1"});
  CHECK(checked("o1 call\n5\nM2\no1 sub\nG0 X..1\no1 endsub\n") ==
        Places{"SC1004 5:5", "SC1007 2:1"});
  CHECK(checked("o1 if [1\nM2\no1 endif\nG0 X..1\n") == Places{"SC1017 1:7", "SC1004 4:5"});
}

TEST_CASE("an end with a wrong digit is told, and not the prose behind it", "[ipr][consequences]") {
  for (const std::string end : {"M32", "M530", "M22", "M39", "M320"}) {
    CAPTURE(end);
    CHECK(places(interpret("G0 X1\n" + end + "\nthis is prose\nand more of it\n")) ==
          Places{"SC2001 2:1"});
    CHECK(told("G0 X1\n" + end + "\nX..1\nGTO 5") ==
          Places{"SC2001 2:1", "SC1004 3:2", "SC1020 4:1"});
  }
  CHECK(told("G0 X1\nM117\nthis is prose") == Places{"SC2001 2:1", "SC1020 3:1"});
  CHECK(told("G0 X1\nM530\n(a comment) abc def") == Places{"SC2001 2:1", "SC1020 3:13"});
}

TEST_CASE("a code that may be no arc is told once, and so are its lines", "[ipr][consequences]") {
  const std::string f = "F100\n", knots = "K0 X1 Y1\nK0 X2 Y0\nK1\nK1\n";
  CHECK(told(f + "G2 X5 I2.5\n" + knots) == Places{"SC2105 3:1"});
  CHECK(told(f + "G2 X5 I2.5\n" + knots + "G3 X1 K1") == Places{"SC2105 3:1", "SC2105 7:7"});
  CHECK(told(f + "G6.G2 P3 K0 X0 Y0\n" + knots + "G1 X5") == Places{"SC2001 2:1"});
  CHECK(told(f + "G6.G2 P3 K0 X0 Y0\n" + knots + "G2 X5") == Places{"SC2001 2:1", "SC2107 7:4"});
  CHECK(told(f + "G0 X0\nX5 Y3 P1\nX6 Y2 P2\nX7 Y3 P1\nG5.3") == Places{"SC2004 3:7"});
  CHECK(told(f + "G0 X5 P1\nG1 X7 P1") == Places{"SC2004 2:7", "SC2004 3:7"});
}

TEST_CASE("the first or the last block of a curve with a wrong letter is one error",
          "[ipr][consequences]") {
  const std::string rest = "K0 X1 Y1\nK0 X2 Y0\nK1\nK1\n", f = "F100\n";
  CHECK(told(f + "G6.2 P3 K0 P0 Y0\n" + rest + "K1") == Places{"SC2003 2:12"});
  CHECK(told(f + "G6.2 P3 K0 X0 Y0\n" + rest + "Z1") == Places{"SC3102 7:1"});
  CHECK(told(f + "G6.2 P3 K0 X0 Y0\n" + rest + "Y1\nG1 X5 Q1") ==
        Places{"SC3102 7:1", "SC2004 8:7"});
  const auto all = interpret(f + "G6.2 L3 K0 X0 Y0\n" + rest + "K1\nM2\n").diagnostics;
  REQUIRE(all.size() == 1);
  CHECK(all[0].code == Code::SC3125);
  CHECK(all[0].pos.column == 6);
  CHECK(all[0].message == "L alone asks for no surface: it takes D, J and H");
  const std::string points = f + "G5.2 X0 Y1 P1 L3\nX2 Y8 P2\nX9 Y7 P1\n";
  CHECK(told(points + "M5.3") == Places{"SC2001 5:1"});
  CHECK(told(points + "F5.3") == Places{"SC3110 5:1"});
  CHECK(told(points + "F5.3\nG1 X5 Q1") == Places{"SC3110 5:1", "SC2004 6:7"});
}

TEST_CASE("what a mistyped code would have set is not known", "[ipr][consequences]") {
  const std::string arc = "G1 X10 Y5\nG3 X-20 Y0 I-10 J0", across = "G3 X20 Z10 I0 K10";
  CHECK(told("G.91 F600\n" + arc) == Places{"SC2001 1:1"});
  CHECK(told("G09 F600\n" + arc) == Places{"SC2001 1:1"});
  CHECK(told("G61 F600\n" + arc) == Places{"SC2103 3:4"});
  for (const std::string line : {"G718", "G(8", "*18", "G$8"}) {
    CAPTURE(line);
    CHECK(told("F600\n" + line + "\nG0 X10 Z0\n" + across).size() == 1);
    CHECK(told("F600\n" + line + "\nG0 X10 Z0\n" + across + "\nG17 G3 X1 K1").size() == 2);
  }
  CHECK(told("G10 X2\nX2\nX3") == Places{"SC2005 1:1"});
  CHECK(told("G91 X600\nG1 X1\nX2") == Places{"SC2101 1:5"});
  CHECK(told("X6 Y5\nG1 X1") == Places{"SC2101 1:1", "SC2102 2:1"});
  CHECK(told("x0 X1") == Places{"SC2003 1:4"});
  CHECK(told("G98 G81 X1 Y1 -5 R2 F100\nX2\nG80") == Places{"SC1003 1:13"});
}

TEST_CASE("one typed character is one error of its line", "[ipr][consequences]") {
  CHECK(told("G0 X/1") == Places{"SC1011 1:5"});
  CHECK(told("G0 X-]10") == Places{"SC1017 1:6"});
  CHECK(told("G0 Z-=1.") == Places{"SC1001 1:6"});
  CHECK(told("G0 X-]10\nY..1") == Places{"SC1017 1:6", "SC1004 2:2"});
  const auto all = interpret("G00 X10 up again, as fast)\nM2\n").diagnostics;
  REQUIRE(all.size() == 1);
  CHECK(all[0].message == "no number after U; the ')' behind it has no '('");
}

TEST_CASE("an end of a subprogram that has lost its keyword is told there", "[ipr][consequences]") {
  const auto all = interpret("o1 sub\nG0 X1\no1\no1 call\nX..5\nM2\n").diagnostics;
  REQUIRE(all.size() == 2);
  CHECK(all[0].code == Code::SC2303);
  CHECK((all[0].pos.line == 3 && all[0].pos.column == 1));
  CHECK(all[0].message == "'o1' within its 'sub' lacks a keyword; is 'o1 endsub' meant?");
  CHECK((all[1].code == Code::SC1004 && all[1].pos.line == 5));
}

TEST_CASE("a label or keyword of which one character is lost is one error", "[ipr][consequences]") {
  InterpreterOptions options;
  options.unrun_too = true;
  const auto checked = [&](const std::string& text) {
    return places(interpret(text, Machine{}, options));
  };
  const std::string body = "G0 X1\no200 endsub\n", call = "o200 call\n", end = "M2\n";
  CHECK(checked(call + end + " sub\n" + body) == Places{"SC1020 3:2"});
  CHECK(checked(call + end + "R200 sub\n" + body) == Places{"SC1020 3:6"});
  CHECK(checked(call + "o3 call\n" + end + " sub\n" + body) == Places{"SC2301 2:1", "SC1020 4:2"});
  CHECK(told("o1 0epeat [6]\nG0 X1\no1 endrepeat") == Places{"SC1020 1:5"});
  CHECK(told("o1 0epeat [6]\nG0 X1\no1 endrepeat\no2 endif") == Places{"SC1020 1:5", "SC2304 4:1"});
  const std::string ramp = "o<ramp> sub\nG0 X1\no3ramp> endsub\no<ramp> call";
  CHECK(told(ramp) == Places{"SC1020 3:3"});
  CHECK(told(ramp + "\nG0 X..1") == Places{"SC1020 3:3", "SC1004 5:5"});
}

TEST_CASE("behind a number alone that may be an end prose is not told", "[ipr][consequences]") {
  for (const std::string line : {"-30", "22", "M530"}) {
    CAPTURE(line);
    const std::string begin = "G0 X1\n" + line + "\n";
    CHECK(places(interpret(begin + "this is never read (nor this\n#1=2\n")).size() == 1);
    CHECK(told(begin + "G0 X..1\nGTO 5").size() == 3);
  }
  CHECK(told("G0 X1\n7\nthis is prose") == Places{"SC1007 2:1", "SC1020 3:1"});
}

TEST_CASE("a bracket or a slash too many in a value is one error", "[ipr][consequences]") {
  const std::string f = "G1 F100\n";
  CHECK(told(f + "X[]1+2*3] Y1") == Places{"SC1016 2:3"});
  CHECK(told(f + "X[]1+2*3] Y..1") == Places{"SC1016 2:3", "SC1004 2:12"});
  CHECK(told(f + "X[] 5") == Places{"SC1016 2:3", "SC1007 2:5"});
  CHECK(told(f + "G[]0 X1") == Places{"SC1016 2:3"});
  CHECK(told(f + "M/05") == Places{"SC1002 2:1"});
  CHECK(told(f + "G10+11] G90 Y..1") == Places{"SC1003 2:2", "SC1004 2:14"});
}

TEST_CASE("a digit too many before a code with a point leaves its motion open",
          "[ipr][consequences]") {
  const std::string points = "F100\nG95.2 X0 Y1 P1 L3\nX2 Y8 P2\nX9 Y7 P1\nG5.3\n";
  CHECK(told(points) == Places{"SC2001 2:1"});
  CHECK(told(points + "G1 X1 Q1") == Places{"SC2001 2:1", "SC2004 6:7"});
}

TEST_CASE("a name that looks like a code loses none", "[ipr][consequences]") {
  for (const std::string name : {"#<m2>", "#<g_z>", "#<g91>"}) {
    CAPTURE(name);
    CHECK(told("#<a> = #<no>\n" + name + " = #<a>\no1 endif\nG0 X1..2") ==
          Places{"SC1024 1:8", "SC2304 3:1", "SC1004 4:5"});
  }
}

TEST_CASE("a word that no code takes leaves open what its line could need", "[ipr][consequences]") {
  CHECK(told("G0 X1 X2\nG1 Y1") == Places{"SC2003 1:7", "SC2102 2:1"});
  CHECK(told("G1 X1 X2\nG1 Y1") == Places{"SC2003 1:7"});
  CHECK(told("G54 P1\nG1 Y1") == Places{"SC2004 1:5", "SC2102 2:1"});
  CHECK(told("G17 R600\nG1 Y1") == Places{"SC2004 1:5"});
  CHECK(told("D100\nG1 Y1") == Places{"SC2004 1:1"});
  CHECK(told("N5 D100\nG1 Y1") == Places{"SC2004 1:4"});
  CHECK(told("G0 Z5 H1\nM6") == Places{"SC2004 1:7", "SC2204 2:1"});
  CHECK(told("M6 H1\nM6") == Places{"SC2004 1:4"});
}

TEST_CASE("an arc without a centre leads where both its letters say", "[ipr][consequences]") {
  const std::string behind = "\nG1 X80\nG2 X90 Y50 I0 J10";
  CHECK(told("F9\nG2 X10 Y60" + behind) == Places{"SC2107 2:4", "SC2103 4:4"});
  CHECK(told("F9\nG2 Y60" + behind) == Places{"SC2107 2:4"});
}

TEST_CASE("a variable of the system that cannot be assigned is not known any more",
          "[ipr][consequences]") {
  CHECK(told("o1 while [#<_z> GT -2]\n#<_z> = [#<_z> - 1]\no1 endwhile\nG0 X1..2") ==
        Places{"SC1026 2:1", "SC1004 4:5"});
  CHECK(told("o1 while [#5420 GT -2]\n#5420 = [#5420 - 1]\no1 endwhile\nG0 X1..2") ==
        Places{"SC1026 2:1", "SC1004 4:5"});
}

TEST_CASE("an O for the digit 0 loses the digits before it", "[ipr][consequences]") {
  CHECK(told("F9\nG1 Y5O.\nG2 X10. Y60. R10.") == Places{"SC1002 2:7"});
}

TEST_CASE("a decimal comma is told of its number, and the line is read on", "[ipr][consequences]") {
  CHECK(told("F9\nG1 X1\nX7 Z-0,6\nX5 Q5\nX6 R2") ==
        Places{"SC1001 3:7", "SC2004 4:4", "SC2004 5:4"});
  CHECK(told("F9\nG6.2 P2 K0 X0 Y0\nK0 X5 Y2,5\nK1 X9 R-1\nK0.5 X10\nK2\nK2") ==
        Places{"SC1001 3:9", "SC3007 4:7", "SC3004 5:1"});
  CHECK(told("G0 X1 Y2,C3") == Places{"SC1001 1:9"});
}

TEST_CASE("behind an M that may be the end M99 begins nothing anew", "[ipr][consequences]") {
  const std::string sub = "\nO2000\nG0 X1\nM99";
  CHECK(told("G0 X1 Y\nM98 P2000\nM" + sub) == Places{"SC1002 1:7", "SC1002 3:1"});
  CHECK(told("G0 X1 Y\nM98 P2000\nM031" + sub) == Places{"SC1002 1:7", "SC2001 3:1"});
}

TEST_CASE("one letter of an IF before its condition is a keyword that is none",
          "[ipr][consequences]") {
  CHECK(told("o1 f [0]\nG0 X1\no1 endif") == Places{"SC1020 1:4"});
  CHECK(told("o1 i [0]\n(ABORT,never)\no1 endif\nG0 X1..2") == Places{"SC1020 1:4", "SC1004 4:5"});
}
