// SPDX-License-Identifier: MIT
// G68, G51 and G51.1: paths against closed forms and against the path of the untransformed program.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "ipr/ends.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

using Map = std::function<AxisVector(const AxisVector&)>;

constexpr const char* kAngle345 = "R36.8698976458440213";  // of the triangle 3 4 5

/// Each path begins where the one before ends, exactly.
void check_joined(const std::vector<Move>& moves) {
  for (std::size_t i = 1; i < moves.size(); ++i)
    CHECK(start(moves[i].path) == end(moves[i - 1].path));
}

/// Points of one curve, those of a NURBS by its parameter, others by their length.
AxisVector point(const Path& path, double part) {
  if (const auto* nurbs = std::get_if<Nurbs>(&path))
    return nurbs->point(nurbs->u_first() + part * (nurbs->u_last() - nurbs->u_first()));
  return position(path, part * length(path));
}

/// Of a similarity: the image runs through the images of all points.
void check_images(const std::vector<Move>& moves, const std::vector<Move>& plain, const Map& map) {
  REQUIRE(moves.size() == plain.size());
  for (std::size_t i = 0; i < moves.size(); ++i) {
    CHECK(moves[i].path.index() == plain[i].path.index());
    for (const double part : {0.0, 0.2, 0.5, 0.7, 1.0}) {
      INFO("move " << i << " at " << part);
      CHECK(near(point(moves[i].path, part), map(point(plain[i].path, part)), 1e-7));
    }
  }
}

Map rotation(double degrees, double x, double y) {
  const double angle = degrees * std::numbers::pi / 180;
  return [=](const AxisVector& p) {
    const double c = std::cos(angle), s = std::sin(angle);
    return AxisVector(x + c * (p[0] - x) - s * (p[1] - y), y + s * (p[0] - x) + c * (p[1] - y),
                      p[2]);
  };
}

/// Absolute moves of every kind in the plane X Y, the first of them to a place of its own.
std::string random_program(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-50, 50);
  const auto at = [&] { return std::to_string(place(random)); };
  std::string text = "G0 X" + at() + " Y" + at() + " Z" + at() + "\n";
  for (int i = 0; i < 12; ++i) {
    const int kind = static_cast<int>(random() % 5);
    if (kind == 0) text += "G1 X" + at() + " Y" + at() + " Z" + at() + "\n";
    if (kind == 1) text += "G2 X" + at() + " Y" + at() + " Z" + at() + " R100\n";
    if (kind == 2) text += "G3 I" + at() + " J" + at() + "\n";
    if (kind == 3)
      text += "G5 X" + at() + " Y" + at() + " I" + at() + " J" + at() + " P" + at() + " Q" + at() +
              "\n";
    if (kind == 4)
      text += "G5.2 X" + at() + " Y" + at() + " P1 L3\nX" + at() + " Y" + at() + " P2\nX" + at() +
              " Y" + at() + " P1\nG5.3\n";
  }
  return text;
}

/// A program that is in its first place, then moves, and the same under `codes`.
void check_property(const std::string& codes, const std::string& cancel, const Map& map,
                    unsigned seed) {
  std::mt19937 random(seed);
  for (int i = 0; i < 20; ++i) {
    const std::string program = random_program(random);
    INFO(codes << "\n" << program);
    auto plain = moves_of("F100\n" + program + "M30\n");
    auto moves = moves_of("F100\n" + codes + "\n" + program + cancel + "\nM30\n");
    check_joined(moves);
    plain.erase(plain.begin());  // from where the tool was
    moves.erase(moves.begin());
    check_images(moves, plain, map);
  }
}

}  // namespace

TEST_CASE("G68 turns the plane about its centre", "[ipr][transformation]") {
  check_ends("F100\nG68 X0 Y0 R90\nG1 X10\nG69\nG1 X10 Y0", {{0, 10, 0}, {10, 0, 0}});
  check_ends(std::string("F100\nG68 X0 Y0 ") + kAngle345 + "\nG1 X10\nX0 Y10 Z2",
             {{8, 6, 0}, {-6, 8, 2}});
  check_ends("F100\nG68 X10 Y5 R180\nG1 X0 Y0", {{20, 10, 0}});
  check_ends("F100\nG68 X10 Y5 R-90\nG1 X10 Y15", {{20, 5, 0}});
  check_ends("F100 G20\nG68 X1 Y0 R90\nG1 X2 Y0", {{25.4, 25.4, 0}});
  check_ends("F100 G18\nG68 X0 Z0 R90\nG1 Z10 Y3", {{10, 3, 0}});
  check_ends("F100 G19\nG68 Y0 Z0 R90\nG1 Y10 X3", {{3, 0, 10}});
}

TEST_CASE("the centre of G68 is the position where it is not written", "[ipr][transformation]") {
  check_ends("F100\nG0 X10 Y20\nG68 R90\nG1 X15 Y20\nG68 R0\nG1 X10 Y20",
             {{10, 20, 0}, {10, 25, 0}, {10, 20, 0}});
  check_ends("F100\nG0 X10 Y20\nG68 Y0 R90\nG1 X15 Y0", {{10, 20, 0}, {10, 5, 0}});
}

TEST_CASE("no other work system is selected while coordinates are transformed",
          "[ipr][transformation]") {
  for (const char* code : {"G55", "G59.3", "G54.1 P5", "G154 P5", "G110", "G54 P3"}) {
    CAPTURE(code);
    const std::string text = "G68 X0. Y0. R90.\n" + std::string(code) + "\nM30\n";
    CHECK(places(interpret(text, {}, {.dialect = Dialect::fanuc})) == Places{"SC2251 2:1"});
  }
  CHECK(places(interpret("G68 X0. Y0. R90.\nG54\nM30\n")).empty());
}

TEST_CASE("in G91 moves turn, and R adds to the angle before", "[ipr][transformation]") {
  check_ends("F100\nG0 X3 Y4\nG91 G68 X0 Y0 R90\nG1 X10", {{3, 4, 0}, {3, 14, 0}});
  check_ends("F100\nG91 G68 X0 Y0 R30\nG68 X0 Y0 R60\nG1 X10", {{0, 10, 0}});
  check_ends("F100\nG68 X0 Y0 R30\nG68 X0 Y0 R60\nG1 X10 Y0",
             {{5, 10 * std::sin(std::numbers::pi / 3), 0}});
}

TEST_CASE("a change of the transformation moves nothing", "[ipr][transformation]") {
  const auto moves = moves_of(
      "F100\nG0 X7 Y3 Z1\nG68 X1 Y2 R33\nG91 G1 X1\nG69\nG1 X1\nG51 X3 Y4 Z5 P1.7\nG1 Y1\n"
      "G50\nG51.1 X2\nG1 X1\nG50.1\nG1 X1\nM30\n");
  REQUIRE(moves.size() == 6);
  check_joined(moves);
  CHECK(near(end(moves[2].path) - start(moves[2].path), {1, 0, 0}));
  CHECK(near(end(moves[3].path) - start(moves[3].path), {0, 1.7, 0}));
  CHECK(near(end(moves[4].path) - start(moves[4].path), {-1, 0, 0}));
  CHECK(near(end(moves[5].path) - start(moves[5].path), {1, 0, 0}));
}

TEST_CASE("G51 scales from its centre, and P counts thousandths without a point",
          "[ipr][transformation]") {
  check_ends("F100\nG51 X0 Y0 Z0 P2000\nG1 X10 Z3\nG50\nG1 X10", {{20, 0, 6}, {10, 0, 6}});
  check_ends("F100\nG51 X10 Y10 Z10 P0.5\nG1 X0 Y0 Z0", {{5, 5, 5}});
  check_ends("F100\n#1=2000\nG51 X0 Y0 Z0 P#1\nG1 X10", {{20, 0, 0}});
  check_ends("F100\nG51 X0 Y0 Z0 P[1.5*1000]\nG1 X10", {{15, 0, 0}});
  check_ends("F100\nG51 X0 Y0 Z0 I2. J3000 K.5\nG1 X10 Y10 Z10", {{20, 30, 5}});
  check_ends("F100\nG51 X0 Y0 Z0 J-1.\nG1 X10 Y10 Z10", {{10, -10, 10}});
  check_ends("F100\nG0 X10\nG51 P2.\nG1 X15 Y1", {{10, 0, 0}, {20, 2, 0}});
}

TEST_CASE("G51.1 mirrors the axes named, G50.1 ends it for those named", "[ipr][transformation]") {
  check_ends("F100\nG51.1 X5\nG1 X10 Y1\nG51.1 Y0\nG1 X10 Y1\nG50.1 X0\nG1 X10 Y1\nG50.1\nY1",
             {{0, 1, 0}, {0, -1, 0}, {10, -1, 0}, {10, 1, 0}});
}

TEST_CASE("the order is mirror, scale, rotation, and the centres go with what is before",
          "[ipr][transformation]") {
  // B-63944EN-2/02, page 211: scaled first, then turned; the centre of the rotation is scaled too.
  check_ends("F100\nG51 X0 Y0 Z0 I2. J1.\nG68 X10 Y0 R90\nG1 X15 Y0", {{20, 10, 0}});
  // Siemens, ISO Milling, 3.2: under a mirror of one axis turns go the other way round.
  check_ends("F100\nG51.1 X0\nG68 X10 Y0 R90\nG1 X15 Y0", {{-10, 5, 0}});
  check_ends("F100\nG51.1 X0 Y0\nG68 X10 Y0 R90\nG1 X15 Y0", {{-10, -5, 0}});
  check_ends("F100\nG51.1 X0\nG51 X10 Y0 Z0 P2.\nG1 X15 Y1", {{-20, 2, 0}});
}

TEST_CASE("G51.1 and a scale of -1 cancel each other", "[ipr][transformation]") {
  std::mt19937 random(4);
  for (int i = 0; i < 5; ++i) {
    const std::string program = random_program(random);
    INFO(program);
    check_images(moves_of("F100\nG51.1 X7\nG51 X7 Y0 Z0 I-1.\n" + program + "M30\n"),
                 moves_of("F100\n" + program + "M30\n"), [](const AxisVector& p) { return p; });
  }
}

TEST_CASE("a program under a transformation is the image of the program", "[ipr][transformation]") {
  check_property("G68 X3 Y-8 R25", "G69", rotation(25, 3, -8), 1);
  check_property(
      "G51 X3 Y-8 Z2 P1.25", "G50",
      [](const AxisVector& p) {
        const AxisVector center(3, -8, 2);
        return AxisVector(center + 1.25 * (p - center));
      },
      2);
  check_property(
      "G51.1 Y4", "G50.1", [](const AxisVector& p) { return AxisVector(p[0], 8 - p[1], p[2]); }, 3);
  check_property(
      "G10 L2 P1 X5 Y6 Z7\nG54 G68 X3 Y-8 R25", "G69",
      [](const AxisVector& p) {
        const AxisVector origin(5, 6, 7);
        return AxisVector(origin + rotation(25, 3, -8)(p));
      },
      5);
  check_property(
      "G10 L2 P1 R40\nG54 G51 X0 Y0 Z0 I-1.", "G50",
      [](const AxisVector& p) { return rotation(40, 0, 0)(AxisVector(-p[0], p[1], p[2])); }, 6);
}

TEST_CASE("a mirror turns arcs the other way round", "[ipr][transformation]") {
  const auto moves = moves_of("F100\nG51.1 X0\nG2 X10 Y10 I10 J0\nM30\n");
  REQUIRE(moves.size() == 1);
  const auto& arc = std::get<Arc>(moves[0].path);
  CHECK(arc.ccw());
  CHECK(near(arc.to(), {-10, 10, 0}));
  CHECK(near(arc.center(), {-10, 0, 0}));
}

TEST_CASE("an arc by its radius gets its centre before it is scaled", "[ipr][transformation]") {
  const auto moves = moves_of("F100\nG51 X0 Y0 Z0 P3.\nG3 X10 Y10 R10\nM30\n");
  const auto& arc = std::get<Arc>(moves.at(0).path);
  CHECK(near(arc.center(), {0, 30, 0}));
  CHECK(arc.radius() == Approx(30));
}

TEST_CASE("turns of arcs stay whole under any rotation", "[ipr][transformation]") {
  for (int degrees = 1; degrees < 360; degrees += 7) {
    const auto moves = moves_of("F100\nG0 X11.3 Y7.7\nG68 X1.1 Y2.3 R" + std::to_string(degrees) +
                                "\nG1 X5.1 Y3.7\nG2 I3.3 J1.7 Z1 P2\nM30\n");
    REQUIRE(moves.size() == 3);
    CHECK(std::get<Arc>(moves[2].path).sweep() == Approx(-4 * std::numbers::pi));
  }
}

TEST_CASE("under unequal scales a circle is the ellipse exactly", "[ipr][transformation]") {
  const auto moves = moves_of("F100\nG51 X0 Y0 Z0 I2. J1.\nG0 X10\nG3 X10 I-10 J0\nM30\n");
  REQUIRE(moves.size() == 2);
  const Path& path = moves[1].path;
  REQUIRE(std::holds_alternative<Nurbs>(path));
  double turned = 0, before = 0;
  for (int i = 1; i <= 400; ++i) {
    const AxisVector p = point(path, i / 400.0);
    CHECK(p[0] * p[0] / 400 + p[1] * p[1] / 100 == Approx(1).margin(1e-12));
    const double angle = std::atan2(p[1] / 10, p[0] / 20);
    turned += std::remainder(angle - before, 2 * std::numbers::pi);
    before = angle;
  }
  CHECK(turned == Approx(2 * std::numbers::pi));
  const auto breaks = std::get<Nurbs>(path).breaks();
  for (const double s : breaks)
    CHECK(near(at(path, s, Side::before).dq, at(path, s, Side::after).dq, 1e-9));
}

TEST_CASE("under unequal scales a helix rises with its angle", "[ipr][transformation]") {
  const auto moves =
      moves_of("F100\nG51 X0 Y0 Z0 I2. J1. K3.\nG0 X10\nG3 X10 I-10 J0 Z4 P3\nM30\n");
  REQUIRE(moves.size() == 2);
  const Path& path = moves[1].path;
  double turned = 0, before = 0;
  for (int i = 1; i <= 5000; ++i) {
    const AxisVector p = point(path, i / 5000.0);
    CHECK(p[0] * p[0] / 400 + p[1] * p[1] / 100 == Approx(1).margin(1e-11));
    const double angle = std::atan2(p[1] / 10, p[0] / 20);
    turned += std::remainder(angle - before, 2 * std::numbers::pi);
    before = angle;
    CHECK(p[2] == Approx(12 * turned / (6 * std::numbers::pi)).margin(1.2e-5));
  }
}

TEST_CASE("an arc that ends a little off its circle does so under unequal scales",
          "[ipr][transformation]") {
  const auto moves = moves_of("F100\nG51 X0 Y0 Z0 I2. J1.\nG0 X10\nG3 X0 Y10.02 I-10 J0\nM30\n");
  const Path& path = moves.at(1).path;
  CHECK(near(end(path), {0, 10.02, 0}));
  for (int i = 0; i <= 100; ++i) {
    const AxisVector p = point(path, i / 100.0);
    const double angle = std::atan2(p[1], p[0] / 2);
    CHECK(std::hypot(p[0] / 2, p[1]) ==
          Approx(10 + 0.02 * angle / (std::numbers::pi / 2)).margin(1e-3));
  }
}

TEST_CASE("a path under unequal scales is the image by its parameter", "[ipr][transformation]") {
  std::mt19937 random(9);
  for (int i = 0; i < 10; ++i) {
    const std::string program = random_program(random);
    INFO(program);
    const auto plain = moves_of("F100\n" + program + "M30\n");
    const auto moves =
        moves_of("F100\nG51 X1 Y2 Z3 I2. J-.5 K1.5\nG68 X4 Y5 R70\n" + program + "M30\n");
    check_joined(moves);
    REQUIRE(moves.size() == plain.size());
    const Map turn = rotation(-70, 7, 0.5);
    const Map map = [&](const AxisVector& p) {
      return turn({1 + 2 * (p[0] - 1), 2 - 0.5 * (p[1] - 2), 3 + 1.5 * (p[2] - 3)});
    };
    for (std::size_t k = 1; k < moves.size(); ++k) {
      const bool arc = std::holds_alternative<Arc>(plain[k].path);
      for (const double part : {0.0, 0.3, 0.5, 1.0}) {
        if (arc && part == 0.3) continue;  // an arc has its length, its image a parameter
        const double off = arc ? 2e-5 : 1e-7;
        CHECK(near(point(moves[k].path, part), map(point(plain[k].path, part)), off));
      }
    }
  }
}

TEST_CASE("the feed is that along the transformed path", "[ipr][transformation]") {
  const auto moves = moves_of("G93\nG51 X0 Y0 Z0 P3.\nG1 X10 F2\nM30\n");
  CHECK(moves.at(0).feed == Approx(30 * 2 / 60.0));
}

TEST_CASE("a compensated contour turns with its program", "[ipr][transformation]") {
  const std::string contour =
      "G0 X-10 Y-10\nG41.1 D4\nG1 X0 Y0\nY20\nG2 X20 Y20 I10 J0\nG1 Y0\nX0\nG40 G0 X-10 Y-10\n";
  const auto plain = moves_of("F100\n" + contour + "M30\n");
  const auto turned = moves_of("F100\nG68 X3 Y4 R50\n" + contour + "G69\nM30\n");
  check_joined(turned);
  check_images({turned.begin() + 1, turned.end()}, {plain.begin() + 1, plain.end()},
               rotation(50, 3, 4));
  const auto mirrored = moves_of("F100\nG51.1 X5\n" + contour + "G50.1\nM30\n");
  check_images({mirrored.begin() + 1, mirrored.end()}, {plain.begin() + 1, plain.end()},
               [](const AxisVector& p) { return AxisVector(10 - p[0], p[1], p[2]); });
}

TEST_CASE("the radius of the tool is not scaled", "[ipr][transformation]") {
  const auto moves = moves_of(
      "F100\nG51 X0 Y0 Z0 P2.\nG0 X-10 Y-10\nG41.1 D4\nG1 X0 Y0\nY20\nG40 G0 X-10 Y20\nM30\n");
  CHECK(near(end(moves.at(2).path), {-2, 40, 0}));
}

TEST_CASE("G68 may begin and end within a compensated contour", "[ipr][transformation]") {
  // FANUC: the contour is turned, then compensated. Here it is a square corner further on.
  const std::string before = "F100\nG0 X-10 Y0\nG41.1 D4\nG1 X0 Y0\n";
  const auto turned = moves_of(before + "G68 X0 Y0 R90\nG1 X20 Y0\nG69\nG1 X-20 Y20\nG40\nM30\n");
  const auto plain = moves_of(before + "G1 X0 Y20\nG1 X-20 Y20\nG40\nM30\n");
  check_images(turned, plain, [](const AxisVector& p) { return p; });
}

TEST_CASE("a move after G40 begins beside the turned contour", "[ipr][transformation]") {
  const auto moves =
      moves_of("F100\nG68 X0 Y0 R90\nG0 X-10 Y0\nG41.1 D4\nG1 X0 Y0\nX20\nG40\nG1 X30 Y10\nM30\n");
  REQUIRE(moves.size() == 4);
  check_joined(moves);
  CHECK(near(start(moves[3].path), {-2, 20, 0}));
  CHECK(near(end(moves[3].path), {-10, 30, 0}));
}

TEST_CASE("cycles turn and scale with the program, but pecks do not", "[ipr][transformation]") {
  check_ends("F100\nG0 Z10\nG68 X0 Y0 R90\nG81 X10 Y0 Z-2 R1",
             {{0, 0, 10}, {0, 10, 10}, {0, 10, 1}, {0, 10, -2}, {0, 10, 1}});
  const auto drilled = ends("F100\nG0 Z10\nG51 X0 Y0 Z0 P2.\nG83 X5 Y0 Z-2 R1 Q3");
  std::vector<double> heights;
  for (const AxisVector& at : drilled) heights.push_back(at[2]);
  CHECK(heights.size() == 8);
  CHECK(near({heights.at(3), heights.at(4), heights.at(5)}, {-1, 2, -0.746}));
  CHECK(near({heights.at(6), heights.at(7), drilled.at(7)[0]}, {-4, 2, 10}));
}

TEST_CASE("positions as variables: programmed, and of the machine", "[ipr][transformation]") {
  CHECK(near(last_place("F100\nG68 X0 Y0 R90\nG1 X10\nG69\nG0 X#5001 Y#5041 Z#5022\nM30\n", kFanuc),
             {0, 0, 10}, 1e-9));
  CHECK(near(last_place("F100\nG68 X0 Y0 R90\nG1 X10\n#100=#5001\n#101=#5041\n#102=#5042\n"
                        "#103=#5022\nG69\nG0 X#100 Y#101\nZ[#102+#103]\nM30\n",
                        kFanuc),
             {10, 0, 20}));
  CHECK(near(last_place("F100\nG51.1 X0\nG51 X0 Y0 Z0 P2.\nG68 X0 Y0 R1\nG16\n#100=#4011\n"
                        "#101=#4016\n#102=#4017\n#103=#4022\nG15 G69 G50\nG50.1\n"
                        "G0 X#100 Y#101 Z[#102+#103]\nM30\n",
                        kFanuc),
             {51, 68, 67.1}));
  CHECK(near(last_place("G0 X#4011 Y#4016 Z[#4017+#4022]\nM30\n", kFanuc), {50, 69, 65.1}));
}

TEST_CASE("M70 and M73 save what is transformed", "[ipr][transformation]") {
  check_ends("F100\nG68 X0 Y0 R90\nM70\nG69\nG1 X10\nM72\nG1 X10 Y0\nG16 X10 Y90\nM72\nX10 Y0",
             {{10, 0, 0}, {0, 10, 0}, {-10, 0, 0}, {0, 10, 0}});
  check_ends("F100\no1 call\nG1 X10\no1 sub\nM73\nG68 X0 Y0 R90\nG1 X5\no1 endsub",
             {{0, 5, 0}, {10, 5, 0}});
  const auto spline = moves_of(
      "F100\no1 call\nG1 X0 Y0\no1 sub\nM73\nG68 X0 Y0 R90\nG6.1 X5\nX10\no1 endsub\nM30\n");
  CHECK(near(end(spline.at(0).path), {0, 10, 0}));
}

TEST_CASE("an offset may change under a transformation only where it moves nothing",
          "[ipr][transformation]") {
  check_ends("F100\nG68 X0 Y0 R90\nG54\nG43.1 Z5\nG1 X10 Z0", {{0, 10, 5}});
  check_ends("F100\nG68 X0 Y0 R90\nG1 X10\nG28.1\nG69\nG28", {{0, 10, 0}});
}

TEST_CASE("what must not act while coordinates are transformed", "[ipr][transformation]") {
  for (const char* code : {"G28", "G30", "G52 X1", "G53 G0 X1", "G55", "G92 X1", "G92.1", "G18",
                           "G10 L2 P1 X1", "G10 L20 P2 X1"}) {
    INFO(code);
    const std::string line = code;
    CHECK(reported("F100\nG68 X0 Y0 R90\n" + line) == Places{"SC2251 3:1"});
    if (line != "G18") {
      CHECK(reported("F100\nG51 X0 Y0 Z0 P2.\n" + line) == Places{"SC2251 3:1"});
      CHECK(reported("F100\nG51.1 X0\n" + line) == Places{"SC2251 3:1"});
    }
    CHECK(reported("F100\nG68 X0 Y0 R90\nG69\n" + line).empty());
  }
  CHECK(reported("G51 P2.\nG18\nG10 L2 P2 X1").empty());
}

TEST_CASE("transformations are put in force in their order", "[ipr][transformation]") {
  CHECK(reported("G68 R1\nG51 P2.") == Places{"SC2254 2:1"});
  CHECK(reported("G68 R1\nG51.1 X0") == Places{"SC2254 2:1"});
  CHECK(reported("G51 P2.\nG51.1 X0") == Places{"SC2254 2:1"});
  CHECK(reported("G51.1 X0\nG51 P2.\nG50.1 X0") == Places{"SC2254 3:1"});
  CHECK(reported("G51.1 X0\nG51 P2.\nG68 R1\nG69\nG50\nG50.1").empty());
  CHECK(reported("G17 G40 G49 G50 G69 G80 G90 G15").empty());
}

TEST_CASE("the words of G68, G51 and G51.1", "[ipr][transformation]") {
  CHECK(reported("G68 X0 Y0 Z0 I0 J0 K1 R30") == Places{"SC2250 1:14"});
  CHECK(reported("G68 X0 Y0") == Places{"SC2005 1:1"});
  CHECK(reported("G68 X0 Y0 Z1 R3") == Places{"SC2004 1:11"});
  CHECK(reported("G51 X0") == Places{"SC2005 1:1"});
  CHECK(reported("G51 X0 P2. I1.") == Places{"SC2004 1:8"});
  CHECK(reported("G51 X0 P0") == Places{"SC2252 1:8"});
  CHECK(reported("G51 X0 P20000.") == Places{"SC2252 1:8"});
  CHECK(reported("G51 X0 P2") == Places{"SC2253 1:8"});
  CHECK(reported("G51.1") == Places{"SC2005 1:1"});
  CHECK(reported("F9 G68 X0 Y0 R90 G1 X3") == Places{"SC2110 1:18"});
}

TEST_CASE("arcs and cycles that the scales leave without a meaning", "[ipr][transformation]") {
  CHECK(reported("F100\nG51 X0 Y0 Z0 I2. J1.\nG41.1 D4\nG1 X20\nG3 X30 Y10 I0 J10\nG40") ==
        Places{"SC2256 5:1"});
  CHECK(reported("F100\nG51 X0 Y0 Z0 K-1.\nG81 X1 Z-1 R1") == Places{"SC2257 3:1"});
  CHECK(reported("F100\nG51 X0 Y0 Z0 I2. J1.\nG3 X0 Y0 I1 J0 Z900 P10000") == Places{"SC3130 3:1"});
  CHECK(reported("F100\nG51 X0 Y0 Z0 P1000.\nG1 X2000") == Places{"SC3008 3:1"});
}

TEST_CASE("codes within cutter compensation that change the scales", "[ipr][transformation]") {
  const std::string begin = "F100\nG41.1 D4\nG1 X20\n";
  CHECK(reported(begin + "G51 P2.") == Places{"SC2140 4:1"});
  CHECK(reported(begin + "G51.1 X0") == Places{"SC2140 4:1"});
  CHECK(reported("G51 P2.\n" + begin + "G50") == Places{"SC2140 5:1"});
  CHECK(reported("G51 P2.\n" + begin + "G68 R4") == Places{"SC2140 5:1"});
  CHECK(reported("G51.1 X0\n" + begin + "G50.1") == Places{"SC2140 5:1"});
  CHECK(reported(begin + "G50 G69").empty());
}

TEST_CASE("a transformation with an unknown word reports nothing later", "[ipr][transformation]") {
  CHECK(reported("F100\nG68 X0 Y0 R#<a>\nG1 X10\nG2 X20 Y0 I1 J0") == Places{"SC1024 2:12"});
  CHECK(reported("F100\nG68 X0 Y0 R#<a>\nG69\nG1 X10 Y0\nG2 X20 Y0 I1 J0") ==
        Places{"SC1024 2:12", "SC2103 5:4"});
  CHECK(reported("F100\nG51 X0 Y0 P#<a>\nG50\nG1 X10 Y0 Z0\nG2 X20 Y0 I1 J0") ==
        Places{"SC1024 2:12", "SC2103 5:4"});
  CHECK(reported("F100\nG51.1 X#<a>\nG92 X0\nG1 X10") == Places{"SC1024 2:8"});
  CHECK(reported("F100\nG1 X#<a>\nG68 R90\nG1 X10 Y0\nG2 X20 Y0 I1 J0") == Places{"SC1024 2:5"});
}

}  // namespace softcnc::ipr
