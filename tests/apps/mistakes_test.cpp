// SPDX-License-Identifier: MIT
// What people get wrong in programs that they write or change by hand, as they see it reported.
#include <catch2/catch.hpp>
#include <cstddef>
#include <vector>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

namespace {

struct Mistake {
  const char* what;
  const char* program;  // M30 follows
  const char* place;    // line:column
  const char* code;
  const char* advice;  // what tells somebody how to mend it; "" where nothing does
  const char* options = "";
};

const std::vector<Mistake> kMistakes{
    // characters and numbers
    {"O for 0 alone", "G1 XO F100", "1:4", "SC1002", "is the digit 0 meant?"},
    {"O for 0 in a number", "G90 G1 X1O F100", "1:10", "SC1002", "is the digit 0 meant?"},
    {"l for 1", "G90 G0 Xl0", "1:8", "SC1002", "is the digit 1 meant?"},
    {"a comma for the point", "G1 X1,5 F100", "1:6", "SC1001", "the decimal point is '.'"},
    {"two points", "G1 X1..5 F100", "1:5", "SC1004", "write one decimal point"},
    {"two signs", "G0 X+-5", "1:5", "SC1003", "write one sign, before the digits"},
    {"an exponent", "G0 X1e3", "1:4", "SC1006", "write the number out: 100000, not 1E5"},
    {"a unit behind a number", "G0 X10mm", "1:7", "SC1002", "G20 (inch) and G21 (mm)"},
    {"a minus of a word processor", "G0 X\u22125", "1:5", "SC1001", "a minus sign is '-'"},
    {"a letter of another alphabet", "G0 \u04255", "1:4", "SC1001", "in ASCII it is X"},
    {"a letter without a number", "G1 X Y10 F100", "1:4", "SC1002", "or remove the letter"},
    {"a comment left open", "(a comment\nG0 X1", "1:1", "SC1009", "close the comment with ')'"},
    {"block skip within a line", "G0 X1 / Y1", "1:7", "SC1011", "at the beginning of the line"},
    // words
    {"X twice", "G1 X10 X20 F100", "1:8", "SC2003", "keep one of the two"},
    {"two codes of one group", "G0 G1 X10", "1:4", "SC2002", "keep one of them, or use two lines"},
    {"a word that nothing uses", "G1 X10 E5 F100", "1:8", "SC2004", "remove the word"},
    {"a fourth axis", "G0 A90", "1:4", "SC2008", "remove the word"},
    {"an unknown G", "G55.5 X1", "1:1", "SC2001", ""},
    {"an unknown M", "M123", "1:1", "SC2001", "its machine file says so"},
    {"G70 for inches", "G70\nG0 X1", "1:1", "SC2001", "G20 is inch"},
    {"text without brackets", "hello world", "1:1", "SC1020", "a title before the program"},
    // motion
    {"no feed", "G1 X10", "1:1", "SC2102", "write F with the feed"},
    {"a feed of 0", "G1 X10 F0", "1:8", "SC2102", "write F with the feed"},
    {"a negative feed", "G1 X10 F-100", "1:8", "SC2007", "must not be negative"},
    {"a place without a motion code", "X10", "1:1", "SC2101", "write G00, G01, G02 or G03"},
    {"an arc without a centre", "F100\nG2 X10 Y0", "2:4", "SC2107", "give R, or the centre"},
    {"a radius too small", "F100\nG2 X10 Y0 R2", "2:11", "SC2109", "at least half the distance"},
    {"a full circle by R", "F100\nG2 X0 Y0 R5", "2:10", "SC2108", "give the centre (I J K)"},
    {"an arc that does not close", "F100\nG2 X10 Y0 I4 J0", "2:4", "SC2103", "or use R"},
    {"centres as places", "F100\nG0 X50 Y50\nG2 X60 Y60 I50 J60", "3:4", "SC2103", "G90.1"},
    {"R and a centre", "F100\nG2 X10 Y0 R5 I5", "2:11", "SC2106", "give either R or the centre"},
    {"G53 in G91", "G91\nG53 G0 Z0", "2:1", "SC2111", "write G90"},
    {"beyond the travel", "F100\nG1 X200", "2:1", "SC4001",
     "--work G54=", "--set axis.x.min_mm=0 --set axis.x.max_mm=100"},
    // tools and cycles
    {"a change of tools without T", "M6", "1:1", "SC2204", "write T with the tool number"},
    {"compensation without a radius", "G41 D99\nG1 X10 F100", "1:5", "SC2142", "by G10 L1 P R"},
    {"a cycle without R", "F100\nG81 X1 Y1 Z-5", "2:1", "SC2005", "needs R, the height"},
    {"a cycle without Z", "F100\nG81 X1 Y1 R2", "2:1", "SC2005", "needs Z, the bottom of the hole"},
    {"pecks without Q", "F100\nG83 X1 Y1 Z-5 R2", "2:1", "SC2005", "needs Q, the depth"},
    {"a dwell without P", "G4", "1:1", "SC2005", "needs P, the time in seconds"},
    {"tapping without M03", "G84 X0 Y0 Z-5 R2 F1", "1:1", "SC2163", "turn the spindle on"},
    {"an offset of no system", "G10 L2 X0", "1:1", "SC2005", "needs P, the work system"},
    // expressions and the order of lines
    {"a bracket left open", "G0 X[1+2", "1:5", "SC1017", "write '[' and ']' in pairs"},
    {"a variable without a value", "G0 X#<missing>", "1:5", "SC1024", "assign to the variable"},
    {"a division by zero", "#1=0\nG0 X[1/#1]", "2:8", "SC1021", "test the divisor before"},
    {"a function of another language", "G0 X[SINE[30]]", "1:6", "SC1018", "use ABS ACOS"},
    {"> for GT", "#1=2\no1 if [#1 > 1]\nG0 X1\no1 endif", "2:11", "SC1019", "write GT"},
    {"an if without its end", "o1 if [1 GT 0]\nG0 X1", "1:1", "SC2302", "end it by the same label"},
    {"a subprogram that is not there", "o<foo> call", "1:1", "SC2301", "--subprograms"},
    {"a jump to no line", "GOTO 10", "1:1", "SC2308", "give the number N", "--dialect fanuc"},
    {"IF without THEN", "#1=1\nIF [#1 EQ 1] G0 X1", "2:14", "SC1029", "GOTO or THEN is expected",
     "--dialect fanuc"},
    // other controls
    {"Sinumerik's assignment", "G0 X=10", "1:4", "SC1002", "'=' is read by Sinumerik's controls"},
    {"Klartext", "BEGIN PGM TEST MM\nL X+10 Y+20 R0 F100\nEND PGM TEST MM", "1:1", "SC2383",
     "generate it for LinuxCNC or FANUC"},
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("a mistake is one error at its place, with advice on a terminal", "[apps][check]") {
  REQUIRE(kMistakes.size() >= 45);
  const Folder folder;
  std::size_t advised = 0;
  for (const Mistake& mistake : kMistakes) {
    INFO(mistake.what << ": " << mistake.program);
    write(folder / "p.nc", std::string(mistake.program) + "\nM30\n");
    const std::string out =
        on_terminal("cd " + (folder / "") + " && NO_COLOR=1 " SOFTCNC_BINARY " check p.nc " +
                    mistake.options)
            .out;
    CHECK(count(out, ": error: ") == 1);
    CHECK(shows(out, std::string("p.nc:") + mistake.place + ": error: ... [" + mistake.code + "]"));
    if (*mistake.advice == '\0') continue;
    CHECK(count(out, mistake.advice) > 0);
    ++advised;
  }
  CHECK(advised >= 35);
}
