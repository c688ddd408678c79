// SPDX-License-Identifier: MIT
// Errors that go when another line is mended by one character follow from it; others do not.
#include <catch2/catch.hpp>

#include <algorithm>

#include "ipr/interpret.hpp"
#include "ipr/repairs.hpp"

using namespace softcnc;
using namespace softcnc::ipr;

namespace {

std::vector<Diagnostic> errors_of(const std::string& text) {
  std::vector<Diagnostic> errors = interpret(text).diagnostics;
  std::erase_if(errors, [](const Diagnostic& d) { return d.severity() != Severity::error; });
  return errors;
}

/// The places of the errors of a text that do not follow from others.
Places told(const std::string& text) {
  Interpreted result;
  const std::vector<Diagnostic> errors = errors_of(text);
  const std::vector<bool> follows = follow_from_others(text, errors, Machine{}, {});
  for (std::size_t i = 0; i < errors.size(); ++i)
    if (!follows[i]) result.diagnostics.push_back(errors[i]);
  return places(result);
}

const std::string kArcs =
    "G21 G90 F100\nG2 X0 Z10 I0 K5\nG0 X0 Z0\nG2 X0 Z20 I0 K10\nG0 X0 Z0\nM30\n";

}  // namespace

TEST_CASE("an error that goes with a character of another line follows from it", "[ipr][repairs]") {
  const std::string plane = "G188\n" + kArcs;  // G18
  REQUIRE(errors_of(plane).size() > 1);
  CHECK(told(plane) == Places{"SC2001 1:1"});
}

TEST_CASE("the line that is mended may stand behind the error", "[ipr][repairs]") {
  InterpreterOptions fanuc;
  fanuc.dialect = Dialect::fanuc;
  const std::string text = "G0 X1\nGOTO 9\nG0 X2\n9NM30\n";
  std::vector<Diagnostic> errors = interpret(text, Machine{}, fanuc).diagnostics;
  std::erase_if(errors, [](const Diagnostic& d) { return d.severity() != Severity::error; });
  REQUIRE(errors.size() == 2);
  const auto follows = follow_from_others(text, errors, Machine{}, fanuc);
  REQUIRE(follows.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(follows[i] == (errors[i].pos.line == 2));
}

TEST_CASE("of several errors of a line that one character mends the first is told",
          "[ipr][repairs]") {
  const std::string text = "G21 G90\nG05X3\nM30\n";
  REQUIRE(errors_of(text).size() == 2);
  CHECK(told(text).size() == 1);
}

TEST_CASE("mistakes of their own are told one and all", "[ipr][repairs]") {
  for (const std::string text : {"G0 X1.2.3 Y1.2.3\nM30\n", "G0 X--1\nG0 Y1..2\nG7777\nM30\n",
                                 "M10\nG1 X1 F9\nG3 X5 Y5 I1 J0\nM30\n", "G0 X1 ?\nG0 Y#\nM30\n",
                                 "G0 X1 Q\nG2 X9 Y9 I1 J1 F9\nM30\n"}) {
    CAPTURE(text);
    const auto errors = errors_of(text);
    REQUIRE(errors.size() > 1);
    CHECK(told(text).size() == errors.size());
  }
}

TEST_CASE("no line is mended so that the program ends there", "[ipr][repairs]") {
  // M10 might be M30, behind which nothing is wrong.
  CHECK(told("M10\nG0 X1..2\nM30\n") == Places{"SC2001 1:1", "SC1004 2:5"});
}

TEST_CASE("what reading alone does not tell does not follow", "[ipr][repairs]") {
  const std::string text = "G188\n" + kArcs;
  std::vector<Diagnostic> errors = errors_of(text);
  Diagnostic beyond = errors.back();
  beyond.code = Code::SC4001;
  errors.push_back(beyond);
  CHECK(!follow_from_others(text, errors, Machine{}, {}).back());
}

TEST_CASE("repairs of long lines, endless loops and no text end", "[ipr][repairs]") {
  CHECK(told("G0 X1..2 (" + std::string(5000, 'x') + ")\nG0 X2..3\nM30\n").size() == 2);
  CHECK(told("#1=0\no1 while [#1 LT 1]\n#1=[#1-1..2]\no1 endwhile\nG0 X2..3\nM30\n").size() == 2);
  CHECK(follow_from_others("", {}, Machine{}, {}).empty());
}
