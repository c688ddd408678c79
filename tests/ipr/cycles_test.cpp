// SPDX-License-Identifier: MIT
// Canned cycles and feed modes, against what LinuxCNC's rs274 makes of the same lines.
#include <catch2/catch.hpp>
#include <numbers>

#include "ipr/cycle_stops.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

/// Of cycles, from Z20 on, while the spindle turns.
std::string cycle_stops(const std::string& text, Dialect dialect = Dialect::linuxcnc) {
  return stops_behind("S500 R0,0,20 ", "F100 S500 M03 G00 Z20\n" + text + "\nM02\n", in(dialect));
}

}  // namespace

TEST_CASE("G81 drills, and G98 and G99 say how far out", "[ipr][cycles]") {
  CHECK(cycle_stops("G98 G81 X1 Y2 Z-5 R3\nX4") ==
        "R1,2,20 R1,2,3 F1,2,-5 R1,2,20 R4,2,20 R4,2,3 F4,2,-5 R4,2,20 ");
  CHECK(cycle_stops("G81 X1 Z-5 R1\nX2") == "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 R2,0,1 F2,0,-5 R2,0,1 ");
  CHECK(cycle_stops("G81 X1 Z-5 R1", Dialect::fanuc) == "R1,0,20 R1,0,1 F1,0,-5 R1,0,20 ");
  CHECK(cycle_stops("G00 Z2\nG98 G81 X1 Z-5 R8\nX3\nG99 X4") ==
        "R0,0,2 R0,0,8 R1,0,8 F1,0,-5 R1,0,8 R3,0,8 F3,0,-5 R3,0,8 R4,0,8 F4,0,-5 R4,0,8 ");
}

TEST_CASE("a row of cycles begins anew after another motion", "[ipr][cycles]") {
  CHECK(cycle_stops("G99 G81 X1 Z-5 R1\nG98 X2\nG00 Z10\nG81 X4 Z-5 R1\nG80\nG81 X5 Z-5 R1") ==
        "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 R2,0,1 F2,0,-5 R2,0,20 R2,0,10 "
        "R4,0,10 R4,0,1 F4,0,-5 R4,0,10 R5,0,10 R5,0,1 F5,0,-5 R5,0,10 ");
}

TEST_CASE("words stay in force with their cycle", "[ipr][cycles]") {
  CHECK(cycle_stops("G82 X1 Z-5 R1 P1\nX2\nX3 P2") ==
        "R1,0,20 R1,0,1 F1,0,-5 D1 R1,0,1 R2,0,1 F2,0,-5 D1 R2,0,1 R3,0,1 F3,0,-5 D2 R3,0,1 ");
  CHECK(cycle_stops("G81 X1 Z-5 R1\nG81 X2\nZ-6") ==
        "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 R2,0,1 F2,0,-5 R2,0,1 F2,0,-6 R2,0,1 ");
  CHECK(reported("F1 G81 X1 Z-5 R1\nG82 X6 P1") == Places{"SC2005 2:1"});
}

TEST_CASE("repeats step on in G91, whose R counts from the start and Z from R", "[ipr][cycles]") {
  CHECK(cycle_stops("G91 G99 G81 X1 Y2 Z-5 R-3 L3\nX4") ==
        "R1,2,20 R1,2,17 F1,2,12 R1,2,17 R2,4,17 F2,4,12 R2,4,17 R3,6,17 F3,6,12 R3,6,17 "
        "R7,6,17 F7,6,12 R7,6,17 ");
  CHECK(cycle_stops("G99 G82 X4 Y2 Z-5 R3 P1.5 L2") ==
        "R4,2,20 R4,2,3 F4,2,-5 D1.5 R4,2,3 F4,2,-5 D1.5 R4,2,3 ");
  CHECK(cycle_stops("G91 G99 G81 X1 Z-5 R-3 K2", Dialect::fanuc) ==
        "R1,0,20 R1,0,17 F1,0,12 R1,0,17 R2,0,17 F2,0,12 R2,0,17 ");
  CHECK(cycle_stops("G99 G81 X1 Z-5 R3 K0\nX2", Dialect::fanuc) ==
        "R2,0,20 R2,0,3 F2,0,-5 R2,0,3 ");
}

TEST_CASE("G73 breaks chips, G83 clears them", "[ipr][cycles]") {
  CHECK(cycle_stops("G98 G73 X1 Z-7 R2 Q3") ==
        "R1,0,20 R1,0,2 F1,0,-1 R1,0,-0.746 F1,0,-4 R1,0,-3.746 F1,0,-7 R1,0,20 ");
  CHECK(cycle_stops("G98 G83 X1 Z-7 R2 Q3") ==
        "R1,0,20 R1,0,2 F1,0,-1 R1,0,2 R1,0,-0.746 F1,0,-4 R1,0,2 R1,0,-3.746 F1,0,-7 R1,0,20 ");
  CHECK(cycle_stops("G83 X1 Z-5 R1 Q20") == "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 ");
}

TEST_CASE("bores and taps come out each in its own way", "[ipr][cycles]") {
  CHECK(cycle_stops("G98 G85 X1 Z-7 R2") == "R1,0,20 R1,0,2 F1,0,-7 F1,0,2 R1,0,20 ");
  CHECK(cycle_stops("G98 G86 X1 Z-5 R1 P1") == "R1,0,20 R1,0,1 F1,0,-5 D1 S0 R1,0,20 S500 ");
  CHECK(cycle_stops("G98 G89 X1 Z-5 R1 P1") == "R1,0,20 R1,0,1 F1,0,-5 D1 F1,0,20 ");
  CHECK(cycle_stops("G98 G84 X1 Z-7 R2 P1") == "R1,0,20 R1,0,2 F1,0,-7 S-500 D1 F1,0,20 S500 ");
  CHECK(cycle_stops("M04\nG98 G74 X1 Z-7 R2") ==
        "S-500 R1,0,20 R1,0,2 F1,0,-7 S500 F1,0,20 S-500 ");
  CHECK(cycle_stops("G82 X1 Z-5 R1 P500", Dialect::fanuc) ==
        "R1,0,20 R1,0,1 F1,0,-5 D0.5 R1,0,20 ");
}

TEST_CASE("no override counts from R to the bottom of a tap and back", "[ipr][cycles]") {
  const auto overrides = [](const std::string& text, Dialect dialect = Dialect::linuxcnc) {
    std::string all;
    for (const Move& move :
         moves_of("F100 S500 M03 G00 Z20\n" + text + "\nM02\n", {}, {.dialect = dialect}))
      if (!move.rapid)
        all += std::string(move.feed_override ? "f" : "-") + (move.speed_override ? "s " : "- ");
    return all;
  };
  CHECK(overrides("G98 G84 X1 Z-7 R2\nX2\nG80\nG01 X3") == "-- -- -- -- fs ");
  CHECK(overrides("M04\nG99 G74 X1 Z-7 R2\nG80\nG01 X3") == "-- -- fs ");
  CHECK(overrides("G99 G84 X1 Z-7 R2\nG80\nG01 X3", Dialect::fanuc) == "-- -- fs ");
  CHECK(overrides("M50 P0\nG99 G84 X1 Z-7 R2\nG80\nG01 X3") == "-- -- -s ");
  CHECK(overrides("M51 P0\nG99 G84 X1 Z-7 R2\nG80\nG01 X3") == "-- -- f- ");
  CHECK(overrides("M49\nG99 G84 X1 Z-7 R2\nG80\nG01 X3\nM48 X4") == "-- -- -- fs ");
  CHECK(overrides("G99 G81 X1 Z-7 R2\nG89 X2 Z-7 R2 P1\nG85 X3 Z-7 R2") == "fs fs fs fs fs ");
}

TEST_CASE("cycles in the other planes, in inches and in a turned system", "[ipr][cycles]") {
  CHECK(cycle_stops("G18 G99 G81 X1 Y-5 Z4 R1\nZ6") ==
        "R0,1,20 R1,1,4 F1,-5,4 R1,1,4 R1,1,6 F1,-5,6 R1,1,6 ");
  CHECK(cycle_stops("G20 F10 G99 G81 X1 Z-.5 R.1") ==
        "R25.4,0,20 R25.4,0,2.54 F25.4,0,-12.7 R25.4,0,2.54 ");
  MachineState state;
  state.work[0].origin = {10, 0, 5};
  state.work[0].rotation = std::numbers::pi / 2;
  Diagnostics diagnostics;
  Reader reader = Reader::from_text("F100 G81 X1 Y2 Z-5 R1\nM02\n");
  Parser parser(reader, diagnostics);
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, {}, state);
  interpreter.next();
  interpreter.next();
  const auto feed = interpreter.next();
  CHECK((end(std::get<Move>(feed->what).path) - AxisVector(8, 1, 0)).norm() < 1e-9);
}

TEST_CASE("a cycle leads away from a contour", "[ipr][cycles]") {
  CHECK(cycle_stops("G41.1 D10 G01 X20\nX30\nG40\nG81 X40 Z-5 R10") ==
        "F20,5,20 F30,5,20 R40,0,20 R40,0,10 F40,0,-5 R40,0,10 ");
}

TEST_CASE("a cycle that would never end is refused", "[ipr][cycles]") {
  CHECK(reported("F1 G83 X1 Z-100 R1 Q0.0001") == Places{"SC2007 1:4"});
  CHECK(reported("F1 G91 G81 X1 Z-1 R-1 L999999") == Places{"SC2007 1:8"});
}

TEST_CASE("in G93 a move takes one over F minutes", "[ipr][cycles]") {
  const auto moves = moves_of("G93 G01 X10 F2\nG02 X30 I10 F0.5\nG94 F60\nG01 X0\nM02\n");
  CHECK(moves[0].feed == Approx(10 * 2 / 60.0));
  CHECK(moves[1].feed == Approx(10 * std::numbers::pi * 0.5 / 60));
  CHECK(moves[2].feed == Approx(1));
  CHECK(reported("G93 G01 X10 F2\nX20") == Places{"SC2102 2:1"});
  CHECK(reported("F100 G93\nG00 X10\nG94 G01 X20") == Places{"SC2102 3:5"});
}

TEST_CASE("in G95 the feed is that of the spindle", "[ipr][cycles]") {
  const auto moves = moves_of("S600 M03 G95 G01 X10 F0.1\nS1200\nX20\nG20 G01 X1 F0.01\nM02\n");
  CHECK(moves[0].feed == Approx(1));
  CHECK(moves[1].feed == Approx(2));
  CHECK(moves[2].feed == Approx(0.254 * 20));
  CHECK(reported("G95 G01 X1 F1") == Places{"SC2222 1:5"});
}

TEST_CASE("FANUC keeps the words of a row from cycle to cycle", "[ipr][cycles][fanuc]") {
  CHECK(cycle_stops("G98 G81 X1 Y1 Z-5 R2\nG82 X2 P500", Dialect::fanuc) ==
        "R1,1,20 R1,1,2 F1,1,-5 R1,1,20 R2,1,20 R2,1,2 F2,1,-5 D0.5 R2,1,20 ");
  CHECK(cycle_stops("G99 G81 X1 Z-5 R2\nG85 X3", Dialect::fanuc) ==
        "R1,0,20 R1,0,2 F1,0,-5 R1,0,2 R3,0,2 F3,0,-5 F3,0,2 ");
  CHECK(reported("F1 G81 X1 Z-5 R1\nG82 X6\nG80\nG82 X7", Dialect::fanuc) == Places{"SC2005 4:1"});
  CHECK(reported("F1 G81 X1 Z-5 R1\nG0 Z9\nG82 X7", Dialect::fanuc) == Places{"SC2005 3:1"});
  CHECK(reported("F1 G76 X1 Z-5 R1 Q1\nG81 X2\nX3", Dialect::fanuc) == Places{"SC2161 1:4"});
}

TEST_CASE("FANUC's G80 gives back the motion from before the cycle", "[ipr][cycles][fanuc]") {
  CHECK(cycle_stops("G1 Z1\nG80\nX7", Dialect::fanuc) == "F0,0,1 F7,0,1 ");
  CHECK(cycle_stops("G99 G81 X1 Z-5 R1\nG82 X2\nG80\nX7", Dialect::fanuc) ==
        "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 R2,0,1 F2,0,-5 R2,0,1 R7,0,1 ");
  CHECK(cycle_stops("G1 Z1\nG99 G81 X1 Z-5 R0\nG80 X20 Z50", Dialect::fanuc) ==
        "F0,0,1 R1,0,1 R1,0,0 F1,0,-5 R1,0,0 F20,0,50 ");
  CHECK(reported("G80 X20", Dialect::fanuc) == Places{"SC2101 1:5"});
  CHECK(reported("G0 Z1\nG80 X20") == Places{"SC2101 2:5"});
  CHECK(reported("G0 Z1\nG33 Z5 K1\nG80\nX20", Dialect::fanuc) ==
        Places{"SC2114 2:1", "SC2101 4:1"});
  CHECK(reported("G0 Z1\nG999\nG80\nX20", Dialect::fanuc) == Places{"SC2001 2:1"});
  CHECK(reported("F1 G6.1 X1\nX2 Y1\nG80\nX20", Dialect::fanuc) == Places{"SC2101 4:1"});
}

TEST_CASE("FANUC lays a motion before a cycle below it", "[ipr][cycles][fanuc]") {
  CHECK(cycle_stops("G98 G0 G81 X5 Z-1 R2\nG80 X7", Dialect::fanuc) ==
        "R5,0,20 R5,0,2 F5,0,-1 R5,0,20 R7,0,20 ");
  CHECK(cycle_stops("G1 G98 G81 X5 Z-1 R2\nG80\nX7", Dialect::fanuc) ==
        "R5,0,20 R5,0,2 F5,0,-1 R5,0,20 F7,0,20 ");
  CHECK(cycle_stops("G99 G81 X1 Z-5 R1\nG0 G98 G82 X2 Z-5 R1", Dialect::fanuc) ==
        "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 R2,0,1 F2,0,-5 R2,0,1 ");
  CHECK(reported("F1 G0 G81 X5 Z-1 R2") == Places{"SC2002 1:7"});
  CHECK(reported("F1 G81 G0 X5 Z-1 R2", Dialect::fanuc) == Places{"SC2002 1:8"});
  CHECK(reported("F1 G0 G81 G82 X5 Z-1 R2", Dialect::fanuc) == Places{"SC2002 1:11"});
}

TEST_CASE("FANUC's peck drilling may dwell, and its tapping does not peck",
          "[ipr][cycles][fanuc]") {
  CHECK(cycle_stops("G98 G83 X1 Z-4 R2 Q3 P250", Dialect::fanuc) ==
        "R1,0,20 R1,0,2 F1,0,-1 R1,0,2 R1,0,-0.746 F1,0,-4 D0.25 R1,0,20 ");
  CHECK(cycle_stops("G99 G73 X1 Z-1 R2 Q3 P250", Dialect::fanuc) ==
        "R1,0,20 R1,0,2 F1,0,-1 D0.25 R1,0,2 ");
  CHECK(reported("F1 G83 X1 Z-1 R2 Q3 P1\nX2") == Places{"SC2004 1:21"});
  CHECK(reported("S9 M3\nF1 G84 X1 Z-1 R1 Q1", Dialect::fanuc) == Places{"SC2114 2:18"});
  CHECK(reported("S9 M3\nF1 G84 X1 Z-1 R1 Q0", Dialect::fanuc).empty());
  CHECK(reported("S9 M3\nF1 G84 X1 Z-1 R1 Q0") == Places{"SC2004 2:18"});
  CHECK(reported("M29 S500\nF1 G84 X1 Z-1 R1", Dialect::fanuc) == Places{"SC2114 1:1"});
}

TEST_CASE("FANUC's taps and bores go out at the feed to R only", "[ipr][cycles][fanuc]") {
  CHECK(cycle_stops("G98 G84 X1 Z-7 R2 P1000", Dialect::fanuc) ==
        "R1,0,20 R1,0,2 F1,0,-7 S-500 D1 F1,0,2 S500 R1,0,20 ");
  CHECK(cycle_stops("M04\nG98 G74 X1 Z-7 R2", Dialect::fanuc) ==
        "S-500 R1,0,20 R1,0,2 F1,0,-7 S500 F1,0,2 S-500 R1,0,20 ");
  CHECK(cycle_stops("G98 G89 X1 Z-5 R1 P1000", Dialect::fanuc) ==
        "R1,0,20 R1,0,1 F1,0,-5 D1 F1,0,1 R1,0,20 ");
  CHECK(cycle_stops("G99 G84 X1 Z-7 R2", Dialect::fanuc) == cycle_stops("G99 G84 X1 Z-7 R2"));
}

}  // namespace softcnc::ipr
