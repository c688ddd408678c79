// SPDX-License-Identifier: MIT
// The one rule of errors: what a wrong line would have set is unknown; an operation with an unknown
// operand makes its result unknown and reports nothing; a code that sets a part anew makes it
// known.
#include <catch2/catch.hpp>

#include "ipr/handlers/handlers.hpp"
#include "ipr/lines/operands.hpp"
#include "ipr/reported.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

namespace {

const std::string kFeed = "F100\n";

/// A program after whose first line every part is unknown.
Places after_a_missing_call(const std::string& lines, Dialect dialect = Dialect::linuxcnc) {
  Places places = reported("M98 P999\n" + lines, dialect);
  REQUIRE(places.front() == "SC2301 1:1");
  places.erase(places.begin());
  return places;
}

/// A line with this code and all words that it takes, each 1.
std::string line_of(const GCode& code) {
  std::string line =
      code.number == kAnyNumber ? std::string(1, code.letter) + "1" : code_name(code);
  for (const char letter : code.words)
    if (letter != code.letter) line += std::string(" ") + letter + "1";
  return line;
}

/// What is reported where lines that are never run are read as well.
Places reported_of_all(const std::string& text, Dialect dialect = Dialect::linuxcnc) {
  InterpreterOptions options;
  options.dialect = dialect;
  options.unreachable_too = true;
  return places(interpret(text + "\nM30\n", Machine{}, options));
}

}  // namespace

TEST_CASE("a line reports its first error by column", "[ipr][unknown]") {
  CHECK(reported("G00 X1..2 Y3..4") == Places{"SC1004 1:6"});
  CHECK(reported("G00 X1 X2 Q5") == Places{"SC2003 1:8"});
  CHECK(reported("G02 X1 I1 R1 Q3 F5") == Places{"SC2106 1:8"});
  CHECK(reported("G01 X1 S-1") == Places{"SC2102 1:1"});
}

TEST_CASE("lines whose operands are known report errors after another error", "[ipr][unknown]") {
  CHECK(reported("G00 X1..2\nG00 X1 Q5") == Places{"SC1004 1:6", "SC2004 2:8"});
  CHECK(reported(kFeed + "G02 X1 Y1\nG00 X0 Y0\nG02 X1 Y1") == Places{"SC2107 2:5", "SC2107 4:5"});
}

TEST_CASE("a coordinate that cannot be read leaves its axis unknown until it is given again",
          "[ipr][unknown]") {
  CHECK(reported(kFeed + "G01 X1,0\nG02 X9 Y9 R1") == Places{"SC1001 2:7"});
  CHECK(reported(kFeed + "G01 X1..0\nG00 X0\nG02 X9 Y9 R1") == Places{"SC1004 2:6", "SC2109 4:11"});
  CHECK(reported(kFeed + "G01 X1..0\nG91 G00 X1\nG02 X9 Y9 R1") == Places{"SC1004 2:6"});
}

TEST_CASE("a G code that cannot be read leaves plane and distance mode unknown", "[ipr][unknown]") {
  CHECK(reported(kFeed + "G..18\nG02 X10 I5 K5") == Places{"SC1004 2:2"});
  CHECK(reported(kFeed + "G..18\nG17\nG90\nG90.1 G91.1\nG94\nG40\nG02 X10 I5 K5").size() == 2);
  CHECK(reported(kFeed + "G..18\nG17 G90 G91.1 G94 G40 F100\nG02 X10 I5 K5") ==
        Places{"SC1004 2:2", "SC2105 4:12"});
}

TEST_CASE("a code that is not known leaves the motion unknown until a motion code",
          "[ipr][unknown]") {
  CHECK(reported("G00 X1\nG205 X5\nX3 Q1\nG00 X1 Q1") == Places{"SC2001 2:1", "SC2004 4:8"});
}

TEST_CASE("a feed that is missing is reported once", "[ipr][unknown]") {
  CHECK(reported("G01 X1\nX2\nX3\nF100\nX4") == Places{"SC2102 1:1"});
  CHECK(reported("G01 X1 F-5\nX2\nF0\nX3") == Places{"SC2007 1:8", "SC2102 4:1"});
}

TEST_CASE("of two codes of a group nobody knows which is in force", "[ipr][unknown]") {
  CHECK(reported(kFeed + "G17 G18\nG02 X10 I5 K5") == Places{"SC2002 2:5"});
  CHECK(reported("G93 G94\nG01 X1") == Places{"SC2002 1:5"});
}

TEST_CASE("an error within a curve leaves it, and the rest of its lines report nothing",
          "[ipr][unknown]") {
  CHECK(reported(kFeed + "G06.2 P3 K0 X0 Y0\nK0 X1 Y..1\nK0 X2\nK1\nK1\nK1\nG00 X0 Y0 Q1") ==
        Places{"SC1004 3:8", "SC2004 8:11"});
  CHECK(reported(kFeed + "G05.2 X1 Y1 P1 L3\nX2 Y2\nX3 Y3 P1\nG05.3\nG00 X0 Q1") ==
        Places{"SC2005 3:1", "SC2004 6:8"});
}

TEST_CASE("a curve that begins after an unknown one is read to its end", "[ipr][unknown]") {
  const std::string points = "K0 X5 Y5\nK0 X10 Y0\nK1\nK1\nK1\n";
  CHECK(reported(kFeed + "G00 X..0 Y0\nG06.2 P3 K0 X0 Y0\n" + points + "G06.2 P3 K0 X10 Y0\n" +
                 points + "G01 X1") == Places{"SC1004 2:6"});
}

TEST_CASE("an error within G05 leaves the tangent at its end unknown until the next motion",
          "[ipr][unknown]") {
  const std::string failed = kFeed + "G05 X5 Y0 II1 J2 P-1 Q-2\n";
  CHECK(reported(failed + "G05 X10 Y0 P1 Q1\nX15 Y0 P1 Q1") == Places{"SC1002 2:11"});
  CHECK(reported(kFeed + "G05 X5 Y0 I1 J2 P-1\nX10 Y0 P1 Q1") == Places{"SC2005 2:1"});
  CHECK(reported(failed + "M70\nM72\nG05 X10 Y0 P1 Q1") == Places{"SC1002 2:11"});
  CHECK(reported(failed + "G01 X1\nG05 X10 Y0 P1 Q1") == Places{"SC1002 2:11", "SC3118 4:1"});
  CHECK(reported(failed + "G05 X9 Y0 I1 J1 P1 Q1\nX1 Y1 P1 Q1\nG01 X2 Q1") ==
        Places{"SC1002 2:11", "SC2004 5:8"});
}

TEST_CASE("an unknown length leaves Z unknown until the length is known", "[ipr][unknown]") {
  const std::string tools = "G10 L1 P1 Z3\n";
  CHECK(reported(tools + "G43 H9\nG00 Z1\n" + kFeed + "G18 G02 X9 Z9 R1") == Places{"SC2112 2:5"});
  CHECK(reported(tools + "G43 H9\nG49\nG00 X0 Y0 Z0\n" + kFeed + "G18 G02 X9 Z9 R1").back() ==
        "SC2109 6:15");
}

TEST_CASE("an error in a table leaves its values unknown", "[ipr][unknown]") {
  const std::string tool = "G10 L1 PL R5\n";
  CHECK(reported(tool + "G41 D1\nG40\nG00 X1 Q1") == Places{"SC1002 1:8", "SC2004 4:8"});
  CHECK(reported("G10 L1 P0 R5\nG41 D1\nG40\nG43 H1\nT1\nM06") == Places{"SC2007 1:8"});
  CHECK(reported("G10 L1 P0 R5\n" + kFeed + "G02 X9 Y9 R1") == Places{"SC2007 1:8", "SC2109 3:11"});
  CHECK(reported("G10 L2 P99 X5\n" + kFeed + "G02 X9 Y9 R1\nG41 D1").size() == 2);
  CHECK(reported("G10 L3 P1 R5\nG41 D1") == Places{"SC2007 1:5"});
  CHECK(reported("#2001=[1\nG43 H1", Dialect::fanuc) == Places{"SC1017 1:7"});
}

TEST_CASE("a code that is refused leaves open what it would have set", "[ipr][unknown]") {
  CHECK(reported("G8L X1 Y1 Z-1 R1\nX2") == Places{"SC1002 1:3"});
  CHECK(reported("G08 P1\nX2\nG00 X2 Q1") == Places{"SC2001 1:1", "SC2004 3:8"});
  CHECK(reported("G87 X1 YO Z-1\nX2\nX3") == Places{"SC2161 1:1"});
  CHECK(reported("G33 X..1\nX2") == Places{"SC2114 1:1"});
}

TEST_CASE("a letter without a number, right after a number, may be meant for a digit",
          "[ipr][unknown]") {
  CHECK(reported(kFeed + "G01 Y5 X1O\nG02 X9 Y9 R1") == Places{"SC1002 2:10"});
  CHECK(reported(kFeed + "G01 Y5 X1 O\nG02 X9 Y9 R1") == Places{"SC1002 2:11", "SC2109 3:11"});
  CHECK(reported(kFeed + "G9O\nG91 X1\nG1B\nG02 X10 I5 K5").size() == 2);
  CHECK(reported(kFeed + "G1B\nG02 X10 I5 K5") == Places{"SC1002 2:3"});
  CHECK(reported("S100 M3\nM7O\n" + kFeed + "G81 X1 Z-1 R1").size() == 1);
}

TEST_CASE("a line number that cannot be read may be the one that is missing", "[ipr][unknown]") {
  const Dialect fanuc = Dialect::fanuc;
  CHECK(reported_of_all("GOTO 10\nN1O G00 X1", fanuc) == Places{"SC1002 2:3"});
  CHECK(reported_of_all("N1l G00 X1\nGOTO 10", fanuc) == Places{"SC1002 1:3"});
  CHECK(reported_of_all("GOTO 10\nNIO G00 X1", fanuc) == Places{"SC1020 2:1"});
  CHECK(reported_of_all("GOTO 10\nN1X[SIN[30]]", fanuc).front() == "SC2308 1:1");
  CHECK(reported("GOTO 2\nN1O\nN2\nGOTO 10", fanuc).front() == "SC2308 4:1");
}

TEST_CASE("an end that cannot be read may be the one that is missing", "[ipr][unknown]") {
  CHECK(reported_of_all("o100 sub\no100 e]dsub") == Places{"SC1002 2:6"});
  CHECK(reported_of_all("o1 sub\no1 e8dsub\no1 call") == Places{"SC2006 2:4"});
  CHECK(reported_of_all("o110 if [0]\no110 e8dif") == Places{"SC2006 2:6"});
  CHECK(reported_of_all("o110 if [1]\no110 e8dif") == Places{"SC2006 2:6"});
  CHECK(reported_of_all("o110 if [1]\noN10 endif") == Places{"SC1002 2:1"});
  CHECK(reported_of_all("o110 if [0]\noN10 endif") == Places{"SC1002 2:1"});
  // where the lines after it are not read, what is missing is reported instead
  CHECK(reported("o100 sub\no100 endsbu") == Places{"SC2303 1:1"});
}

TEST_CASE("nothing is added at the end of the program to what a line has reported",
          "[ipr][unknown]") {
  CHECK(reported(kFeed + "o1 if 1\nG01 X1") == Places{"SC1017 2:7"});
  CHECK(reported("o1 sub 5\nG00 X1") == Places{"SC1029 1:8"});
  CHECK(reported("G00 X[\no1 if [1]\nG00 X1").size() == 2);
}

TEST_CASE("modes are restored with what was unknown of them", "[ipr][unknown]") {
  CHECK(reported(kFeed + "G..18\nM70\nG17 G90 G91.1 G94 G40\nM72\nG02 X10 I5 K5") ==
        Places{"SC1004 2:2"});
}

TEST_CASE("a value that rests on an error is unknown wherever it is used", "[ipr][unknown]") {
  CHECK(reported("#1=[3+4\nG00 X[1/#1]") == Places{"SC1017 1:4"});
  CHECK(reported("#1=1\no1 while [#1 LT 5]\n#1=[#1+1\no1 endwhile") == Places{"SC1017 3:4"});
  CHECK(reported("G00 X1..2\n#1=[1/#5420]") == Places{"SC1004 1:6"});
  CHECK(reported("IF [1/0 EQ 1] THEN #1=1\nG00 X[1/#1]", Dialect::fanuc) == Places{"SC1021 1:7"});
}

TEST_CASE("a label of which something is missing is reported once", "[ipr][unknown]") {
  CHECK(reported("o1 while [0]\no1 endwile\nG00 X1") == Places{"SC1020 2:4"});
  CHECK(reported("o1 endif\no1 endif\no2 endif").size() == 2);
}

TEST_CASE("with everything unknown no code reports what it would do", "[ipr][unknown]") {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::haas})
    for (const GCode& code : gcode_table()) {
      if (operands(code, Command{}, Modal{}).empty()) continue;
      if (is_of_haas(code) != (dialect == Dialect::haas)) continue;
      const std::string line = line_of(code);
      CAPTURE(line, static_cast<int>(dialect));
      CHECK(after_a_missing_call(line, dialect).empty());
    }
}

TEST_CASE("a code settles what it sets whole", "[ipr][unknown]") {
  for (const GCode& code : gcode_table()) {
    if (code.act == restore_modes) continue;  // which sets many, and settles none by itself
    CAPTURE(code_name(code));
    CHECK(results(code, Command{})
              .without(kPosition)
              .without(settled(code))
              .without({Part::motion, Part::shift, Part::tool_data})
              .has_any(kEverything) == (code.letter == 'G' && code.number == 650));
  }
}

TEST_CASE("the sets of parts", "[ipr][unknown]") {
  Unknown parts{Part::x, Part::feed};
  CHECK(parts.has(Part::feed));
  CHECK(parts.has_any(kPosition));
  CHECK_FALSE(parts.without(kPosition).has_any(kPosition));
  parts.remove(Part::feed);
  parts.remove(Part::x);
  CHECK(parts.empty());
  CHECK(position_part(2) == Part::z);
  CHECK(set_by("FGM").has(Part::end));
  CHECK(set_by("IJK").empty());
}
