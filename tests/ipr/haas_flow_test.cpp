// SPDX-License-Identifier: MIT
// Haas' conditions before M99, M99 P within the program in which it stands, and jumps after words.
// Haas' mill operator's manual, "Conditional Expressions", "M99", "GOTO".
#include <catch2/catch.hpp>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

Stops haas_places(const std::string& text, const InterpreterOptions& options = kHaas) {
  return places_along_x(text + "\nM30\n", options);
}

}  // namespace

TEST_CASE("a condition decides whether Haas' M99 acts", "[ipr][flow][haas]") {
  const std::string after = "\nX2.\nN10 X3.";
  CHECK(haas_places("#100=5\nG00 X1.\n[#100 LT 10] M99 P10" + after) == Stops{1, 3});
  CHECK(haas_places("#100=15\nG00 X1.\n[#100 LT 10] M99 P10" + after) == Stops{1, 2, 3});
  CHECK(haas_places("G00 X1.\nN5 [1] M99 P10" + after) == Stops{1, 3});
  CHECK(haas_places("G00 X1.\n[#0] M99 P10" + after) == Stops{1, 2, 3});
  CHECK(haas_places("#1=0\nG00\nN5 #1=#1+1\nX#1\n[#1 LT 3] M99 P5") == Stops{1, 2, 3});
  CHECK(haas_places("G65 P2 A1.\nG65 P2 A2.\nM30\nO2\n[#1 EQ 1] M99\nG00 X#1\nM99") == Stops{2});
  CHECK(haas_places("#100=#100+1\nG00 X#100\n[#100 LT 3] M99") == Stops{1, 2, 3});
}

TEST_CASE("an error in a condition leaves the order open", "[ipr][flow][haas]") {
  CHECK(haas_reported("G00 X1.\n[#100 LT] M99 P10\nX2.\nN10 X3.") == Places{"SC1016 2:9"});
  CHECK(haas_reported("#1=X\n[#1 GT 2] M99 P7\nN10 G00 X3.") == Places{"SC1018 1:4"});
  CHECK(haas_reported("[#1 LT 10] X2.") == Places{"SC1007 1:1"});
  CHECK(haas_reported("G00 X2. [#1 LT 10] M99 P7") == Places{"SC1007 1:9"});
  CHECK(haas_reported("[#0 EQ #0] M99 P7\nN10 G00 X3.") == Places{"SC2308 1:12"});
  CHECK(reported("[#100 LT 10] M99 P10\nN10 G00 X3.", Dialect::fanuc) == Places{"SC1007 1:1"});
  CHECK(reported("[#100 LT 10] M99 P10\nN10 G00 X3.") == Places{"SC1007 1:1"});
}

TEST_CASE("Haas' M99 P stays in the program in which it stands", "[ipr][flow][haas]") {
  const std::string text =
      "M98 P2\nG00 X1.\nM30\nN10 X9.\nM30\nO2\nG00 X5.\nM99 P10\nX6.\nN10 X7.\nM99";
  CHECK(haas_places(text) == Stops{5, 7, 1});
  CHECK(haas_places(text, kFanuc) == Stops{5, 9});
  CHECK(haas_places("M97 P100\nG00 X1.\nM30\nN10 X4.\nM99\nN100 G00 X2.\nM99 P10") ==
        Stops{2, 4, 1});
  CHECK(haas_places("M98 P2 L2\nM30\nO2\nG91 G00 X1.\nM99 P10\nX50.\nN10 M99") == Stops{1, 2});
}

TEST_CASE("Haas' GOTO after words jumps when they have acted", "[ipr][flow][haas]") {
  CHECK(haas_places("G00 X1. GOTO 10\nX2.\nN10 X3.") == Stops{1, 3});
  CHECK(haas_places("#1=3.\nG00 X1. IF [#1 EQ 3] GOTO10\nX2.\nN10 X3.") == Stops{1, 3});
  CHECK(haas_places("#1=4.\nG00 X1. IF [#1 EQ 3] GOTO10\nX2.\nN10 X3.") == Stops{1, 2, 3});
  CHECK(haas_places("#1=7\nG00 X1. GOTO[#1+3]\nX2.\nN10 X3.") == Stops{1, 3});
  CHECK(
      haas_places("#1=0\nG91 G00\nWHILE [#1 LT 5] DO 1\n#1=#1+1\nX1. IF [#1 EQ 2] GOTO 10\nEND 1\n"
                  "N10 X10.") == Stops{1, 2, 12});
  CHECK(haas_places("M98 P2\nG00 X1.\nM30\nO2\nG00 X5. GOTO 10\nX6.\nN10 X7.\nM99") ==
        Stops{5, 7, 1});
  CHECK(haas_places("/ G00 X1. GOTO 10\nG00 X2.\nN10 X3.",
                    {.block_skip = true, .dialect = Dialect::haas}) == Stops{2, 3});
}

TEST_CASE("a wrong jump after words is reported as one at the beginning", "[ipr][flow][haas]") {
  CHECK(haas_reported("G00 X1. GOTO 11\nN10 X3.") == Places{"SC2308 1:9"});
  CHECK(haas_reported("G00 X1. GOTO 1.5\nN10 X3.") == Places{"SC1029 1:14"});
  CHECK(haas_reported("G00 X1. GOTO 10 X5.\nN10 X3.") == Places{"SC1029 1:17"});
  CHECK(haas_reported("#1=X\nG00 X1. GOTO #1\nN10 X3.") == Places{"SC1018 1:4"});
  CHECK(haas_reported("G00 X1. M99 GOTO 10\nN10 X3.") == Places{"SC1029 1:13"});
  CHECK(haas_reported("G04 P100 GOTO 10\nN10 X3.") == Places{"SC1029 1:10"});
  CHECK(haas_reported("#1=1\nG04 P100 IF [#1 EQ 2] GOTO 10\nN10 X3.") == Places{"SC1029 2:10"});
  CHECK(haas_reported("M30 GOTO 10\nN10 X3.") == Places{"SC1029 1:5"});
  CHECK(reported("G00 X1. GOTO 10\nN10 X3.", Dialect::fanuc) == Places{"SC1020 1:9"});
}

TEST_CASE("lines that Haas' jumps pass over are checked", "[ipr][flow][haas][unreachable]") {
  const InterpreterOptions check{.dialect = Dialect::haas, .unreachable_too = true};
  CHECK(reported("G00 X1.\n[1 EQ 1] M99 P10\nX2. ]\nN10 X3.", check) == Places{"SC1017 3:5"});
  CHECK(reported("G00 X1. GOTO 10\nX2. ]\nN10 X3.", check) == Places{"SC1017 2:5"});
  CHECK(reported("G00 X1.\n[1 EQ 2] M99 P10 ]\nN10 X3.", check) == Places{"SC1017 2:18"});
}

}  // namespace softcnc::ipr
