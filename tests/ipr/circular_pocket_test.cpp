// SPDX-License-Identifier: MIT
// G12 and G13 against the radii and places that their words state.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

using std::numbers::pi;

Machine pocket_mill() {
  Machine machine;
  machine.tools[1].radius = 3;
  return machine;
}

std::vector<Move> pocket_moves(const std::string& text) {
  return moves_of("F600\n" + text + "\nM30\n", pocket_mill());
}

const Arc& arc_of(const std::vector<Move>& all, std::size_t i) {
  return std::get<Arc>(all.at(i).path);
}

Places reported_of_pocket(const std::string& text) {
  return reported("F600\n" + text, Dialect::linuxcnc, pocket_mill());
}

/// The largest distance of the path from a centre in the plane X Y.
double reach(const std::vector<Move>& all, const AxisVector& center) {
  double most = 0;
  for (const Move& move : all)
    for (int i = 0; i <= 32; ++i) {
      AxisVector off = position(move.path, length(move.path) * i / 32) - center;
      off[2] = 0;
      most = std::max(most, off.norm());
    }
  return most;
}

}  // namespace

TEST_CASE("G12 cuts one circle of radius I less that of the tool", "[ipr][pocket]") {
  const auto all = pocket_moves("G00 X10 Y20 Z1\nG12 I12 Z-5 D1");
  REQUIRE(all.size() == 5);
  CHECK(near(end(all[1].path), {10, 20, -5}));
  CHECK(near(end(all[2].path), {19, 20, -5}));  // a half circle out
  CHECK(near(arc_of(all, 2).center(), {14.5, 20, -5}));
  CHECK(near(end(all[3].path), {19, 20, -5}));  // the circle
  CHECK(near(arc_of(all, 3).center(), {10, 20, -5}));
  CHECK(length(all[3].path) == Approx(2 * pi * 9));
  CHECK(near(end(all[4].path), {10, 20, -5}));  // a half circle back
  for (std::size_t i = 2; i < 5; ++i) CHECK_FALSE(arc_of(all, i).ccw());
  for (std::size_t i = 1; i < 5; ++i) {
    CHECK_FALSE(all[i].rapid);
    CHECK(all[i].feed == Approx(10));
  }
}

TEST_CASE("G13 turns the other way and goes from I to K in steps of Q", "[ipr][pocket]") {
  const auto all = pocket_moves("G13 I4 K12 Q3 Z-2 D1");
  // Radii of the tool: 1, 4, 7, 9; out, four circles, three steps in between, back; down before.
  REQUIRE(all.size() == 1 + 1 + 4 + 3 + 1);
  const double radii[] = {1, 4, 7, 9};
  double side = 1;
  for (std::size_t i = 0; i < 4; ++i, side = -side) {
    const Arc& circle = arc_of(all, 2 + 2 * i);
    CHECK(near(circle.center(), {0, 0, -2}));
    CHECK(near(circle.from(), {side * radii[i], 0, -2}));
    CHECK(length(all[2 + 2 * i].path) == Approx(2 * pi * radii[i]));
    CHECK(circle.ccw());
    const double before = i == 0 ? 0 : radii[i - 1];
    const Arc& step = arc_of(all, 1 + 2 * i);
    CHECK(step.sweep() == Approx(pi));
    CHECK(length(all[1 + 2 * i].path) == Approx(pi * (before + radii[i]) / 2));
  }
  CHECK(near(end(all.back().path), {0, 0, -2}));
  CHECK(reach(all, {0, 0, 0}) == Approx(9));
}

TEST_CASE("joints of the passes have one direction", "[ipr][pocket]") {
  const auto all = pocket_moves("G13 I4 K12 Q3 Z-2 D1");
  for (std::size_t i = 1; i + 1 < all.size(); ++i) {
    const AxisVector arriving = at(all[i].path, length(all[i].path), Side::before).dq;
    CHECK(arriving.dot(at(all[i + 1].path, 0).dq) == Approx(1));
  }
}

TEST_CASE("L repeats the pocket, in G91 deeper by Z each time", "[ipr][pocket]") {
  const auto all = pocket_moves("G00 Z1\nG91 G13 I5 Z-2 D1 L3");
  REQUIRE(all.size() == 1 + 3 * 4);
  for (int loop = 0; loop < 3; ++loop)
    CHECK(near(end(all[static_cast<std::size_t>(1 + 4 * loop)].path), {0, 0, -1.0 - 2 * loop}));
  CHECK(pocket_moves("G13 I5 Z-2 D1 L2").size() == 4 + 3);  // it is down already
}

TEST_CASE("X and Y lead to the centre at the feed", "[ipr][pocket]") {
  const auto all = pocket_moves("G13 X10 Y5 I5 Z-2 D1");
  CHECK(near(end(all[0].path), {10, 5, 0}));
  CHECK_FALSE(all[0].rapid);
  CHECK(near(arc_of(all, 3).center(), {10, 5, -2}));
  CHECK(near(end(pocket_moves("G00 X1\nG91 G13 X10 Y5 I5 Z-2 D1")[1].path), {11, 5, 0}));
}

TEST_CASE("D0 leads the centre of the tool, and the last D counts without one", "[ipr][pocket]") {
  CHECK(reach(pocket_moves("G13 I5 Z-2 D0"), {0, 0, 0}) == Approx(5));
  CHECK(reach(pocket_moves("G13 I5 Z-2 D1\nG13 I7 Z-3"), {0, 0, 0}) == Approx(4));
  CHECK(reported_of_pocket("G13 I5 Z-2") == Places{"SC2148 2:1"});
}

TEST_CASE("the pocket counts in inches and in a turned work system", "[ipr][pocket]") {
  CHECK(reach(pocket_moves("G20 F20\nG13 I1 Z-0.1 D0"), {0, 0, 0}) == Approx(25.4));
  const auto all = pocket_moves("G10 L2 P1 X1 Y2 R90\nG13 X10 Y0 I5 Z-2 D1");
  CHECK(near(end(all[0].path), {1, 12, 0}));
  CHECK(near(arc_of(all, 3).center(), {1, 12, -2}));
  CHECK(near(arc_of(all, 3).from(), {1, 14, -2}));
}

TEST_CASE("the example of a training manual of Haas reaches its radius and depth",
          "[ipr][pocket]") {
  // 3 inches wide and 1.5 deep, by a mill of 0.5: G13 G91 Z-0.5 I0.3 K1.5 Q0.3 D01 L3.
  Machine machine;
  machine.tools[1].radius = 6.35;
  const auto all =
      moves_of("G20 G90 G00 X1 Y1\nG01 Z0 F30\nG13 G91 Z-0.5 I0.3 K1.5 Q0.3 D01 F15 L3\nG90\nM30\n",
               machine);
  CHECK(reach(all, {25.4, 25.4, 0}) + 6.35 >= 38.1 - 1e-9);
  CHECK(end(all.back().path).z() == Approx(-38.1));
  double widest = 0;
  for (const Move& move : all)
    if (const auto* one = std::get_if<Arc>(&move.path))
      if (near(one->center(), {25.4, 25.4, one->center().z()}))
        widest = std::max(widest, one->radius());
  CHECK(widest == Approx(38.1 - 6.35));
}

TEST_CASE("G51 makes the pocket larger and leaves the tool", "[ipr][pocket]") {
  // The wall is at 2 x 12 mm, and the tool has a radius of 3 mm.
  const auto all = pocket_moves("G51 X0 Y0 P2.\nG00 X10 Y20 Z1\nG13 I6 K12 Q3 Z-5 D1");
  CHECK(reach({all.begin() + 2, all.end()}, {20, 40, 0}) == Approx(21).epsilon(1e-9));
  CHECK(reported_of_pocket("G51 X0 Y0 I2. J1. K1.\nG13 I12 Z-5 D1") == Places{"SC2256 3:1"});
  CHECK(reported_of_pocket("G18 G68 X0 Z0 R30\nG13 I12 Z-5 D1") == Places{"SC2251 3:1"});
}

TEST_CASE("words of a pocket that are missing or cannot be are reported", "[ipr][pocket]") {
  CHECK(reported_of_pocket("G12 Z-1 D1") == Places{"SC2005 2:1"});
  CHECK(reported_of_pocket("G12 I5 D1") == Places{"SC2005 2:1"});
  CHECK(reported_of_pocket("G12 I5 K9 Z-1 D1") == Places{"SC2005 2:1"});
  CHECK(reported_of_pocket("G12 I5 Q1 Z-1 D1") == Places{"SC2005 2:1"});
  CHECK(reported_of_pocket("G12 I5 K9 Q0 Z-1 D1") == Places{"SC2007 2:11"});
  CHECK(reported_of_pocket("G12 I3 Z-1 D1") == Places{"SC2267 2:5"});
  CHECK(reported_of_pocket("G12 I5 K5 Q1 Z-1 D1") == Places{"SC2267 2:8"});
  CHECK(reported_of_pocket("G12 I5 Z-1 D1 L0") == Places{"SC2007 2:15"});
  CHECK(reported_of_pocket("G12 I5 Z-1 D9") == Places{"SC2142 2:12"});
  CHECK(reported_of_pocket("G12 I5 K900 Q0.01 Z-1 D1") == Places{"SC2007 2:1"});
  CHECK(places(interpret("G12 I5 Z-1 D0\nM30\n")) == Places{"SC2102 1:1"});
  CHECK(reported_of_pocket("G93 G12 I5 Z-1 D0") == Places{"SC2220 2:5"});
  CHECK(reported_of_pocket("G41 D1 G01 X20\nG12 I5 Z-1 D1") == Places{"SC2140 3:1"});
}

}  // namespace softcnc::ipr
