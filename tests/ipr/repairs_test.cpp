// SPDX-License-Identifier: MIT
// Errors that go when one character where an error is told is another follow from it; others do
// not.
#include "ipr/interpreter/repairs.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"
#include "ipr/judge.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

namespace {

Places places_of(const std::vector<Diagnostic>& errors) {
  Interpreted result;
  result.diagnostics = errors;
  return places(result);
}

/// The places of all errors of a text, and of those that do not follow from others.
struct Told {
  Places all, rest;
};

Told told(const std::string& text, Dialect dialect = Dialect::linuxcnc) {
  const Judge judge = [&](const std::string& changed) { return verdict_of(changed, dialect); };
  const auto errors = judge(text).errors;
  const std::vector<bool> follows = follow_from_others(text, errors, judge);
  std::vector<Diagnostic> rest;
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (!follows[i]) rest.push_back(errors[i]);
  return {places_of(errors), places_of(rest)};
}

}  // namespace

TEST_CASE("an error that goes with a character of another line follows from it", "[ipr][repairs]") {
  // G18, of which G81 is no error of its own but where it lacks words.
  const Told plane = told("F100\nG81\nG2 X0 Z10 I0 K5\nG0 X0 Z0\nM30\n");
  CHECK(plane.all.size() > 1);
  CHECK(plane.rest.size() == 1);
  CHECK(plane.rest.front().ends_with("2:1"));
}

TEST_CASE("the line that is mended may stand behind the error", "[ipr][repairs]") {
  const Told jump = told("G0 X1\nGOTO 9\nG0 X2\n9NM30\n", Dialect::fanuc);
  REQUIRE(jump.all.size() == 2);
  REQUIRE(jump.rest.size() == 1);
  CHECK(jump.rest.front().ends_with("4:1"));
}

TEST_CASE("of several errors that one character mends the first is told", "[ipr][repairs]") {
  const Told arc = told("G21 G90\nG003 X1\nM30\n");
  CHECK(arc.all.size() == 2);
  CHECK(arc.rest.size() == 1);
}

TEST_CASE("of a line that stands there twice one error is told", "[ipr][repairs]") {
  const Told twice = told("F9\nG5.2 P1 L3\nG5.2 P1 L3\nX5 Y3 P1\nX2 Y2 P1\nG5.3\nM30\n");
  CHECK(twice.all.size() > 1);
  CHECK(twice.rest.size() == 1);
}

TEST_CASE("mistakes of their own are told one and all", "[ipr][repairs]") {
  for (const std::string text : {"G0 X1.2.3 Y1.2.3\nM30\n", "G0 X--1\nG0 Y1..2\nG7777\nM30\n",
                                 "M10\nG1 X1 F9\nG3 X5 Y5 I1 J0\nM30\n", "G0 X1 ?\nG0 Y#\nM30\n",
                                 "G0 X1 Q\nG2 X9 Y9 I1 J1 F9\nM30\n", "G1 X10\nG2 X20 R4 F9\nM30\n",
                                 "G2 X10 R4 F9\nG0 X0 Y0\nG2 X21 R5\nM30\n"}) {
    const Told mistakes = told(text);
    CAPTURE(text, mistakes.all);
    REQUIRE(mistakes.all.size() > 1);
    CHECK(mistakes.rest == mistakes.all);
  }
}

TEST_CASE("no line is mended so that one with an error is not run", "[ipr][repairs]") {
  const std::string branch = "#1=0\no1 if [#1 LT 1..2]\nG0 X1..2\no1 endif\nM30\n";
  CHECK(told(branch).rest == told(branch).all);
  // M10 might be M30, behind which nothing is wrong.
  CHECK(told("M10\nG0 X1..2\nM30\n").rest == Places{"SC2001 1:1", "SC1004 2:5"});
}

TEST_CASE("no line is mended with what another one lacks", "[ipr][repairs]") {
  for (const std::string wrong : {"M6", "G45", "M66", "G0 X1 X2"}) {
    const Told feed = told("G21 G90\n" + wrong + "\nG1 X10\nM2\n");
    CAPTURE(wrong);
    CHECK(feed.all.size() == 2);
    CHECK(feed.rest == feed.all);
  }
  CHECK(told("G43 H1 Z#<far>\n#<_z> = 1\no1 endif\nM2\n").rest.size() == 3);
}

TEST_CASE("no line is mended so that lines never run are not read", "[ipr][repairs]") {
  // M21 might be M2, behind which nothing is looked at.
  const Told branch = told("M21\no1 if [0]\nG0 X1O\no1 endif\nM2\n");
  CHECK(branch.rest == Places{"SC2001 1:1", "SC1002 3:6"});
  const std::string program = "%\nO1000\nG21 G90\nM6\nM98 P2000\nM30\nO2000\nG0 Z50.\nM9\n%\n";
  CHECK(told(program, Dialect::fanuc).rest == told(program, Dialect::fanuc).all);
}

TEST_CASE("no line is mended so that where another one leads is not known", "[ipr][repairs]") {
  // G81 might be G91, behind which a lost Y is never known again.
  const Told arc = told("F9\nG81 X10 Y10 Z-5\nG0 X20 Y#<saef>\nG0 X0 Y0\nG3 X5 Y5 I1 J0\nM2\n");
  CHECK(arc.all.size() == 3);
  CHECK(arc.rest == arc.all);
}

TEST_CASE("what the judge does not tell does not follow", "[ipr][repairs]") {
  const std::string text = "F100\nG81\nG2 X0 Z10 I0 K5\nM30\n";
  const Judge judge = [](const std::string& changed) {
    return verdict_of(changed, Dialect::linuxcnc);
  };
  auto errors = judge(text).errors;
  errors.push_back(errors.back());
  errors.back().code = Code::SC4001;
  CHECK(!follow_from_others(text, errors, judge).back());
}

TEST_CASE("a judge that has had enough is asked no more", "[ipr][repairs]") {
  int asked = 0;
  const Judge judge = [&](const std::string& changed) {
    Verdict verdict = verdict_of(changed, Dialect::linuxcnc);
    verdict.work = ++asked * std::int64_t{10'000'000};
    return verdict;
  };
  const std::string text = "F100\nG81\nG2 X0 Z10 I0 K5\nM30\n";
  follow_from_others(text, verdict_of(text, Dialect::linuxcnc).errors, judge);
  CHECK(asked == 2);
}

TEST_CASE("repairs of long lines, endless loops and no text end", "[ipr][repairs]") {
  CHECK(told("G0 X1..2 (" + std::string(5000, 'x') + ")\nG0 X2..3\nM30\n").rest.size() == 2);
  const Told loop = told("#1=0\no1 while [#1 LT 1]\n#1=[#1-1..2]\no1 endwhile\nG0 X2..3\nM30\n");
  CHECK(loop.rest == loop.all);
  CHECK(told("").rest.empty());
}
