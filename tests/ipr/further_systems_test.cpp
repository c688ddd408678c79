// SPDX-License-Identifier: MIT
// G54.1 P, G154 P and G110 to G129: work systems beyond G59.3, and what sets and reads them.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

/// A program of the fanuc dialect after its first systems have been set.
std::string with_systems(const std::string& text) {
  return "G90 G10 L20 P1 X100 Y10\nG10 L20 P2 X200\nG10 L20 P300 Z5\n" + text + "\nM30\n";
}

AxisVector place_in_systems(const std::string& text) {
  return last_place(with_systems(text), kFanuc);
}

}  // namespace

TEST_CASE("a further work system moves the origin", "[ipr][further]") {
  CHECK(place_in_systems("G54.1 P1 G00 X1 Y1") == AxisVector(101, 11, 0));
  CHECK(place_in_systems("G54.1 P2 G00 X1 Y1") == AxisVector(201, 1, 0));
  CHECK(place_in_systems("G54.1 P300 G00 X1 Y1 Z1") == AxisVector(1, 1, 6));
  CHECK(place_in_systems("G54.1 P3 G00 X1 Y1") == AxisVector(1, 1, 0));
  CHECK(place_in_systems("G54.1 P2\nG00 X1\nG54\nX2") == AxisVector(2, 0, 0));
  CHECK(last_place("G21 G90\nG54.1 P3\nG00 X10\nM30\n") == AxisVector(10, 0, 0));
}

TEST_CASE("the names of Haas and FANUC mean the same systems", "[ipr][further]") {
  CHECK(place_in_systems("G154 P1 G00 X1 Y1") == AxisVector(101, 11, 0));
  CHECK(place_in_systems("G110 G00 X1 Y1") == AxisVector(101, 11, 0));
  CHECK(place_in_systems("G111 G00 X1 Y1") == AxisVector(201, 1, 0));
  CHECK(place_in_systems("G54.1 G00 X1 Y1") == AxisVector(101, 11, 0));  // P1
  for (int i = 0; i < 20; ++i) {
    const std::string number = std::to_string(i + 1);
    CHECK(last_place("G10 L20 P" + number + " X7\nG" + std::to_string(110 + i) + " G00 X1\nM30\n",
                     kFanuc) == AxisVector(8, 0, 0));
  }
}

TEST_CASE("G54 P is G54.1 P in the fanuc dialect, unless P belongs to another code",
          "[ipr][further][fanuc]") {
  CHECK(place_in_systems("G54 P2 G00 X1") == AxisVector(201, 0, 0));
  CHECK(place_in_systems("G54 G04 P2\nG00 X1") == AxisVector(1, 0, 0));
  CHECK(places(interpret("G54 P2\nM30\n")) == Places{"SC2004 1:5"});
}

TEST_CASE("G10 L20 sets a further system, in G91 by distances", "[ipr][further][fanuc]") {
  const auto state_of = [](const std::string& text) {
    return interpret(with_systems(text), {}, kFanuc).state;
  };
  const MachineState state = state_of("G91 G10 L20 P1 X1 Y1\nG20 G90 G10 L20 P4 Z1");
  CHECK(state.further_work.at(1).origin == AxisVector(101, 11, 0));
  CHECK(state.further_work.at(4).origin == AxisVector(0, 0, 25.4));
  CHECK(state.further_work.size() == 4);
  CHECK(state.active == 0);  // M30
}

TEST_CASE("in linuxcnc G10 L20 goes by the position", "[ipr][further]") {
  const MachineState state = interpret("G10 L20 P2 X5\nM30\n").state;
  CHECK(state.work[1].origin == AxisVector(-5, 0, 0));
  CHECK(state.further_work.empty());
}

TEST_CASE("variables read and set further systems", "[ipr][further][fanuc]") {
  CHECK(place_in_systems("#1=#7001+#14002 G00 X#1") == AxisVector(110, 0, 0));
  CHECK(place_in_systems("G00 X#7021 Y#14021 Z#19983") == AxisVector(200, 200, 5));
  CHECK(place_in_systems("#7041=7\nG54.1 P3 G00 X1") == AxisVector(8, 0, 0));
  CHECK(place_in_systems("#19981=7\nG54.1 P300 G00 X1") == AxisVector(8, 0, 0));
  CHECK(place_in_systems("G20\n#14001=1\nG21 G54.1 P1 G00 X1") == AxisVector(26.4, 0, 0));
  CHECK(place_in_systems("G54.1 P7\nG00 X#4130 Y[#4014*10]") == AxisVector(7, 541, 0));
  CHECK(place_in_systems("G00 X1\nX#4130 Y#7943") == AxisVector(0, 0, 0));
  const MachineState state = interpret(with_systems("G00 X#14061"), {}, kFanuc).state;
  CHECK(state.further_work.size() == 3);  // reading adds none
}

TEST_CASE("numbers between those of the coordinates are no variables", "[ipr][further][fanuc]") {
  for (const char* number : {"7000", "7004", "7944", "7961", "14000", "14004", "19984", "20001"})
    CHECK(places(interpret("#" + std::string(number) + "=1\nM30\n", {}, kFanuc)).size() == 1);
}

TEST_CASE("what is no number of a system is reported", "[ipr][further]") {
  CHECK(reported("G54.1 P0") == Places{"SC2007 1:7"});
  CHECK(reported("G54.1 P301") == Places{"SC2007 1:7"});
  CHECK(reported("G54.1 P1.5") == Places{"SC2007 1:7"});
  CHECK(reported("G154 P100") == Places{"SC2007 1:6"});
  CHECK(reported("G154") == Places{"SC2005 1:1"});
  CHECK(reported("G54.1 P1 M98") == Places{"SC2266 1:7"});
  CHECK(reported("G54.1 P1 G04") == Places{"SC2266 1:7"});
  CHECK(reported("G54.1 P1 G55") == Places{"SC2002 1:10"});
  CHECK(reported("G10 L20 P301 X1", Dialect::fanuc) == Places{"SC2007 1:9"});
  CHECK(reported("G10 L20 P1 X1 R1", Dialect::fanuc) == Places{"SC2004 1:15"});
  CHECK(reported("G10 L20 X1", Dialect::fanuc) == Places{"SC2005 1:1"});
}

TEST_CASE("a system whose number is unknown leaves the position open", "[ipr][further][unknown]") {
  CHECK(reported("F100\nG54.1 P1.2.3\nG00 X5\nG02 X1 I1") == Places{"SC1004 2:8"});
}

TEST_CASE("cutter compensation keeps the work system", "[ipr][further]") {
  const std::string contour = "F100 G41.1 D2 G01 X20\n";
  CHECK(reported(contour + "G154 P2") == Places{"SC2140 2:1"});
  CHECK(reported(contour + "G110") == Places{"SC2140 2:1"});
  CHECK(reported("G54.1 P2\n" + contour + "G10 L20 P2 X1", Dialect::fanuc) == Places{"SC2140 3:1"});
  CHECK(reported("G54.1 P2\n" + contour + "G10 L20 P1 X1\nX40", Dialect::fanuc) == Places{});
}

TEST_CASE("saved modes bring a further system back", "[ipr][further]") {
  CHECK(place_in_systems("G54.1 P2\nM70\nG54\nM72\nG00 X1") == AxisVector(201, 0, 0));
}

}  // namespace softcnc::ipr
