// SPDX-License-Identifier: MIT
// Tool length offsets, against LinuxCNC's rs274.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

const std::string kTools = "G10 L1 P1 Z20\nG10 L1 P2 X1 Y2 Z15.5\n";

AxisVector place_with_tools(const std::string& program, InterpreterOptions options = {}) {
  const bool fanuc = options.dialect == Dialect::fanuc;
  return last_place((fanuc ? "" : kTools) + program + "M30\n", options);
}

}  // namespace

TEST_CASE("G43 counts the length of H, or of the tool in the spindle", "[ipr][tool_length]") {
  CHECK(place_with_tools("G43 H1\nG00 Z5\n").z() == 25);
  CHECK(place_with_tools("T1 M06\nG43\nG00 Z5\n").z() == 25);
  CHECK(place_with_tools("T1\nG43\nG00 Z5\n").z() == 5);
  CHECK(place_with_tools("T1 M06\nT2\nG43\nG00 Z5\n").z() == 25);
  CHECK(place_with_tools("M61 Q1\nG43\nG00 Z5\n").z() == 25);
  CHECK(place_with_tools("G43 H1\nG43 H0\nG00 Z5\n").z() == 5);
  CHECK(place_with_tools("G43 H1\nT2 M06\nG00 Z5\n").z() == 25);
}

TEST_CASE("G43 beside a move counts for it", "[ipr][tool_length]") {
  CHECK(place_with_tools("G43 H2 G00 X5 Z5\n") == AxisVector(6, 0, 20.5));
  CHECK(place_with_tools("G00 X1\nG43 H1 Z5\n") == AxisVector(1, 0, 25));
}

TEST_CASE("G43.1 gives the length, G43.2 adds one, G49 takes all away", "[ipr][tool_length]") {
  CHECK(place_with_tools("G43.1 Z7\nG00 Z1\n").z() == 8);
  CHECK(place_with_tools("G20 G43.1 Z1\nG00 Z1\n").z() == 50.8);
  CHECK(place_with_tools("G43 H1\nG43.1 X1\nG00 X0 Z1\n") == AxisVector(1, 0, 21));
  CHECK(place_with_tools("G43 H1\nG43.2 H2\nG00 X1 Z5\n") == AxisVector(2, 0, 40.5));
  CHECK(place_with_tools("G43 H1\nG49\nG00 Z1\n").z() == 1);
}

TEST_CASE("a length that G10 changes counts from the next G43 on", "[ipr][tool_length]") {
  CHECK(place_with_tools("T1 M06\nG43\nG10 L1 P1 Z3\nG00 Z1\n").z() == 21);
  CHECK(place_with_tools("T1 M06\nG43\nG10 L1 P1 Z3\nG43\nG00 Z1\n").z() == 4);
}

TEST_CASE("without a tool table every length is 0", "[ipr][tool_length]") {
  CHECK(last_place("T5 M06\nG43 H5 G00 Z5\nM30\n").z() == 5);
}

TEST_CASE("a tool that only the machine file knows has no length", "[ipr][tool_length]") {
  Machine machine;
  machine.tools[4].radius = 3;
  CHECK(last_place("T4 M06\nG43\nG00 Z5\nM30\n", {}, machine).z() == 5);
  CHECK(places(interpret("T5 M06\nM30\n", machine)) == Places{"SC2112 1:1"});
  CHECK(places(interpret("T5 M06\nM30\n", machine, kFanuc)).empty());
}

TEST_CASE("in the fanuc dialect wear adds, and H is modal", "[ipr][tool_length][fanuc]") {
  const std::string set = "G10 L10 P3 R50.\nG10 L11 P3 R-0.25\n";
  CHECK(place_with_tools(set + "G43 H3\nG00 Z1.\n", kFanuc).z() == 50.75);
  CHECK(place_with_tools(set + "G43 H3 G00 Z1.\nG43 H3\nG10 L10 P3 R10.\nG43\nZ2.\n", kFanuc).z() ==
        11.75);
  CHECK(place_with_tools(set + "G43 H9 G00 Z1.\n", kFanuc).z() == 1);
}

TEST_CASE("in the fanuc dialect H counts by itself too", "[ipr][tool_length][fanuc]") {
  const std::string set = "G10 L10 P3 R50\nG10 L10 P4 R7\n";
  CHECK(place_with_tools(set + "G43 H3\nG00 Z1 H4\n", kFanuc).z() == 8);
  CHECK(place_with_tools(set + "G43 H3\nH4\nG00 Z1\n", kFanuc).z() == 8);
  CHECK(place_with_tools(set + "G00 Z1 H4\nG43\nZ2\n", kFanuc).z() == 9);
  CHECK(place_with_tools(set + "H4\nG00 Z1\n", kFanuc).z() == 1);
  CHECK(place_with_tools(set + "G43 H3\nG49\nH4\nG00 Z1\n", kFanuc).z() == 1);
  CHECK(places(interpret("G00 X1 H4\nM30\n")) == Places{"SC2004 1:8"});
  CHECK(places(interpret("H1.5\nM30\n", {}, kFanuc)) == Places{"SC2007 1:1"});
  CHECK(places(interpret("F9 G6.1 X1\nX2 Y1 H4\nX3\nM30\n", {}, kFanuc)) == Places{"SC2004 2:7"});
}

}  // namespace softcnc::ipr
