// SPDX-License-Identifier: MIT
// G10. The values are those of LinuxCNC's rs274, brought into mm by hand.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

MachineState state_after(const std::string& program, InterpreterOptions options = {}) {
  const Interpreted result = interpret(program + "M30\n", {}, options);
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL_CHECK(render(diagnostic));
  return result.state;
}

}  // namespace

TEST_CASE("G10 L20 gives the position its coordinates", "[ipr][offset_table]") {
  CHECK(state_after("G10 L20 P2 X5\n").work[1].origin == AxisVector(-5, 0, 0));
  CHECK(state_after("G10 L20 P0 X5 Y6 Z7\n").work[0].origin == AxisVector(-5, -6, -7));
  CHECK(near(state_after("G10 L2 P1 R45\nG00 X10\nG10 L20 P1 X0\n").work[0].origin,
             {7.0710678118654755, 7.0710678118654755, 0}));
}

TEST_CASE("G10 L20 for a turned work system that is not in force", "[ipr][offset_table]") {
  CHECK(near(state_after("G10 L2 P2 R90 X5\nG92 Y3\nG00 X1 Y1\nG10 L20 P2 X0 Y0\n").work[1].origin,
             {-2, -2, 0}));
  CHECK(
      near(state_after("G10 L2 P2 R90 X5\nG00 X1 Y1\nG10 L20 P2 X0\n").work[1].origin, {5, 1, 0}));
}

TEST_CASE("G10 L1 sets a tool, and keeps what it does not name", "[ipr][offset_table]") {
  const ToolOffset tool = state_after("G10 L1 P3 Z20 R2\nG20 G10 L1 P3 X1\n").tools.at(3);
  CHECK(tool.length == AxisVector(25.4, 0, 20));
  CHECK(tool.radius == 2);
}

TEST_CASE("a tool of the machine file keeps its radius", "[ipr][offset_table]") {
  Machine machine;
  machine.tools[4].radius = 3;
  const Interpreted result = interpret("G10 L1 P4 Z20\nM30\n", machine);
  CHECK(result.state.tools.at(4).radius == 3);
  CHECK(result.state.tools.at(4).length.z() == 20);
}

TEST_CASE("G10 L10 measures a tool in the work system in force", "[ipr][offset_table]") {
  CHECK(state_after("T1 M06\nG10 L10 P1 Z5\n").tools.at(1).length.z() == -5);
  CHECK(state_after("G10 L2 P1 Z10\nG00 Z3\nG10 L10 P1 Z0\n").tools.at(1).length.z() == 3);
  const std::string turned =
      "G10 L1 P2 X1 Y2 Z15.5\nG10 L1 P3 Z-3\nG10 L2 P1 R30 X2 Y3\nG92 X1\nT2 M06\nG43\n"
      "G00 X10 Y20\n";
  CHECK(near(state_after(turned + "G10 L10 P3 X4 Y5\n").tools.at(3).length,
             {-1.3038475772974287, 17.990381056758451, -3}));
  CHECK(near(state_after(turned + "G10 L10 P3 X4\n").tools.at(3).length,
             {6.8121778264845041, 3.9330127018884276, -3}));
}

TEST_CASE("G10 L11 measures a tool by G59.3, without the shift", "[ipr][offset_table]") {
  CHECK(
      state_after("G10 L2 P1 Z10\nG10 L2 P9 Z30\nG00 Z3\nG10 L11 P1 Z0\n").tools.at(1).length.z() ==
      -17);
  CHECK(near(state_after("G10 L2 P9 R30 X2 Y3 Z1\nG92 X1 Z7\nG00 X10 Y20\n"
                         "G10 L11 P3 X4 Y2 Z0\n")
                 .tools.at(3)
                 .length,
             {4.5358983848622456, 13.267949192431123, -1}));
}

TEST_CASE("the fanuc dialect keeps geometry and wear of H and D", "[ipr][offset_table][fanuc]") {
  const ToolOffset tool =
      state_after("G10 L10 P1 R50.\nG10 L11 P1 R-0.1\nG10 L12 P1 R5.\nG10 L13 P1 R0.02\n", kFanuc)
          .tools.at(1);
  CHECK(tool.length == AxisVector(0, 0, 50));
  CHECK(tool.length_wear == -0.1);
  CHECK(tool.radius == 5);
  CHECK(tool.radius_wear == 0.02);
  const ToolOffset added =
      state_after("G10 L10 P1 R50\nG91 G10 L10 P1 R1\nG10 L11 P1 R2\nG90\n", kFanuc).tools.at(1);
  CHECK(added.length.z() == 51);
  CHECK(added.length_wear == 2);
}

TEST_CASE("in the fanuc dialect G10 L2 in G91 adds", "[ipr][offset_table][fanuc]") {
  CHECK(state_after("G90 G10 L2 P1 X10\nG91 G10 L2 P1 X1 Y2\nG90\n", kFanuc).work[0].origin ==
        AxisVector(11, 2, 0));
}

}  // namespace softcnc::ipr
