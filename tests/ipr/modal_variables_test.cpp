// SPDX-License-Identifier: MIT
// What programs read of position, offsets and modes.
#include "ipr/state/modal_variables.hpp"

#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"
#include "motion/geometry/line.hpp"

namespace softcnc::ipr {
namespace {

/// Where the last move of a program ends, mm.
AxisVector end_of(const std::string& text, InterpreterOptions options = {}) {
  AxisVector end = AxisVector::Zero();
  for (const Block& block : blocks_of(text + "\nM30\n", {}, options))
    if (const auto* move = std::get_if<Move>(&block.what))
      end = std::visit([](const auto& path) { return path.position(path.length()); }, move->path);
  return end;
}

}  // namespace

TEST_CASE("the position is read in the units of the program", "[ipr][variables]") {
  CHECK(end_of("G0 X10 Y20 Z5\nX[#5420+1] Y#<_y> Z-#5422").isApprox(AxisVector(11, 20, -5)));
  CHECK(end_of("G20 G0 X1 Y2\nX[#5420+1] Y#<_x>").isApprox(AxisVector(50.8, 25.4, 0)));
  CHECK(end_of("G0 X10 Y20\nX[#5001+1] Y#5041 Z#5022", kFanuc).isApprox(AxisVector(11, 10, 20)));
}

TEST_CASE("modes are read by name and by number", "[ipr][variables]") {
  CHECK(end_of("G1 F300 X1\nX#<_feed> Y#<_motion_mode> Z#<_plane>")
            .isApprox(AxisVector(300, 10, 170)));
  CHECK(end_of("G20 G18 G91 S500 M3\nG21 G90 G0 X#<_rpm> Y#<_plane> Z#<_spindle_on>")
            .isApprox(AxisVector(500, 180, 1)));
  CHECK(end_of("G0 X#<_absolute> Y[2 + #<_incremental>] Z#<_coord_system>")
            .isApprox(AxisVector(1, 2, 540)));
  CHECK(end_of("G18\nG0 X#4002 Y#4003 Z#4014", kFanuc).isApprox(AxisVector(18, 90, 54)));
}

// As rs274 of LinuxCNC 2.9 gives them before the first motion, metric_machine apart: its machine is
// in inches.
TEST_CASE("the names of LinuxCNC are there from the start and only to be read",
          "[ipr][variables]") {
  CHECK(end_of("G0 X[#<_vmajor>*10] Y#<_lathe_radius_mode> Z#<_feed_hold>")
            .isApprox(AxisVector(29, 1, 1)));
  CHECK(end_of("G0 X#<_speed_override> Y[#<_a>+#<_abs_w>+1] Z#<_metric_machine>")
            .isApprox(AxisVector(1, 1, 1)));
  CHECK(end_of("T7\nG0 X#<_selected_tool> Y#<_line> Z[#<_task>+#<_tool_offset>]")
            .isApprox(AxisVector(7, 2, 0)));
  CHECK(places(interpret("#<_b>=1\n#<_line>=1\nM30\n")) == Places{"SC1026 1:1", "SC1026 2:1"});
}

TEST_CASE("units, the way of the spindle and each work system are read", "[ipr][variables]") {
  CHECK(end_of("G0 X#<_imperial> Y#<_metric>") == AxisVector(0, 1, 0));
  CHECK(end_of("G20\n#1=#<_imperial>\nG21 G0 X#1") == AxisVector(1, 0, 0));
  CHECK(end_of("M4 S1\nG0 X[2 + #<_spindle_cw>]\nM3\nY#<_spindle_cw>") == AxisVector(2, 1, 0));
  CHECK(end_of("G59.2\nG0 X#<_coord_system>").x() == 592);
  CHECK(end_of("G92 X5\nG0 X7 Y1\nY#<_abs_x>").isApprox(AxisVector(2, 2, 0)));
  CHECK(end_of("G1 F9 X2\nX#4001 Y#4006", kFanuc) == AxisVector(1, 21, 0));
  CHECK(end_of("G20\n#1=#4006\nG21 G0 X#1", kFanuc) == AxisVector(20, 0, 0));
}

// As rs274 of LinuxCNC 2.9 gives them.
TEST_CASE("modes of feed, compensation, cycles and coolant are read", "[ipr][variables]") {
  const std::string feeds = "G0 X#<_inverse_time> Y#<_units_per_minute> Z#<_units_per_rev>";
  CHECK(end_of(feeds) == AxisVector(0, 1, 0));
  CHECK(end_of("G93\n" + feeds) == AxisVector(1, 0, 0));
  CHECK(end_of("G95\n" + feeds) == AxisVector(0, 0, 1));
  CHECK(end_of("G93 F7\nG0 X#<_feed>\nG95 F.25\nY#<_feed>") == AxisVector(7, 0.25, 0));
  const std::string comp = "G0 X#<_ccomp>\n";
  CHECK(end_of(comp).x() == 400);
  CHECK(end_of("G41.1 D2\n#1=#<_ccomp>\nG40 G0 X#1").x() == 410);
  CHECK(end_of("G42.1 D2\n#1=#<_ccomp>\nG40 G0 X#1").x() == 420);
  CHECK(end_of("G42.1 D2\nG40\n" + comp).x() == 400);
  CHECK(end_of("M8\nG0 X#<_flood> Y#<_mist>\nM7\nZ#<_mist>\nM9\nX[5+#<_flood>+#<_mist>]") ==
        AxisVector(5, 0, 1));
  CHECK(end_of("G0 X#<_retract_r_plane> Y#<_retract_old_z>\nG98\nZ#<_retract_old_z>") ==
        AxisVector(1, 0, 1));
  CHECK(end_of("G0 X#<_spindle_rpm_mode> Y#<_spindle_css_mode> Z#<_ijk_absolute_mode>\n"
               "G90.1\nZ[2+#<_ijk_absolute_mode>]") == AxisVector(1, 0, 3));
  CHECK(end_of("M49\nG0 X[1+#<_feed_override>] Y[1+#<_speed_override>]\n"
               "M50 P1\nX[2+#<_feed_override>] Y[2+#<_speed_override>]\nM51 P1\n"
               "Z[2+#<_speed_override>]") == AxisVector(3, 2, 3));
}

TEST_CASE("the tool in the spindle is read", "[ipr][variables]") {
  const std::string tool = "G10 L1 P2 R4 Z7\n";
  CHECK(end_of(tool + "G0 X#5400 Y#<_current_tool> Z#<_selected_pocket>") == AxisVector(0, 0, -1));
  CHECK(end_of(tool + "G10 L1 P3 R1\nT2 M6\nT3\nG0 X#5400 Y#<_current_tool> Z#<_selected_tool>") ==
        AxisVector(2, 2, 3));
  CHECK(end_of(tool + "T2 M6\nG0 X#5410 Y[1+#5411+#5412+#5413] Z#<_selected_pocket>") ==
        AxisVector(8, 1, 2));
  CHECK(end_of(tool + "T2 M6\nG43\nG53 G0 Z0\nX#5403 Y[1+#5404+#5409]") == AxisVector(7, 1, 0));
  CHECK(end_of(tool + "G10 L1 P3 X5 Y6\nT2 M6\nG0 Z#5403\nT3 M6\nG43 H2\nG53 G0 Z1\nX#5401 "
                      "Y#5402") == AxisVector(5, 6, 1));
  CHECK(end_of(tool + "T2 M61 Q2\nG43.1 Z3\nG0 X#5403 Y0\nG49\nG10 L1 P2 Z8\nG0 Y#5403 Z0") ==
        AxisVector(7, 8, 0));
  CHECK(end_of(tool + "G0 X[1+#5401] Y[2+#5403]") == AxisVector(1, 2, 0));
  CHECK(end_of(tool + "T2 M6\nG20 G0 X[#5403/25.4]").isApprox(AxisVector(7, 0, 0)));
  CHECK(end_of("T2 M61 Q2\nG0 X[1+#5410] Y#<_current_pocket>") == AxisVector(1, 2, 0));
}

TEST_CASE("the rotation of every work system is a variable", "[ipr][variables]") {
  CHECK(end_of("G10 L2 P1 R30\nG10 L2 P9 R-7\nG55 G0 X#5230 Y#5390 Z[1+#5250]")
            .isApprox(AxisVector(30, -7, 1)));
  CHECK(end_of("#5250=90\nG55 G0 X1").isApprox(AxisVector(0, 1, 0)));
  CHECK(places(interpret("#5230=1\nM30\n", {}, kFanuc)) == Places{"SC1025 1:1"});
}

TEST_CASE("FANUC's numbers of tool offsets are those of G10 L10 to L13",
          "[ipr][variables][fanuc]") {
  const std::string set = "G10 L10 P3 R1\nG10 L11 P3 R2\nG10 L12 P3 R3\nG10 L13 P3 R4\n";
  CHECK(end_of(set + "G0 X#2203 Y#2003\nZ#11003", kFanuc) == AxisVector(1, 2, 1));
  CHECK(end_of(set + "G0 X#13003 Y#12003\nZ#10003", kFanuc) == AxisVector(3, 4, 2));
  CHECK(end_of("#2203=5\n#10003=1\nG43 H3 G0 Z0\nX#5083", kFanuc) == AxisVector(6, 0, 6));
  CHECK(end_of("#13003=5\n#12003=-1\nF100 G1 G42 D3 X20\nX40\n#1=#4007\nG40 X50\nX60 Y0 Z#1",
               kFanuc) == AxisVector(60, 0, 42));
  CHECK(end(moves_of("#13003=5\n#12003=-1\nF100 G1 G42 D3 X20\nG40 X50\nM30\n", {}, kFanuc)[0]
                .path) == AxisVector(20, -4, 0));
  CHECK(end_of("G0 X[1+#2001] Y[1+#5201] Z[1+#2400]", kFanuc) == AxisVector(1, 1, 1));
}

TEST_CASE("FANUC's numbers tell the codes in force", "[ipr][variables][fanuc]") {
  CHECK(end_of("G0 X#4005 Y#4007 Z#4008", kFanuc) == AxisVector(94, 40, 49));
  CHECK(end_of("G95 G43 H2\nG0 X#4005 Y#4111 Z#4008", kFanuc) == AxisVector(95, 2, 43));
  CHECK(end_of("G0 X#4010\nG99\nY#4010", kFanuc) == AxisVector(98, 99, 0));
  CHECK(end_of("D7\nG0 X#4107 Y#4001 Z#4009", kFanuc) == AxisVector(7, 80, 80));
  CHECK(end_of("H2\nG0 X#4008 Y#4111", kFanuc) == AxisVector(49, 2, 0));
  CHECK(end_of("F9 G1 Z9\nG99 G83 X1 Z0 R1 Q1\n#1=#4001\n#2=#4009\nG0 X#1 Y#2", kFanuc) ==
        AxisVector(1, 83, 1));
}

TEST_CASE("offsets can be read and written", "[ipr][variables]") {
  CHECK(end_of("#5161=7\nG0 X#5161 Y#5220 Z#5221").isApprox(AxisVector(7, 1, 0)));
  CHECK(end_of("#5221=5\nG0 X1", kFanuc).isApprox(AxisVector(6, 0, 0)));
}

TEST_CASE("offsets are in mm, on FANUC's controls in the units of the program",
          "[ipr][variables]") {
  CHECK(end_of("G20\n#5221=1 G54\nG0 X0 Y#5221").isApprox(AxisVector(1, 25.4, 0)));
  CHECK(end_of("G20\n#5221=1\nG0 X0 Y#5221", kFanuc).isApprox(AxisVector(25.4, 25.4, 0)));
  CHECK(end_of("#5221=1\nG20\nG0 X0 Y#5221", kFanuc).isApprox(AxisVector(1, 1, 0)));
  CHECK(end_of("G20\n#11001=2\nG43 H1 G0 Z0\nX#5083 Y#2201", kFanuc)
            .isApprox(AxisVector(50.8, 50.8, 50.8)));
  CHECK(end_of("G20\n#13002=2\nG21\nG0 X#13002", kFanuc).isApprox(AxisVector(50.8, 0, 0)));
  CHECK(end_of("G20 G0 X2\nG0 Y#5001 Z#5021", kFanuc).isApprox(AxisVector(50.8, 50.8, 50.8)));
  const auto reported = [](const char* text) { return places(interpret(text, {}, kFanuc)); };
  CHECK(reported("G20\n#5221=39370\nM30\n").empty());
  CHECK(reported("G20\n#5221=39371\nM30\n") == Places{"SC3008 2:1"});
  CHECK(reported("G20 G21\n#5221=1\nG00 X[1/#5221] Y[1/#5083]\nM30\n") == Places{"SC2002 1:5"});
}

TEST_CASE("common variables of FANUC from #500 on outlive the program", "[ipr][variables]") {
  Reader reader = Reader::from_text("#501=[#500+1]\n#500=#0\n#100=3\n#502=#503\nM30\n");
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const Machine machine;
  MachineState before;
  before.parameters[500] = 6;
  Interpreter interpreter(parser, machine, diagnostics, kFanuc, before);
  while (interpreter.next()) continue;
  CHECK(diagnostics.all().empty());
  CHECK(interpreter.state().parameters == std::map<int, double>{{501, 7}});
}

TEST_CASE("what an error has made unknown is not read as if it were known", "[ipr][variables]") {
  CHECK(places(interpret("G0 X1.2.3\nX[1/#5420]\nG1 Y#<_x> F100\nM30\n")) == Places{"SC1004 1:5"});
  CHECK(places(interpret("#5221=[1/0]\nG0 X[1/#5221]\nM30\n")) == Places{"SC1021 1:10"});
  CHECK(places(interpret("F100\n#5221=[1/0]\nG55\nG53 G00 X0\nG02 X9 I1\nM30\n")) ==
        Places{"SC1021 2:10"});
  CHECK(places(interpret("#2201=[1/0]\nG0 Z[1/#2201]\nM30\n", {}, kFanuc)) ==
        Places{"SC1021 1:10"});
  CHECK(places(interpret("#500=[1/0]\nG0 X[1/#500]\nM30\n", {}, kFanuc)) == Places{"SC1021 1:9"});
}

TEST_CASE("the switch of debug comments is on at first", "[ipr][variables]") {
  const auto moves = moves_of("G0 X#5599\n#5599=0\nY#5599\nM30\n");
  CHECK(end(moves.front().path) == AxisVector(1, 0, 0));
  CHECK(moves.size() == 1);
}

TEST_CASE("(ABORT,text) ends the program where it is executed", "[ipr][variables]") {
  const Interpreted aborted = interpret("G0 X1\nG0 X2 (abort, no way )\nG0 X3 Q1\nM2\n");
  CHECK(places(aborted) == Places{"SC1031 2:7"});
  CHECK(aborted.diagnostics.front().message == "the program aborts: no way");
  CHECK(aborted.blocks.size() == 2);
  CHECK(places(interpret("#1=2 (ABORT,)\nM2\n")) == Places{"SC1031 1:6"});
  CHECK(places(interpret("F100\nG6.2 P2 K0 X0\n(ABORT,x)\nM2\n")) == Places{"SC1031 3:1"});
  CHECK(blocks_of("(ABORT,x)\nG0 X1\nM30\n", {}, kFanuc).size() == 2);
}

TEST_CASE("#3000 of FANUC is an alarm, #3006 a stop", "[ipr][variables]") {
  const Interpreted alarm = interpret("#3000=1 (NO TOOL)\nM30\n", {}, kFanuc);
  CHECK(places(alarm) == Places{"SC1031 1:1"});
  CHECK(alarm.diagnostics.front().message == "alarm of the program: NO TOOL");
  const Interpreted guarded = interpret(
      "IF [#1 EQ #0] THEN #3000=1 (A IS MISSING)\n#2=10/#1\nG0 X#2 Q1\nM30\n", {}, kFanuc);
  CHECK(places(guarded) == Places{"SC1031 1:20"});
  CHECK(guarded.blocks.size() == 1);
  const auto blocks = blocks_of("#3006=1 (TURN THE PART)\nM30\n", {}, kFanuc);
  REQUIRE(blocks.size() == 2);
  CHECK(std::get<Action>(blocks[0].what).kind == Action::Kind::stop);
}

TEST_CASE("in a length of FANUC ROUND keeps the least increment", "[ipr][variables]") {
  CHECK(end_of("#1=2.34567\n#2=ROUND[#1]\nG0 XROUND[#1] Y#2", kFanuc)
            .isApprox(AxisVector(2.346, 2, 0)));
  CHECK(end_of("G20\nG0 X[ROUND[1.23456]]", kFanuc).isApprox(AxisVector(25.4 * 1.2346, 0, 0)));
  CHECK(end_of("G0 X[ROUND[1.23456]]").isApprox(AxisVector(1, 0, 0)));
}

}  // namespace softcnc::ipr
