// SPDX-License-Identifier: MIT
// codes: both tables, from outside.
#include <catch2/catch.hpp>
#include <sstream>

#include "apps/shell.hpp"
#include "ipr/codes/gcode.hpp"
#include "motion/core/diagnostic.hpp"

using namespace softcnc;
using namespace softcnc::app::test;

TEST_CASE("codes lists every code of programs with its words and what it does", "[apps][codes]") {
  const Ended ended = call("codes");
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  std::istringstream lines(ended.out);
  for (const ipr::GCode& code : ipr::gcode_table()) {
    std::string line;
    std::getline(lines, line);
    CHECK(line.starts_with(ipr::code_name(code) + ' '));
    CHECK(line.ends_with(code.says));
  }
  CHECK(lines.peek() == std::istringstream::traits_type::eof());
}

TEST_CASE("codes says what one code means, however it is written", "[apps][codes]") {
  const std::string g02 = call("codes G02").out;
  CHECK(g02.starts_with("G02     X Y Z I J K"));
  CHECK(std::count(g02.begin(), g02.end(), '\n') == 3);
  CHECK(call("codes g2").out == g02);
  CHECK(call("codes G6.2").out == call("codes G06.2").out);
  CHECK(call("codes SC2103").out ==
        "SC2103  error: arc ends off its circle\n"
        "        give a centre from which start and end are equally far, or use R\n");
  CHECK(call("codes sc2103 G02").out == call("codes SC2103").out + g02);
}

TEST_CASE("codes lists words, group and order of a code", "[apps][codes]") {
  CHECK(call("codes G41").out ==
        "G41     D L                 The tool runs left of the contour, by its radius; D: that of "
        "another tool (fanuc: without D the last).\n"
        "        group   cutter compensation (G40 G41 G41.1 G42 G42.1)\n"
        "        order   15 of 26: cutter compensation\n");
  CHECK(
      call("codes G4").out.find("        fanuc   takes X U too\n        group   none: for its ") !=
      std::string::npos);
  CHECK(
      call("codes G83").out.find("        fanuc   takes P too\n        haas    takes I J too\n") !=
      std::string::npos);
  for (const ipr::GCode& code : ipr::gcode_table()) {
    const std::string text = call("codes " + ipr::code_name(code)).out;
    CAPTURE(text);
    CHECK(text.starts_with(ipr::code_name(code) + ' '));
    CHECK(text.find("group   " + std::string(ipr::group_name(code.group)) + " (") !=
          std::string::npos);
    CHECK(text.find(" of 26: ") != std::string::npos);
  }
}

TEST_CASE("help names the codes, and codes --help lists them", "[apps][codes]") {
  CHECK(call("--help").out.find("'softcnc codes G41' explains one of them") != std::string::npos);
  const Ended help = call("codes --help");
  CHECK(help.status == 0);
  CHECK(help.out.find(call("codes").out) != std::string::npos);
}

TEST_CASE("codes lists all that begin as is said", "[apps][codes]") {
  const std::string all = call("codes SC").out;
  CHECK(static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')) == code_table().size());
  CHECK(call("codes SC21").out.starts_with("SC2101  error    coordinates without a motion code\n"));
  CHECK(call("codes M").out.find("M30") != std::string::npos);
  CHECK(call("codes M").out.find("G00") == std::string::npos);
}

TEST_CASE("codes finds codes by words", "[apps][codes]") {
  const std::string found = call("codes tool LENGTH").out;
  CHECK(found.starts_with("G43 "));
  CHECK(found.find("\nG49 ") != std::string::npos);
  CHECK(found.find("\nSC2124 ") != std::string::npos);
  CHECK(found.find("G40") == std::string::npos);
}

TEST_CASE("codes names what it does not know, exit status 2", "[apps][codes]") {
  const Ended ended = call("codes SC9999 G02");
  CHECK(ended.status == 2);
  CHECK(ended.err == "softcnc: no code is called 'SC9999', and none is about 'SC9999'\n");
  CHECK(ended.out.starts_with("G02 "));
}
