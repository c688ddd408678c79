// SPDX-License-Identifier: MIT
// What the haas dialect keeps by other numbers and in other units than fanuc: tool offsets, general
// variables, the shift of G52; and where its G53 leads.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

Machine with(CutterOffset meaning) {
  Machine machine;
  machine.program.cutter_offsets = meaning;
  return machine;
}

const Machine kDiameters = with(CutterOffset::diameter);

AxisVector haas_place(const std::string& text, const Machine& machine = kDiameters) {
  return last_place(text + "\nM30\n", kHaas, machine);
}

ToolOffset tool_after(const std::string& text, const Machine& machine = kDiameters) {
  return interpret(text + "\nM30\n", machine, kHaas).state.tools.at(3);
}

}  // namespace

TEST_CASE("Haas' numbers of lengths and their wear", "[ipr][variables][haas]") {
  CHECK(haas_place("G10 L10 P1 R50.\n#2201=0\nG43 H1 G00 Z10.") == AxisVector(0, 0, 60));
  CHECK(haas_place("#2003=50.\n#2203=-1.\nG43 H3 G00 Z10.\nX#5083 Y#2203") ==
        AxisVector(49, -1, 59));
  CHECK(haas_place("G10 L10 P200 R5.\nG10 L11 P200 R2.\nG00 X#2200 Y#2400") == AxisVector(5, 2, 0));
  CHECK(haas_place("G20\n#2001=2.\nG21\nG00 X#2001") == AxisVector(50.8, 0, 0));
}

TEST_CASE("Haas' offsets D are diameters", "[ipr][variables][haas]") {
  CHECK(tool_after("G10 L12 P3 R8.\nG10 L13 P3 R-0.2").radius == 4);
  CHECK(tool_after("G10 L12 P3 R8.\nG10 L13 P3 R-0.2").radius_wear == -0.1);
  CHECK(tool_after("G20 G10 L12 P3 R1.").radius == 12.7);
  CHECK(tool_after("G10 L12 P3 R8.\nG91 G10 L12 P3 R1.\nG90").radius == 4.5);
  CHECK(tool_after("#2403=8.\n#2603=-0.2").radius == 4);
  CHECK(tool_after("#2403=8.\n#2603=-0.2").radius_wear == -0.1);
  CHECK(tool_after("G20\n#2403=1.").radius == 12.7);
  CHECK(tool_after("#2400=7.\n#2403=1.\n#2601=2.").length_wear == 0);
  CHECK(haas_place("G10 L12 P3 R8.\n#2603=#2403/2\nG00 X#2403 Y#2603") == AxisVector(8, 4, 0));
  CHECK(haas_place("G10 L12 P5 R4.\nG41 D5 G01 X10. Y0 F100.\nY20.\nG40 X30.\nX31.") ==
        AxisVector(31, 20, 0));
  const auto moves = moves_of("G10 L12 P5 R4.\nG41 D5 G01 X10. Y0 F100.\nY20.\nG40 X30.\nM30\n",
                              kDiameters, kHaas);
  CHECK(end(moves.at(0).path) == AxisVector(8, 0, 0));
  CHECK(end(moves_of("G10 L12 P3 R4.\nG13 D3 I12. Z-1. F100.\nM30\n", kDiameters, kHaas)
                .at(1)
                .path) == AxisVector(10, 0, -1));
}

TEST_CASE("by setting 40 Haas' offsets D are radii", "[ipr][variables][haas]") {
  const Machine radii = with(CutterOffset::radius);
  const ToolOffset tool = tool_after("G10 L12 P3 R8.\n#2603=-0.2", radii);
  CHECK(tool.radius == 8);
  CHECK(tool.radius_wear == -0.2);
  CHECK(haas_place("G10 L12 P3 R8.\nG00 X#2403", radii) == AxisVector(8, 0, 0));
  CHECK(interpret("G10 L12 P3 R8.\nM30\n", kDiameters, kFanuc).state.tools.at(3).radius == 8);
}

TEST_CASE("that diameters are assumed is reported once", "[ipr][variables][haas]") {
  const Interpreted result =
      interpret("G10 L10 P1 R5.\nG10 L12 P1 R8.\nG10 L13 P1 R1.\n#2401=8.\nM30\n", {}, kHaas);
  REQUIRE(places(result) == Places{"SC2386 2:12"});
  CHECK(result.diagnostics[0].message ==
        "R of G10 L12 counts the diameter of a tool, as Haas' setting 40 has it unless it says "
        "radius");
  CHECK(haas_reported("#2001=5.\n#2201=1.\n#1=#2402\n#2401=8.\nG10 L12 P1 R8.") ==
        Places{"SC2386 3:1"});
  CHECK(haas_reported("G00 X1.\n#2602=1.") == Places{"SC2386 2:1"});
  const Interpreted moved = interpret("G00 X1.\nG00 X#2401\nG00 X5.\nM30\n", {}, kHaas);
  CHECK(places(moved) == Places{"SC2386 2:6"});
  CHECK(moved.blocks.size() == 4);  // the line of the warning moves, too
  CHECK(haas_reported("#2401=8.\nG10 L12 P1 R8.\nG10 L13 P1 R8.", kDiameters).empty());
  CHECK(haas_reported("#2401=8.\nG10 L12 P1 R8.", with(CutterOffset::radius)).empty());
  CHECK(places(interpret("G10 L12 P1 R8.\nM30\n", {}, kFanuc)).empty());
}

TEST_CASE("Haas' general variables have two numbers where older controls have one",
          "[ipr][variables][haas]") {
  CHECK(haas_place("G10 L10 P1 R50.\n#10001=7\nG43 H1 G00 Z10.") == AxisVector(0, 0, 60));
  CHECK(haas_place("#10100=7.\n#10999=8.\n#550=9.\nG00 X#100 Y#999 Z#10550") ==
        AxisVector(7, 8, 9));
  CHECK(haas_place("#10001=1.\n#1=4.\n#10200=2.\nG00 X#10001 Y#10200 Z#1") == AxisVector(1, 2, 4));
  CHECK(haas_place("G00 X1.\nX5. Y#10000") == AxisVector(5, 0, 0));  // vacant
  CHECK(haas_reported("#11001=1") == Places{"SC1025 1:1"});
  CHECK(haas_reported("#200=1") == Places{"SC1025 1:1"});
  const MachineState state =
      interpret("#100=1\n#10101=2\n#10001=3\n#10500=4\n#1=5\nM30\n", {}, kHaas).state;
  CHECK(state.parameters == std::map<int, double>{{100, 1}, {101, 2}, {500, 4}, {10001, 3}});
}

TEST_CASE("a lost assignment leaves Haas' variables unknown", "[ipr][variables][haas]") {
  CHECK(haas_reported("M98 P7\nG00 X[1/#100] Y[1/#10001]\n#100=0\nX[1/#100]") ==
        Places{"SC2301 1:1", "SC1021 4:5"});
}

TEST_CASE("Haas' #5201 to #5203 and G10 L2 P0 are the shift of G52", "[ipr][variables][haas]") {
  CHECK(haas_place("G10 L2 P0 X5.\nG00 X1.") == AxisVector(6, 0, 0));
  CHECK(haas_place("G52 X5. Y2.\nG10 L2 P0 X1.\nG00 X1. Y1.") == AxisVector(2, 3, 0));
  CHECK(haas_place("G52 X5.\nG91 G10 L2 P0 X1.\nG90 G00 X1.") == AxisVector(7, 0, 0));
  CHECK(haas_place("G52 X5.\n#5202=3.\nG00 X#5201 Y1.") == AxisVector(10, 4, 0));
  CHECK(haas_place("G10 L2 P0 X5.\nG52 X0\nG00 X1.") == AxisVector(1, 0, 0));
  CHECK(haas_reported("G10 L2 P0 X5. R1.") == Places{"SC2004 1:15"});
  CHECK(interpret("G10 L2 P0 X5.\nM30\n", {}, kHaas).state.work[0].origin == AxisVector(0, 0, 0));
  CHECK(places(interpret("G10 L2 P0 X5.\nM30\n", {}, kFanuc)) == Places{"SC2007 1:8"});
}

TEST_CASE("Haas' G53 leaves G91, scales and rotations for its line", "[ipr][haas][G53]") {
  CHECK(haas_place("G00 X1. Z5.\nG91 G01 X2. F100.\nG00 G53 G49 Z0\nG53 Y4.\nX1.") ==
        AxisVector(4, 4, 0));
  CHECK(haas_place("G10 L2 P1 X10. Z7.\nG00 X1. Z5.\nG51 X0 Y0 P2.\nG01 X2. F100.\nG00 G53 Z3.") ==
        AxisVector(14, 0, 3));
  const std::string turned = "G10 L2 P1 X10.\nG00 X1. Y0\nG68 X0 Y0 R90.\nG00 X3. Y0\nG53 X7.";
  CHECK(near(haas_place(turned), {7, 3, 0}));
  CHECK(near(haas_place(turned + "\nX2. Y0"), {10, 2, 0}));
  CHECK(near(haas_place("G00 X4.\nG51.1 X0\nX5.\nG53 Y2.\nG91 X1."), {-6, 2, 0}));
  CHECK(near(haas_place("G00 X4.\nG51 X0 Y0 Z0 P0.5\nG53 X3.\nG91 X1."), {3.5, 0, 0}));
}

TEST_CASE("Haas' G53 without axes moves nothing", "[ipr][haas][G53]") {
  CHECK(moves_of("G00 X1.\nG53 G49 M05\nG53\nM30\n", {}, kHaas).size() == 1);
  CHECK(moves_of("G53\nG91 G53 G00\nM30\n", {}, kHaas).empty());
  CHECK(haas_reported("G02 X2. I1. F9.\nG53 X1.") == Places{"SC2111 2:1"});
  CHECK(places(interpret("G00 X1\nG53\nG91 G53 X1\nM30\n", {}, kFanuc)) ==
        Places{"SC2111 2:1", "SC2111 3:5"});
}

}  // namespace softcnc::ipr
