// SPDX-License-Identifier: MIT
// G15 and G16, and LinuxCNC's words @ and ^.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "ipr/ends.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

const double kRoot3 = std::sqrt(3.0);

/// The places of the holes of a drilling program, at their bottom Z-1.
std::vector<AxisVector> drilled_places(const std::string& text, Dialect dialect) {
  std::vector<AxisVector> all;
  for (const AxisVector& at : ends(text, {.dialect = dialect}))
    if (at[2] == -1) all.push_back(at);
  return all;
}

}  // namespace

TEST_CASE("G16 reads radius and angle in any plane", "[ipr][polar]") {
  check_ends("F100\nG16 G1 X10 Y60 Z2\nG15\nX3 Y1", {{5, 5 * kRoot3, 2}, {3, 1, 2}});
  check_ends("F100 G18\nG16\nG1 Z10 X30 Y2", {{5, 2, 5 * kRoot3}});
  check_ends("F100 G19\nG16\nG1 Y10 Z180", {{0, -10, 0}});
  check_ends("F100 G20\nG16\nG1 X1 Y90", {{0, 25.4, 0}});
  check_ends("F100\nG10 L2 P1 X1 Y2\nG54 G16\nG1 X10 Y90", {{1, 12, 0}});
}

// Mitsubishi's manual of the M700V, 6.12: a radius left out is that of the position, seen from the
// zero point; an angle likewise; a radius in G91 counts from the position.
TEST_CASE("G16 takes what is left out from the position", "[ipr][polar]") {
  check_ends("F100\nG0 X6 Y8\nG16\nG1 Y0\nX5\nG91 Y90",
             {{6, 8, 0}, {10, 0, 0}, {5, 0, 0}, {0, 5, 0}});
  check_ends("F100\nG0 X6 Y8\nG16\nG91 G1 X5\nX10 Y-90", {{6, 8, 0}, {9, 12, 0}, {17, 6, 0}});
  check_ends("F100\nG16\nG1 X10\nZ1", {{10, 0, 0}, {10, 0, 1}});
}

TEST_CASE("arcs end in polar coordinates, and take R", "[ipr][polar]") {
  const auto moves = moves_of("F100\nG0 X10\nG16\nG3 X10 Y90 R10\nM30\n");
  const auto& arc = std::get<Arc>(moves.at(1).path);
  CHECK(near(arc.to(), {0, 10, 0}));
  CHECK(near(arc.center(), {0, 0, 0}));
  CHECK(reported("F100\nG0 X10\nG16\nG3 X10 Y90 I-10 J0") == Places{"SC2255 4:12"});
}

// FANUC's operator's manual, 9.2: a bolt circle by absolute and by incremental angles.
TEST_CASE("holes on a circle by G16", "[ipr][polar]") {
  const std::string begin = "F100\nG0 Z5\nG17 G90 G16\nG81 X100 Y30 Z-1 R1\n";
  const std::vector<AxisVector> wanted{
      {50 * kRoot3, 50, -1}, {-50 * kRoot3, 50, -1}, {0, -100, -1}};
  for (const char* next :
       {"Y150\nY270\nG15 G80", "G91 Y120 Z-2 R-4\nY120\nG15 G80", "G91 Y120 Z-2 R-4 K2\nG15 G80"}) {
    INFO(next);
    const auto found = drilled_places(begin + next, Dialect::fanuc);
    REQUIRE(found.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(near(found[i], wanted[i]));
  }
}

TEST_CASE("a transformation turns what polar coordinates name", "[ipr][polar]") {
  check_ends("F100\nG68 X10 Y0 R90\nG16\nG1 X20 Y0", {{10, 10, 0}});
}

// LinuxCNC's manual, "Polar Coordinates"; the values by rs274.
TEST_CASE("@ and ^ give a radius and an angle", "[ipr][polar]") {
  check_ends("F100\nG1 @10 ^90", {{0, 10, 0}});
  check_ends("F100\nG1 X3 Y4\n@10\n^0\n@[2+3] ^#1", {{3, 4, 0}, {6, 8, 0}, {10, 0, 0}, {5, 0, 0}});
  check_ends("F100\nG1 @5 ^90\nG91 @1 ^90\n^90\n@1\nZ3",
             {{0, 5, 0}, {-6, 0, 0}, {0, -6, 0}, {0, -7, 0}, {0, -7, 3}});
  check_ends("F100 G20\nG1 @1 ^180 Z1", {{-25.4, 0, 25.4}});
  check_ends("F100 G18\nG1 @10 ^90", {{10, 0, 0}});
  check_ends("F100\nG0 X5\nG2 @5 ^90 I-5 J0\nG3 ^180 R5", {{5, 0, 0}, {0, 5, 0}, {-5, 0, 0}});
}

TEST_CASE("@ and ^ place the holes of cycles", "[ipr][polar]") {
  const auto found =
      drilled_places("F100\nG0 X5 Z2\nG91 G81 ^90 Z-2 R-1 L3\nG80", Dialect::linuxcnc);
  REQUIRE(found.size() == 3);
  CHECK(near(found[0], {0, 5, -1}));
  CHECK(near(found[1], {-5, 0, -1}));
  CHECK(near(found[2], {0, -5, -1}));
}

TEST_CASE("what @ and ^ may not stand beside", "[ipr][polar]") {
  CHECK(reported("F100\nG1 @5 X1") == Places{"SC2258 2:7"});
  CHECK(reported("G28 @5 ^3") == Places{"SC2258 1:5"});
  CHECK(reported("G92 ^3 @5") == Places{"SC2258 1:5"});
  CHECK(reported("G0 X5\nG53 G0 @5 ^90") == Places{"SC2258 2:8"});
  CHECK(reported("@5 ^30") == Places{"SC2101 1:1"});
  CHECK(reported("G0 @5 @4 ^3") == Places{"SC2003 1:7"});
  CHECK(reported("G0 @ ^3") == Places{"SC1002 1:4"});
  CHECK(reported("M3 S100\nT1 @5") == Places{"SC2101 2:4"});
}

TEST_CASE("at the zero point there is no direction", "[ipr][polar]") {
  CHECK(reported("G0 @5") == Places{"SC2259 1:4"});
  CHECK(reported("G91 G0 @5 ^3") == Places{"SC2259 1:8"});
  CHECK(reported("G0 ^30").empty());
  CHECK(reported("F100\nG0 @5\nG2 X20 Y0 I1 J0") == Places{"SC2259 2:4"});
}

TEST_CASE("an unknown polar word leaves the end unknown", "[ipr][polar]") {
  CHECK(reported("F100\nG0 @#<a> ^30\nG2 X20 Y0 I1 J0") == Places{"SC1024 2:5"});
  CHECK(reported("F100\nG16 G0 X#<a>\nG2 X20 Y0 R1") == Places{"SC1024 2:9"});
  CHECK(reported("F100\nG0 X#<a>\nG16 Y30\nG15 G2 X20 Y0 I1 J0") == Places{"SC1024 2:5"});
}

}  // namespace softcnc::ipr
