// SPDX-License-Identifier: MIT
// tests/bad: every way to be wrong has a file, whose first line says what is to be reported and
// where.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

std::vector<std::filesystem::path> files() {
  std::vector<std::filesystem::path> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(SOFTCNC_SOURCE_DIR) + "/tests/bad"))
    if (entry.path().extension() == ".nc") all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What is between "(expect" and ")" on the first line; in UTF-16 too.
std::string expectation(const std::string& bytes) {
  std::string line;
  for (const char c : bytes.substr(0, bytes.find(')')))
    if (c > 0) line += c;
  const std::string key = "(expect ";
  REQUIRE(line.find(key) != std::string::npos);
  return line.substr(line.find(key) + key.size());
}

Places expected_places(const std::string& expectation) {
  std::istringstream list(expectation.substr(0, expectation.find(';')));
  Places all;
  for (std::string place; std::getline(list, place, ',');)
    all.push_back(place.substr(place.find_first_not_of(' ')));
  return all;
}

/// "; axes XZ": the machine has these only. "; limit 1000": its loops run so many lines.
Machine machine_for(const std::string& expectation) {
  Machine machine;
  const std::string limit = "; limit ";
  if (const std::size_t at = expectation.find(limit); at != std::string::npos)
    machine.program.block_limit = std::stoi(expectation.substr(at + limit.size()));
  const std::string key = "; axes ";
  const std::size_t found = expectation.find(key);
  if (found == std::string::npos) return machine;
  for (std::size_t i = 0; i < kAxes; ++i)
    machine.axes[i].present =
        expectation.find(kAxisLetters[i], found + key.size()) != std::string::npos;
  return machine;
}

/// "; fanuc": read in this dialect. "; check": compared with the other one.
InterpreterOptions options_for(const std::string& expectation) {
  InterpreterOptions options;
  if (expectation.find("; fanuc") != std::string::npos) options.dialect = Dialect::fanuc;
  options.compare_dialects = expectation.find("; check") != std::string::npos;
  return options;
}

struct Told {
  Places places;
  std::multimap<Code, std::string> texts;
};

Told told_by(const std::filesystem::path& file) {
  const std::string bytes = bytes_of(file);
  const Interpreted result =
      interpret(bytes, machine_for(expectation(bytes)), options_for(expectation(bytes)));
  Told told{places(result), {}};
  for (const Diagnostic& diagnostic : result.diagnostics)
    told.texts.emplace(diagnostic.code, diagnostic.message);
  return told;
}

/// For every code one of the texts it is told by.
const std::multimap<Code, std::string> kTexts{
    {Code::SC1001, "unknown character '$'; no spindle can be chosen, there is one"},
    {Code::SC1001, "unknown character '@'; polar coordinates are not supported"},
    {Code::SC1001, "unknown character '\u00d7' (U+00D7)"},
    {Code::SC1001, "unknown character byte 0x07"},
    {Code::SC1002, "no number after X"},
    {Code::SC1002, "no number after O; is the digit 0 meant?"},
    {Code::SC1002, "no number after G; is the digit 0 meant?"},
    {Code::SC1002, "no number after X, only '-'"},
    {Code::SC1003, "a sign inside the number '--1'"},
    {Code::SC1004, "two decimal points in '1.2.3'"},
    {Code::SC1005, "'1234567890' has more than 9 digits before the decimal point"},
    {Code::SC1006, "'X1E5' has an exponent; write the number out"},
    {Code::SC1007, "the number '5' has no letter before it"},
    {Code::SC1009, "the comment has no ')'"},
    {Code::SC1010, "a comment inside a comment"},
    {Code::SC1011, "'/' (block skip) within a line; it stands at its beginning"},
    {Code::SC1012, "'%' within a line; it stands on a line of its own"},
    {Code::SC1012, "'%' with more behind it; it stands on a line of its own"},
    {Code::SC1012,
     "the '%' on line 3 ends the program, and no '%' has begun it: this would be lost"},
    {Code::SC1013, "the file is in UTF-16; save it as UTF-8 or ASCII"},
    {Code::SC1013, "the file is in UTF-32; save it as UTF-8 or ASCII"},
    {Code::SC1014, "a byte 0; the file is damaged or no text"},
    {Code::SC1015, "the line is longer than 16384 bytes"},
    {Code::SC1016, "a number, '#', '[' or a function is expected instead of ']'"},
    {Code::SC1016, "a number, '#', '[' or a function is expected at the end of the line"},
    {Code::SC1017, "this '[' has no ']'"},
    {Code::SC1017, "'#1+#2' needs '[' before it and ']' behind it"},
    {Code::SC1017, "this ']' has no '['"},
    {Code::SC1017, "SIN needs '[' behind it"},
    {Code::SC1017, "'[' is expected instead of '1'"},
    {Code::SC1018, "a function is expected instead of 'SINE'"},
    {Code::SC1019, "an operator or ']' is expected instead of '='"},
    {Code::SC1019, "an operator or ']' is expected instead of 'ISNT'"},
    {Code::SC1020, "'WHLE' is no keyword and no function"},
    {Code::SC1020, "a keyword like 'call' is expected instead of 'subb'"},
    {Code::SC1021, "division by zero"},
    {Code::SC1022, "SQRT takes numbers from 0"},
    {Code::SC1022, "a negative number takes only a whole exponent"},
    {Code::SC1023, "the result of EXP is too large"},
    {Code::SC1023, "the result of '**' is too large"},
    {Code::SC1024, "#<depth> has no value"},
    {Code::SC1025, "there is no variable #6000"},
    {Code::SC1025, "the number of a variable is a whole number"},
    {Code::SC1026, "#5420 cannot be assigned to"},
    {Code::SC1026, "#<_x> cannot be assigned to"},
    {Code::SC1027, "more than 64 brackets, signs or '#' within one another"},
    {Code::SC1028, "'=' and a value is expected at the end of the line"},
    {Code::SC1028, "'=' and a value is expected instead of 'X'"},
    {Code::SC1029, "the end of the line is expected instead of 'G'"},
    {Code::SC1029, "GOTO or THEN is expected instead of '#'"},
    {Code::SC1029, "GOTO takes a whole number from 0"},
    {Code::SC1030, "this '<' has no '>'"},
    {Code::SC1030, "the name of a variable is empty"},
    {Code::SC1031, "alarm of the program: NO TOOL"},
    {Code::SC1031, "the program aborts: wrong tool"},
    {Code::SC1032,
     "AND, OR, XOR ask whether numbers are 0; in the fanuc dialect: join the bits of whole numbers "
     "(1 here, 2 there)"},
    {Code::SC1032,
     "MOD is never negative; in the fanuc dialect: rounds its operands and has the sign of the "
     "first (1 here, -3 there)"},
    {Code::SC1033,
     "FIX, FUP of a negative number round down, up; in the fanuc dialect: round towards 0, away "
     "from 0 (-2 here, -1 there)"},
    {Code::SC1034,
     "AND, OR, XOR beside other operators bind looser than all others; in the fanuc dialect: AND "
     "binds as *, OR and XOR as + (1 here, 2 there)"},
    {Code::SC1035,
     "a variable without a value is 0; in the fanuc dialect: is vacant: a word with it counts as "
     "not written (0 here, vacant there)"},
    {Code::SC1036,
     "a variable read on the line that assigns to it has its value from before; in the fanuc "
     "dialect: has the value assigned, if that stands before (0 here, 5 there)"},
    {Code::SC1037,
     "#2001 to #2400, #3000, #3006, #4001 to #4120, #5001 to #5203 are variables like others; in "
     "the fanuc dialect: are those of the system: tools, alarm, stop, modes, positions"},
    {Code::SC1038,
     "#31 to #33 in a called program belong to all programs; in the fanuc dialect: belong to the "
     "call (0 here, vacant there)"},
    {Code::SC1039,
     "an offset assigned to (#5211 to #5382) counts from the next code that selects or changes "
     "one; in the fanuc dialect: counts at once"},
    {Code::SC2120,
     "G04 P counts milliseconds; in the linuxcnc dialect: counts seconds (here and on 1 more "
     "line)"},
    {Code::SC2121, "P of a canned cycle counts seconds; in the fanuc dialect: counts milliseconds"},
    {Code::SC2122,
     "G10 L2 in G91 sets the origin to the values; in the fanuc dialect: adds the values to the "
     "origin"},
    {Code::SC2123,
     "G10 L1, L10, L11 with R alone sets the radius of tool P; in the fanuc dialect: sets the "
     "length "
     "of offset P (L10) or its wear (L1, L11)"},
    {Code::SC2124,
     "G43 without H takes the length of the tool in the spindle; in the fanuc dialect: takes the "
     "last H"},
    {Code::SC2125,
     "G41, G42 with D0 takes the radius of the tool in the spindle; in the fanuc dialect: takes a "
     "radius of 0"},
    {Code::SC2126,
     "G52 beside G92 is one and the same shift; in the fanuc dialect: is a shift of its own, which "
     "adds to that of G92"},
    {Code::SC2127, "G53 with G01 moves at the feed; in the fanuc dialect: moves as a rapid"},
    {Code::SC2128,
     "M98 P of five digits or more without L calls the program O P; in the fanuc dialect: calls "
     "the program of the last four digits, as often as those before them say"},
    {Code::SC2129,
     "a canned cycle before any G98 or G99 goes out to R; in the fanuc dialect: goes out to where "
     "the first of the row began"},
    {Code::SC2130,
     "G41, G42 without D take the radius of the tool in the spindle; in the fanuc dialect: take "
     "the last D"},
    {Code::SC2131,
     "G74, G84, G89 with G98 go out at the feed all the way; in the fanuc dialect: go out at the "
     "feed to R, where the spindle of a tap turns back, and on as a rapid"},
    {Code::SC2132,
     "the line on which cutter compensation begins leads beside its end; in the fanuc dialect: "
     "leads square to the beginning of the next move"},
    {Code::SC2133,
     "G61 follows the path exactly, without a stop; in the fanuc dialect: stops at the end of "
     "every block"},
    {Code::SC2001, "G48 is not supported"},
    {Code::SC1001, "unknown character ','; chamfers and roundings within a line are not supported"},
    {Code::SC2001, "G69 is not supported in the linuxcnc dialect"},
    {Code::SC1050, "'line' is no command; there are l, pcw, pccw, dcw, dccw, s and f"},
    {Code::SC1051, "numbers without a command before them"},
    {Code::SC1052, "pcw takes 4 numbers, dx dy cx cy; here are 3"},
    {Code::SC1052, "l takes 2 to 3 numbers, dx dy [dz]; here is 1"},
    {Code::SC1052, "f takes 1 number, mm/min; here are 2"},
    {Code::SC1052, "s takes a number and points, n dx dy ...; here are 0"},
    {Code::SC1053, "'l' within a line; a command begins one"},
    {Code::SC2001, "G05.7 is not supported"},
    {Code::SC2002, "G01 beside another code of the same group"},
    {Code::SC2003, "X is given twice"},
    {Code::SC2003, "F is given twice"},
    {Code::SC2004, "Q is used by no code of this line"},
    {Code::SC2005, "G04 needs P, the time in seconds"},
    {Code::SC2006, "O stands alone on its line"},
    {Code::SC2006, "O stands alone on its line; is the digit 0 meant?"},
    {Code::SC2007, "F must not be negative"},
    {Code::SC2007, "a feed below 0.000001 mm/min"},
    {Code::SC2007, "T takes a whole number from 0"},
    {Code::SC2007, "T takes a whole number up to 999999999"},
    {Code::SC2007, "S must not be negative"},
    {Code::SC2007, "P, the time of G04, must not be negative"},
    {Code::SC2007, "P, a tolerance of G64, must not be negative"},
    {Code::SC2008, "the machine has no axis Y"},
    {Code::SC2008, "G02 needs axis Y, which the machine lacks"},
    {Code::SC2101, "X with no motion code in force"},
    {Code::SC2102, "G01 needs a feed, and F is not set"},
    {Code::SC2103,
     "G02 ends 0.298 mm off its circle (radius 20.3 mm at the start, 20.002 mm at the end)"},
    {Code::SC2104, "G02 has no radius: its centre is its start"},
    {Code::SC2105, "K lies across the plane of the arc"},
    {Code::SC2106, "G02 takes R or a centre, not both"},
    {Code::SC2107, "G03 needs a centre or R"},
    {Code::SC2108, "G02 ends where it starts; R cannot tell its centre"},
    {Code::SC2109, "a radius of 4.99 mm does not reach an end 10 mm away"},
    {Code::SC2005, "G41.1 needs D, the diameter of the tool"},
    {Code::SC2007, "D takes a whole number from 0"},
    {Code::SC2007, "L, the orientation of a lathe tool, can be 0 only"},
    {Code::SC2115, "M72 restores modes, and no M70 or M73 has saved any at this level of calls"},
    {Code::SC2140, "M06 while cutter compensation is on"},
    {Code::SC2140, "G06.2 while cutter compensation is on"},
    {Code::SC2141, "G42.1, and cutter compensation is on already"},
    {Code::SC2141, "D, and cutter compensation is on already"},
    {Code::SC2142, "the radius of tool 7 is not known"},
    {Code::SC2143,
     "the first move of cutter compensation must be longer than the tool's radius, 5 mm"},
    {Code::SC2144, "no arc leads from here to the side of the end of this arc"},
    {Code::SC2145, "the tool, radius 5 mm, does not fit into an arc of radius 4 mm"},
    {Code::SC2146, "the tool, radius 5 mm, does not fit into the inside corner before this move"},
    {Code::SC2147, "the tool, radius 5 mm, does not fit between the inside corners of this move"},
    {Code::SC2150, "the tool, radius 2 mm, does not fit between this move and the one before"},
    {Code::SC2151, "more than 10000 blocks without a move in the plane of the contour"},
    {Code::SC2148, "G41 without D: no tool is in the spindle; moves stay as they are"},
    {Code::SC2148, "G42 without D: tool 9 has no radius; moves stay as they are"},
    {Code::SC2148, "G41 without D, and none before; moves stay as they are"},
    {Code::SC2149, "G03 behind G40; the first move leads away on a line"},
    {Code::SC2110, "G01 beside G92: both take the axes"},
    {Code::SC2111, "G53 moves by G00 or G01 only, written beside it or in force"},
    {Code::SC2111, "G53 in G91: a place in machine coordinates is no distance"},
    {Code::SC2112, "the tool table has no tool 77"},
    {Code::SC2113, "G02 in a plane that the rotation of the work system tilts"},
    {Code::SC2114,
     "G33 is refused: threads need a spindle with an encoder, which the axes could follow"},
    {Code::SC2114,
     "M62 is refused: softcnc has no inputs and outputs that a program could read or set"},
    {Code::SC2114,
     "M52 is refused: softcnc has no input that could change or stop the feed; P0 is accepted"},
    {Code::SC2114,
     "M29 is refused: rigid tapping needs a spindle in step with the axis; G74 and G84 without M29 "
     "take a floating holder and a spindle that turns"},
    {Code::SC2114, "G84 with Q is refused: tapping in pecks needs a spindle in step with the axis"},
    {Code::SC2005, "G81 needs R, the height to which it retracts"},
    {Code::SC2005, "G82 needs Z, the bottom of the hole"},
    {Code::SC2005, "G83 needs Q, the depth of a peck"},
    {Code::SC2005, "G89 needs P, the time at the bottom"},
    {Code::SC2007, "P, the time at the bottom, must not be negative"},
    {Code::SC2007, "Q, the depth of a peck, must be above 0"},
    {Code::SC2007, "L, how often the cycle is repeated, is 1 at least"},
    {Code::SC2007, "L takes a whole number from 0"},
    {Code::SC2007, "K repeats a cycle in the fanuc dialect; here L does"},
    {Code::SC2007, "G83 on this line would take more than 10000 pecks"},
    {Code::SC2102, "G01 needs F on its own line while G93 is in force"},
    {Code::SC2160, "G81 without a position: X, Y or Z"},
    {Code::SC2161, "G76 needs a spindle that can be oriented"},
    {Code::SC2161, "G88 needs a hand that leads the tool out of the hole"},
    {Code::SC2162, "R lies below the bottom of the hole, 1 mm below 5 mm"},
    {Code::SC2163, "G86 needs a spindle that turns"},
    {Code::SC2163, "G84 needs a spindle that turns clockwise (M03)"},
    {Code::SC2163, "G74 needs a spindle that turns counter-clockwise (M04)"},
    {Code::SC2220, "G81 while G93 is in force: F cannot be its time"},
    {Code::SC2220, "G06.2 while G95 is in force: F cannot be its feed"},
    {Code::SC2221, "G96 needs work that turns: on a mill no radius is known"},
    {Code::SC2222, "G01 by G95 needs a spindle that turns"},
    {Code::SC2201, "F is above the machine's 15000 mm/min, which are used here and below"},
    {Code::SC2202, "the spindle turns at 0 to 24000 rpm; S is held within, here and below"},
    {Code::SC2203, "M03 without S: the spindle does not turn"},
    {Code::SC2204, "M06 without a tool: T is not set"},
    {Code::SC2205, "the program ends without M02 or M30"},
    {Code::SC2210, "G04 P counts seconds here: 500 s; 500 ms are P0.5"},
    {Code::SC2210, "G04 P counts milliseconds here: 1.5 ms; 1.5 s are P1500"},
    {Code::SC2301, "no subprogram o<poket> in this program; did you mean o<pocket>?"},
    {Code::SC2301, "no subprogram o100 in this program"},
    {Code::SC2301, "no subprogram O7 in this program"},
    {Code::SC2302, "'o1 while' has no 'o1 endwhile'"},
    {Code::SC2302, "'o2 do' has no 'o2 while'"},
    {Code::SC2302, "'o1 if' has no 'o1 endif'"},
    {Code::SC2302, "'DO 2' has no 'END 2'"},
    {Code::SC2303, "'o1 sub' has no 'o1 endsub'"},
    {Code::SC2303, "O2 ends without M99"},
    {Code::SC2303, "O2 has no end before O3"},
    {Code::SC2304, "'o1 endwhile' without 'o1 while'"},
    {Code::SC2304, "'o1 else' without 'o1 if'"},
    {Code::SC2304, "'o1 else' after 'o1 else'"},
    {Code::SC2304, "'END 1' without 'DO 1'"},
    {Code::SC2304, "the jump leads past 'DO 1' to before 'END 1'"},
    {Code::SC2305, "'o2 break' outside of a loop o2"},
    {Code::SC2306, "'o1 return' outside of 'o1 sub'"},
    {Code::SC2307, "'o2 sub' within 'o1 sub'"},
    {Code::SC2308, "no line N100 in the program"},
    {Code::SC2308, "no line N7 in O2"},
    {Code::SC2308, "no line N8 in the program"},
    {Code::SC2309, "more than 64 calls within each other; 'o1 sub' is among them 64 times"},
    {Code::SC2310, "'o1 while' has run more than 1000 lines"},
    {Code::SC2310, "jumping back to line 2 has run more than 1000 lines"},
    {Code::SC2310, "the search for what is missing has run more than 4 lines"},
    {Code::SC2311, "N is no argument of G65"},
    {Code::SC2311, "one argument too many: there is no local #31"},
    {Code::SC2312, "'END 1' before 'END 2': the loops cross"},
    {Code::SC2312, "'DO 4': a loop is numbered 1, 2 or 3"},
    {Code::SC2312, "'DO 1' within 'DO 1' of line 2"},
    {Code::SC2313, "'o1 repeat' within 'o1 if' of line 2"},
    {Code::SC2314, "o1 sub stands in this file before"},
    {Code::SC2315,
     "G66 is not supported: what it would call after every move cannot be seen in the lines "
     "themselves"},
    {Code::SC2350, "a spline through 1 point"},
    {Code::SC2351, "a point of the spline is the same as the point before it"},
    {Code::SC2352, "no f before it: the machine's 15000 mm/min are used here and below"},
    {Code::SC2353, "the file ends: the spline has 1 of its 3 points"},
    {Code::SC2353, "'l' too early: the spline has 1 of its 2 points"},
    {Code::SC2353, "a number behind the last point of the spline"},
    {Code::SC2351, "the point of the spline is the one before it"},
    {Code::SC3001, "L, the order of the curve, is a whole number from 3 to 10"},
    {Code::SC3001, "P, the order of the curve, is a whole number from 2 to 10"},
    {Code::SC3002, "the curve ends after 3 control points; its order asks for 4"},
    {Code::SC3004, "knot 1 after 2; knots must not decrease"},
    {Code::SC3005, "the first 3 knots must be equal"},
    {Code::SC3005, "the last 3 knots must be equal"},
    {Code::SC3006, "knot 1 stands 3 times in a row; at most 2 can be here"},
    {Code::SC3007, "R, the weight of a control point, must be above 0"},
    {Code::SC3008, "X leads to a place beyond 1000000 mm"},
    {Code::SC3008, "l leads to a place beyond 1000000 mm"},
    {Code::SC3008, "X gives an offset beyond 1000000 mm"},
    {Code::SC3008, "R is beyond 1000000000 mm"},
    {Code::SC3008, "R turns the work system by more than 36000 degrees"},
    {Code::SC3008, "#5221 takes from -1000000 to 1000000"},
    {Code::SC3009, "all control points of the NURBS are the same"},
    {Code::SC3010,
     "the NURBS cannot be computed: its weights, knots or coordinates differ too much in size"},
    {Code::SC3102, "a block of a curve needs its knot, K"},
    {Code::SC3103, "Y is missing in the first block of the curve"},
    {Code::SC3104, "G01 too early: the curve has 2 of its 3 closing knots"},
    {Code::SC3104, "a control point after 1 of 3 closing knots"},
    {Code::SC3104, "the program ends, and the curve has 1 of its 3 closing knots"},
    {Code::SC3105, "G01 within a curve of G06.2"},
    {Code::SC3109, "the curve begins 0.01 mm off the position"},
    {Code::SC3110, "P belongs to the first block of the curve"},
    {Code::SC3110, "F belongs to the first block of the curve"},
    {Code::SC3111, "a closing knot takes K alone"},
    {Code::SC3110, "D belongs to the first block of the curve"},
    {Code::SC3110, "L belongs to the first block of the curve"},
    {Code::SC3105, "M08 within a curve of G06.1"},
    {Code::SC3105, "G01 within a curve of G05.2"},
    {Code::SC3007, "P, the weight of a control point, must be above 0"},
    {Code::SC2005, "a control point of G05.2 needs Y"},
    {Code::SC2005, "a control point of G05.2 needs P, its weight"},
    {Code::SC2005, "G05 needs both P and Q"},
    {Code::SC2005, "G05 needs both I and J"},
    {Code::SC2005, "G05.1 needs both I and J"},
    {Code::SC2005, "G05 needs its end, X or Y"},
    {Code::SC3002, "2 control points are too few for a NURBS of order 3"},
    {Code::SC3113, "FANUC controls take orders up to 4; softcnc runs this one of 5 all the same"},
    {Code::SC3114, "Q, the way of chopping the curve, has no effect: no curve is chopped"},
    {Code::SC3115, "G05 has no effect: softcnc looks ahead over the whole program anyway"},
    {Code::SC3116, "G05 as a curve is known to the linuxcnc dialect only"},
    {Code::SC3117, "Z lies across the plane of the curve"},
    {Code::SC3117, "J lies across the plane of the curve"},
    {Code::SC3118, "G05 without I and J goes on from no G05"},
    {Code::SC3119, "G05 without I and J is FANUC's switch of the look-ahead"},
    {Code::SC3119, "G05.1 without I and J is FANUC's switch of the look-ahead"},
    {Code::SC3120, "a spline goes through 10000 points at most, its start among them"},
    {Code::SC3120, "a curve has 10000 control points at most"},
    {Code::SC3121, "G05.3 ends no curve: G05.2 does not stand before"},
    {Code::SC3122, "the program ends, and the curve has no G05.3"},
    {Code::SC3123, "G06.4 beside G02, which takes D, J, H, L, R or Q too"},
    {Code::SC3124, "D, the tool radius, must be above 0"},
    {Code::SC3124, "J, the pick-feed, must be above 0"},
    {Code::SC3124, "H, the target Rmax, must be above 0"},
    {Code::SC3124, "L, the number of teeth, is a whole number from 1"},
    {Code::SC3124, "R, the radius across the feed, must not be 0: leave it out on a flat surface"},
    {Code::SC3124, "R, a hollow of 5 mm, is too tight for a tool radius of 5 mm"},
    {Code::SC3124, "J, the pick-feed, must be below twice the tool radius of 5 mm"},
    {Code::SC3125, "J, the pick-feed, is missing"},
    {Code::SC3125, "H, the target Rmax in um, is missing"},
    {Code::SC3125, "D, the tool radius, is missing, and no tool is in the spindle"},
    {Code::SC3125, "L, the number of teeth, is missing, and the machine file has none for tool 7"},
    {Code::SC3126,
     "an Rmax of 5 um is out of reach: it must be more than the 6.254 um that this pick-feed and "
     "radius leave however slow the feed"},
    {Code::SC3126,
     "an Rmax of 25 um is out of reach: it must be more than the 25.063 um that this pick-feed, "
     "slope and radius leave however slow the feed"},
    {Code::SC3124, "Q, the largest slope across the feed, is from 0 to below 90 degrees"},
    {Code::SC3124,
     "Q, the slope across the feed, sets passes 12 mm apart: that must be below twice the tool "
     "radius of 5 mm"},
    {Code::SC3128, "a roughness is asked for, and the spindle does not turn: S is not set"},
    {Code::SC3128,
     "a roughness is asked for, and the spindle does not turn: neither M03 nor M04 is in force"},
    {Code::SC3128, "a roughness is asked for, and the spindle does not turn: S is 0"},
    {Code::SC3129,
     "an Rmax of 6.254 um asks for less than 2 um per tooth, where teeth rub; it is not held "
     "there"},
};

/// Codes of the interpreter's own: characters and words, modes and motion, blocks of a NURBS. Those
/// from 2380 on are told where a surface is cut: apps/surface_test.cpp.
bool is_own(Code code) {
  const int number = static_cast<int>(code);
  return number < 2380 || (number >= 3100 && number < 3200);
}

}  // namespace

TEST_CASE("a bad program is told what is wrong with it, where, and nothing else", "[ipr][bad]") {
  for (const auto& file : files()) {
    INFO(file.filename().string());
    CHECK(told_by(file).places == expected_places(expectation(bytes_of(file))));
  }
}

TEST_CASE("every code of the interpreter has a bad program", "[ipr][bad]") {
  std::set<Code> told;
  for (const auto& file : files())
    for (const auto& [code, text] : told_by(file).texts) told.insert(code);
  for (const CodeInfo& row : code_table()) {
    INFO("SC" << static_cast<int>(row.code));
    CHECK((!is_own(row.code) || told.count(row.code) == 1));
  }
}

TEST_CASE("every code that bad programs are told has its text", "[ipr][bad]") {
  std::multimap<Code, std::string> told;
  for (const auto& file : files()) told.merge(told_by(file).texts);
  for (const auto& [code, text] : told) {
    INFO("SC" << static_cast<int>(code) << " " << text);
    CHECK(kTexts.count(code) > 0);
  }
  for (const auto& expected : kTexts) {
    INFO("SC" << static_cast<int>(expected.first) << " " << expected.second);
    const auto [first, last] = told.equal_range(expected.first);
    CHECK(std::find(first, last, std::pair<const Code, std::string>(expected)) != last);
  }
}

}  // namespace softcnc::ipr
