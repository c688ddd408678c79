// SPDX-License-Identifier: MIT
// Work systems, machine coordinates and shifts. The places are those of LinuxCNC's rs274, brought
// into machine coordinates by hand.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {}  // namespace

TEST_CASE("each work system has its origin", "[ipr][offsets]") {
  const std::string set =
      "G10 L2 P1 X1\nG10 L2 P2 X2\nG10 L2 P3 X3\nG10 L2 P4 X4\nG10 L2 P5 X5\nG10 L2 P6 X6\n"
      "G10 L2 P7 X7\nG10 L2 P8 X8\nG10 L2 P9 X9\n";
  const std::array<std::string, kWorkSystems> codes{"G54", "G55",   "G56",   "G57",  "G58",
                                                    "G59", "G59.1", "G59.2", "G59.3"};
  for (std::size_t i = 0; i < codes.size(); ++i) {
    INFO(codes[i]);
    CHECK(last_place(set + codes[i] + " G00 X10 Y1\nM30\n") ==
          AxisVector(11 + static_cast<double>(i), 1, 0));
  }
}

TEST_CASE("G10 L2 moves the work system in force under the machine", "[ipr][offsets]") {
  CHECK(last_place("G00 X1\nG10 L2 P1 X5\nY2\nM30\n") == AxisVector(1, 2, 0));
  CHECK(last_place("G00 X1\nG10 L2 P0 X5\nX0\nM30\n") == AxisVector(5, 0, 0));
  CHECK(last_place("G91 G10 L2 P1 X10\nG10 L2 P1 X10\nG90 G00 X1\nM30\n").x() == 11);
  CHECK(last_place("G20 G10 L2 P1 X1\nG21 G00 X1\nM30\n").x() == 26.4);
}

TEST_CASE("R turns the work system about its origin", "[ipr][offsets]") {
  CHECK(near(last_place("G00 X1 Y2\nG10 L2 P1 X10 Y20 R90\nX1 Y0\nM30\n"), {10, 21, 0}));
  CHECK(near(last_place("G00 Y5\nG10 L2 P0 X7 R30\nX1 Y0\nM30\n"), {7.866025403784438, 0.5, 0}));
  CHECK(near(last_place("G10 L2 P1 R90\nG91 G00 X1\nX1\nM30\n"), {0, 2, 0}));
  CHECK(near(last_place("G20 G10 L2 P1 X1 R90\nG00 X1 Y0\nM30\n"), {25.4, 25.4, 0}));
  CHECK(near(last_place("G10 L2 P1 R30\nG10 L2 P1 X5\nG00 X10 Y0\nM30\n"),
             {5 + 8.660254037844387, 5, 0}));
}

TEST_CASE("G53 goes to machine coordinates for one line", "[ipr][offsets]") {
  const std::string set = "G10 L2 P1 X10 Y20 Z3 R90\nG43.1 Z50\n";
  CHECK(last_place(set + "G53 G00 X1 Y2\nM30\n") == AxisVector(1, 2, 0));
  CHECK(near(last_place(set + "G53 G00 X1 Y2\nX0 Y0\nM30\n"), {10, 20, 0}));
  CHECK(last_place(set + "G20 G53 G00 X1\nM30\n").x() == 25.4);
  const auto moves = moves_of("G10 L2 P1 X9\nG01 F60 X0\nG53 X1\nM30\n");
  CHECK(end(moves[1].path).x() == 1);
  CHECK_FALSE(moves[1].rapid);
}

TEST_CASE("in the fanuc dialect G53 is a rapid, whatever is in force", "[ipr][offsets][fanuc]") {
  const auto moves = moves_of("G53 X5\nG01 F60 X1\nG53 X2\nX3\nM30\n", {}, kFanuc);
  CHECK(moves[0].rapid);
  CHECK_FALSE(moves[1].rapid);
  CHECK(moves[2].rapid);
  CHECK_FALSE(moves[3].rapid);
}

TEST_CASE("G92 names the position", "[ipr][offsets]") {
  CHECK(last_place("G00 X1 Y2\nG92 X0\nX5\nM30\n") == AxisVector(6, 2, 0));
  CHECK(last_place("G92 X5\nG91 G92 X5\nG90 G00 X6\nM30\n").x() == 1);
  CHECK(near(last_place("G10 L2 P1 R90\nG92 X5\nG00 X6 Y0\nM30\n"), {0, 1, 0}));
  CHECK(last_place("G20 G92 X1\nG00 X2\nM30\n").x() == Approx(25.4));
}

TEST_CASE("the shift of G92 holds in every work system", "[ipr][offsets]") {
  CHECK(last_place("G92 X5\nG10 L2 P2 X100\nG55 G00 X0\nM30\n").x() == 95);
}

TEST_CASE("G92.1 forgets the shift, G92.2 suspends it, G92.3 resumes it", "[ipr][offsets]") {
  CHECK(last_place("G92 X5\nG92.1\nG00 X1\nM30\n").x() == 1);
  CHECK(last_place("G92 X5\nG92.1\nG92.3\nG00 X1\nM30\n").x() == 1);
  CHECK(last_place("G92 X5\nG92.2 G00 X1\nM30\n").x() == 1);
  CHECK(last_place("G92 X5\nG92.2\nG92.3 G00 X1\nM30\n").x() == -4);
  CHECK(last_place("G92 X5 Y6\nG92.2\nG92 X1\nG00 X2 Y2\nM30\n") == AxisVector(1, 2, 0));
}

TEST_CASE("FANUC's G92.1 moves nothing and forgets the shift of the axes it names",
          "[ipr][offsets][fanuc]") {
  const std::string shifted = "G00 X7 Y7\nG92 X5 Y6\nG52 X1 Y1\n";
  CHECK(last_place(shifted + "G92.1 X0\nM30\n", kFanuc) == AxisVector(7, 7, 0));
  CHECK(last_place(shifted + "G92.1 X0\nG00 X1 Y1\nM30\n", kFanuc) == AxisVector(1, 3, 0));
  CHECK(last_place(shifted + "G92.1 X0 Y0\nG00 X1 Y1\nM30\n", kFanuc) == AxisVector(1, 1, 0));
  CHECK(last_place("G00 X7\nG92.1 X0\nM30\n").x() == 0);  // elsewhere X is where to go
}

TEST_CASE("G52 and G92 share one shift", "[ipr][offsets]") {
  CHECK(last_place("G52 X5\nG00 X1\nM30\n").x() == 6);
  CHECK(last_place("G52 X5\nG00 X0\nG92 X3\nX1\nM30\n").x() == 3);
  CHECK(last_place("G92 X5 Y6\nG52 X1\nG00 X0 Y0\nM30\n") == AxisVector(1, -6, 0));
  CHECK(last_place("G00 X1 Y2\nG92 X0\nG52 X0\nX5\nM30\n") == AxisVector(5, 2, 0));
}

TEST_CASE("in the fanuc dialect G52 is a shift of its own", "[ipr][offsets][fanuc]") {
  CHECK(last_place("G92 X5\nG52 X1\nG00 X0\nM30\n", kFanuc).x() == -4);
  CHECK(last_place("G92 X5\nG52 X1\nG52 X0\nG00 X0\nM30\n", kFanuc).x() == -5);
  CHECK(last_place("G52 X1\nG92 X5\nG00 X6\nM30\n", kFanuc).x() == 1);
  const Interpreted result = interpret("G52 X1\nG00 X0\nM30\n", {}, kFanuc);
  CHECK(result.state == MachineState{});
}

TEST_CASE("offsets stay, and the next program begins in G54", "[ipr][offsets]") {
  const Interpreted result = interpret("G10 L2 P2 X1 R90\nG55\nG92 Y3\nM30\n");
  CHECK(result.state.work[1].origin == AxisVector(1, 0, 0));
  CHECK(result.state.work[1].rotation == Approx(1.5707963267948966));
  CHECK(result.state.active == 0);
  CHECK(result.state.shift_on);
  CHECK(near(result.state.shift, {0, -2, 0}));
}

TEST_CASE("arcs turn with the work system", "[ipr][offsets][arcs]") {
  const auto moves = moves_of("G10 L2 P1 X100 Y50 R90\nG00 X0 Y0\nF100 G03 X10 Y0 I5 J0\nM30\n");
  const Arc& arc = std::get<Arc>(moves[1].path);
  CHECK(near(arc.from(), {100, 50, 0}));
  CHECK(near(arc.to(), {100, 60, 0}));
  CHECK(near(arc.center(), {100, 55, 0}));
  CHECK(arc.ccw());
}

TEST_CASE("after a bad offset nothing is said of positions", "[ipr][offsets]") {
  CHECK(places(interpret("F100\nG10 L2 X5\nG53 G00 X0\nG02 X9 I1\nM30\n")) == Places{"SC2005 2:1"});
  CHECK(places(interpret("F100\nG92 X1.2.3\nG02 X9 Y1 I1\nM30\n")) == Places{"SC1004 2:6"});
  CHECK(places(interpret("F100\nG92 X1.2.3\nG00 X0 Y0\nG02 X9 Y1 I1\nM30\n")) ==
        Places{"SC1004 2:6"});
}

}  // namespace softcnc::ipr
