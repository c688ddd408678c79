// SPDX-License-Identifier: MIT
// ,C and ,R against closed forms: tangent points of lines and circles, and what makes them so.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"

namespace softcnc::ipr {
namespace {

Machine corner_mill() {
  Machine machine;
  machine.tools[1].radius = 2;
  return machine;
}

std::vector<Move> rounded_moves(const std::string& text) {
  return moves_of("F600\n" + text + "\nM30\n", corner_mill());
}

/// Ends of the moves; of an arc its centre stands after its end.
Ends rounded_ends(const std::string& text) {
  Ends all;
  AxisVector position = AxisVector::Zero();
  for (const Move& move : rounded_moves(text)) {
    CHECK(near(start(move.path), position));
    all.push_back(position = end(move.path));
    if (const auto* arc = std::get_if<Arc>(&move.path)) all.push_back(arc->center());
  }
  return all;
}

void check_rounded(const std::string& text, const Ends& expected) {
  INFO(text);
  const Ends all = rounded_ends(text);
  REQUIRE(all.size() == expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(i << ": " << all[i].transpose());
    CHECK(near(all[i], expected[i]));
  }
}

Places reported_of_corners(const std::string& text, Dialect dialect = Dialect::linuxcnc) {
  return reported("F600\n" + text, dialect, corner_mill());
}

std::string message_of(const std::string& text) {
  const Interpreted result = interpret("F600\n" + text + "\nM30\n", corner_mill());
  REQUIRE(result.diagnostics.size() == 1);
  return result.diagnostics.front().message;
}

AxisVector direction_at_start(const Path& path) { return at(path, 0).dq; }
AxisVector direction_at_end(const Path& path) { return at(path, length(path), Side::before).dq; }

}  // namespace

TEST_CASE("a rounding of a right angle takes its radius off both lines", "[ipr][corners]") {
  check_rounded("G01 X20 ,R5\nY30", {{15, 0, 0}, {20, 5, 0}, {15, 5, 0}, {20, 30, 0}});
  check_rounded("G01 X20 ,R5\nY-30", {{15, 0, 0}, {20, -5, 0}, {15, -5, 0}, {20, -30, 0}});
  const auto arc = std::get<Arc>(rounded_moves("G01 X20 ,R5\nY-30")[1].path);
  CHECK_FALSE(arc.ccw());
  CHECK(arc.turns() == 0);
}

TEST_CASE("a chamfer takes its distance off both lines, whatever the angle", "[ipr][corners]") {
  check_rounded("G01 X20 ,C5\nY30", {{15, 0, 0}, {20, 5, 0}, {20, 30, 0}});
  const double root = std::sqrt(0.5);
  check_rounded("G01 X20 ,C4\nX30 Y10", {{16, 0, 0}, {20 + 4 * root, 4 * root, 0}, {30, 10, 0}});
}

TEST_CASE("a rounding of any angle takes radius times tangent of half the turn", "[ipr][corners]") {
  for (const double degrees : {2.0, 30.0, 90.0, 135.0, -60.0, -170.0}) {
    const double turn = degrees * std::numbers::pi / 180, radius = 3;
    const AxisVector along(std::cos(turn), std::sin(turn), 0);
    const AxisVector to = AxisVector(100, 0, 0) + 100 * along;
    const std::string text = "G01 X100 ,R3\nX[" + std::to_string(100.0) + "+100*COS[" +
                             std::to_string(degrees) + "]] Y[100*SIN[" + std::to_string(degrees) +
                             "]]";
    const double cut = radius * std::tan(std::abs(turn) / 2);
    check_rounded(text, {{100 - cut, 0, 0},
                         AxisVector(100, 0, 0) + cut * along,
                         {100 - cut, std::copysign(radius, turn), 0},
                         to});
  }
}

TEST_CASE("the piece has the feed of the line that asks for it", "[ipr][corners]") {
  const auto all = rounded_moves("G01 X20 F1200 ,R5\nY30 F300");
  REQUIRE(all.size() == 3);
  CHECK(all[0].feed == Approx(20));
  CHECK(all[1].feed == Approx(20));
  CHECK(all[2].feed == Approx(5));
  CHECK_FALSE(all[1].rapid);
}

TEST_CASE("corners in a row share the moves between them", "[ipr][corners]") {
  check_rounded("G01 X20 ,R5\nY30 ,C5\nX0 ,R5\nY0", {{15, 0, 0},
                                                     {20, 5, 0},
                                                     {15, 5, 0},
                                                     {20, 25, 0},
                                                     {15, 30, 0},
                                                     {5, 30, 0},
                                                     {0, 25, 0},
                                                     {5, 25, 0},
                                                     {0, 0, 0}});
}

TEST_CASE("moves that are used up by their corners vanish", "[ipr][corners]") {
  check_rounded("G01 X10 ,R5\nY10 ,R5\nX0",
                {{5, 0, 0}, {10, 5, 0}, {5, 5, 0}, {5, 10, 0}, {5, 5, 0}, {0, 10, 0}});
  check_rounded("G01 X10 ,C10\nY10", {{10, 10, 0}});
}

TEST_CASE("words of the same letters without the comma keep their meaning", "[ipr][corners]") {
  check_rounded("G02 X20 Y0 R10 ,R0\nG01 X30", {{20, 0, 0}, {10, 0, 0}, {30, 0, 0}});
  check_rounded("#1=5\nG01 X20 ,R#1\nY30", {{15, 0, 0}, {20, 5, 0}, {15, 5, 0}, {20, 30, 0}});
}

TEST_CASE("a line and an arc are rounded by a circle that touches both", "[ipr][corners]") {
  // The line along Y = 0 to (10, 0), then the half circle about (10, 10) from its lowest point is
  // tangent: no piece.
  check_rounded("G01 X10 ,R2\nG03 Y20 J10", {{10, 0, 0}, {10, 20, 0}, {10, 10, 0}});
  // The line to (16, 0), then counter-clockwise about (10, 8): R = 10, left of both by 2.
  const double x = 10 + std::sqrt(8.0 * 8 - 6 * 6);
  const AxisVector center(x, 2, 0);
  const AxisVector touch = AxisVector(10, 8, 0) + (center - AxisVector(10, 8, 0)) * 10 / 8;
  check_rounded("G01 X16 ,R2\nG03 X10 Y18 I-6 J8",
                {{x, 0, 0}, touch, center, {10, 18, 0}, {10, 8, 0}});
}

TEST_CASE("a rounding may lie outside of its arc, and the arc have a chamfer at its end",
          "[ipr][corners]") {
  // The moves are those of an example in NCT's manual of the 2000M, section 16.1. The centre of the
  // rounding lies 22 above the line and 40 + 22 from the centre of the arc, (20, 40).
  const AxisVector middle(20, 40, 0), center(20 + std::sqrt(62.0 * 62 - 22 * 22), 62, 0);
  const AxisVector touch = middle + (center - middle) * 40 / 62;
  const double angle = std::numbers::pi / 2 - 2 * std::asin(10.0 / 80);
  check_rounded("G00 X100\nG01 Y40 ,C10\nX60 ,R22\nG03 X20 Y80 R40 ,C10\nG01 Y110",
                {{100, 0, 0},
                 {100, 30, 0},
                 {90, 40, 0},
                 {center.x(), 40, 0},
                 touch,
                 center,
                 {20 + 40 * std::cos(angle), 40 + 40 * std::sin(angle), 0},
                 middle,
                 {20, 90, 0},
                 {20, 110, 0}});
}

TEST_CASE("an arc and a line are chamfered at equal straight distances", "[ipr][corners]") {
  const auto all = rounded_moves("G02 X10 Y10 I10 ,C3\nG01 Y-20");
  REQUIRE(all.size() == 3);
  const AxisVector corner(10, 10, 0);
  CHECK((end(all[0].path) - corner).norm() == Approx(3));
  CHECK((start(all[2].path) - corner).norm() == Approx(3));
  CHECK((end(all[0].path) - AxisVector(10, 0, 0)).norm() == Approx(10));
  CHECK(near(end(all[1].path), {10, 7, 0}));
}

TEST_CASE("corners lie in the plane in force", "[ipr][corners]") {
  check_rounded("G18 G01 Z20 ,R5\nX30", {{0, 0, 15}, {5, 0, 20}, {5, 0, 15}, {30, 0, 20}});
  check_rounded("G19 G01 Y20 ,C5\nZ30", {{0, 15, 0}, {0, 20, 5}, {0, 20, 30}});
}

TEST_CASE("corners count in inches, in G91 and in turned work systems", "[ipr][corners]") {
  check_rounded("G20 G01 X2 F20 ,R1\nY2",
                {{25.4, 0, 0}, {50.8, 25.4, 0}, {25.4, 25.4, 0}, {50.8, 50.8, 0}});
  check_rounded("G91 G01 X20 ,C5\nY30", {{15, 0, 0}, {20, 5, 0}, {20, 30, 0}});
  check_rounded("G10 L2 P1 R90\nG01 X20 ,R5\nY30",
                {{0, 15, 0}, {-5, 20, 0}, {-5, 15, 0}, {-30, 20, 0}});
}

TEST_CASE("every rounding touches its neighbours and keeps its radius",
          "[ipr][corners][property]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-40, 40), part(0.05, 0.45);
  int rounded = 0;
  for (int i = 0; i < 300; ++i) {
    const double radius = 20 * part(random);
    const bool arc_first = i % 3 == 1, arc_after = i % 2 == 1;
    const auto number = [](double value) { return std::to_string(value); };
    const auto arc = [&](double x, double y) {
      return "G0" + std::string(i % 4 < 2 ? "2" : "3") + " X" + number(x) + " Y" + number(y) +
             " R" + number(90 + any(random));
    };
    const auto line = [&](double x, double y) { return "G01 X" + number(x) + " Y" + number(y); };
    const double x = any(random), y = any(random), x2 = any(random), y2 = any(random);
    const std::string text = "F600 G01 X50 Y50\n" + (arc_first ? arc(x, y) : line(x, y)) + " ,R" +
                             number(radius) + "\n" + (arc_after ? arc(x2, y2) : line(x2, y2)) +
                             "\nM30\n";
    const Interpreted result = interpret(text);
    if (!result.diagnostics.empty()) {
      CHECK(places(result).front().starts_with("SC2265 2:"));
      continue;
    }
    std::vector<Path> paths;
    for (const Block& block : result.blocks)
      if (const auto* move = std::get_if<Move>(&block.what)) paths.push_back(move->path);
    if (paths.size() != 4) continue;
    ++rounded;
    INFO(text);
    const auto* piece = std::get_if<Arc>(&paths[2]);
    REQUIRE(piece != nullptr);
    CHECK(piece->radius() == Approx(radius).margin(1e-5));
    for (const int joint : {1, 2}) {
      const auto& before = paths[static_cast<std::size_t>(joint)];
      const auto& after = paths[static_cast<std::size_t>(joint) + 1];
      CHECK(near(end(before), start(after)));
      CHECK(direction_at_end(before).dot(direction_at_start(after)) == Approx(1).margin(1e-9));
    }
  }
  CHECK(rounded > 100);
}

TEST_CASE("cutter compensation follows the contour with its corners", "[ipr][corners]") {
  const std::string contour = "T1 M06\nG00 X-20\nG41 G01 X0\n";
  check_rounded(
      contour + "X20 ,R5\nY30\nG40 X0",
      {{-20, 0, 0}, {0, 2, 0}, {15, 2, 0}, {18, 5, 0}, {15, 5, 0}, {18, 30, 0}, {0, 30, 0}});
  check_rounded(contour + "X20 ,C5\nY30\nG40 X0", {{-20, 0, 0},
                                                   {0, 2, 0},
                                                   {15 - 2 * std::tan(std::numbers::pi / 8), 2, 0},
                                                   {18, 5 + 2 * std::tan(std::numbers::pi / 8), 0},
                                                   {18, 30, 0},
                                                   {0, 30, 0}});
}

TEST_CASE("a rounding that the tool does not fit into is reported at its line", "[ipr][corners]") {
  const Interpreted result =
      interpret("T1 M06 F600\nG00 X-20\nG41 G01 X0\nX20 ,R1\nY30\nG40 X0\nM30\n", corner_mill());
  CHECK(places(result) == Places{"SC2145 4:1"});
  CHECK(result.diagnostics.front().source_line == "X20 ,R1");
}

TEST_CASE("what stands between the moves comes after the piece", "[ipr][corners]") {
  const auto blocks = blocks_of("F600\nG01 X20 ,R5\nG04 P1\nM08\nY30\nM30\n");
  REQUIRE(blocks.size() == 6);
  CHECK(std::holds_alternative<Move>(blocks[1].what));
  CHECK(std::holds_alternative<Dwell>(blocks[2].what));
  CHECK(std::holds_alternative<Action>(blocks[3].what));
  CHECK(blocks[1].source.line == 2);
  CHECK(blocks[4].source.line == 5);
}

TEST_CASE("a corner of one degree or less is left as it is", "[ipr][corners]") {
  check_rounded("G01 X20 ,R5\nX40", {{20, 0, 0}, {40, 0, 0}});
  check_rounded("G01 X20 ,C5\nX40 Y0.3", {{20, 0, 0}, {40, 0.3, 0}});
}

TEST_CASE("a corner needs a first move that it can shorten", "[ipr][corners]") {
  CHECK(reported_of_corners("G00 X10 ,R2\nG01 Y10") == Places{"SC2261 2:9"});
  CHECK(reported_of_corners("G01\n,R2\nX10") == Places{"SC2261 3:1"});
  CHECK(reported_of_corners("G81 X1 Z-1 R1 ,C2") == Places{"SC2261 2:15"});
  CHECK(reported_of_corners("G01 X0 ,C2\nX10") == Places{"SC2261 2:8"});
  CHECK(reported_of_corners("G01 X10 ,R-2\nY10") == Places{"SC2007 2:9"});
  CHECK(reported_of_corners("G01 X10 ,R2 ,C1\nY10") == Places{"SC2262 2:13"});
  CHECK(reported_of_corners("G01 X10 ,R2 ,R1\nY10") == Places{"SC2262 2:13"});
}

TEST_CASE("a corner needs a second move", "[ipr][corners]") {
  CHECK(reported_of_corners("G01 X10 ,R2") == Places{"SC2263 2:9"});
  CHECK(reported_of_corners("G01 X10 ,R2\nG00 Y10") == Places{"SC2263 2:9"});
  CHECK(reported_of_corners("G01 X10 ,R2\nG28") == Places{"SC2263 2:9"});
  CHECK(reported_of_corners("G01 X10 ,R2\nG81 X1 Z-1 R1") == Places{"SC2263 2:9"});
  CHECK(reported_of_corners("G01 X10 ,R2\nG06.1 X20\nY20\nG80") == Places{"SC2263 2:9"});
  CHECK(reported_of_corners("T1 M06\nG01 X10 ,R2\nG41 Y20\nY30") == Places{"SC2263 3:9"});
  CHECK(places(interpret("F600\nG01 X10 ,R2\n")) == Places{"SC2263 2:9", "SC2205 2:0"});
  CHECK(message_of("G01 X10 ,R2\nG00 Y10") == ",R2: G00 follows, and not G01, G02 or G03");
}

TEST_CASE("a corner without a number, or on the last line, loses no move", "[ipr][corners]") {
  for (const char* line : {"X1,R", "X1,RX", "X1,C", "G01 X10,R", "D11,RG16", ",R"}) {
    CAPTURE(line);
    CHECK(reported_of_corners(line).size() == 1);
  }
  CHECK(places(interpret("F600\nG01 X10 ,R1 M30\n")) == Places{"SC2263 2:9"});
  const auto both = interpret("F600\nG01 X10 ,R1\nY5 M30\n");
  CHECK(both.diagnostics.empty());
  CHECK(both.blocks.size() == 4);
}

TEST_CASE("G51 makes chamfers and roundings larger", "[ipr][corners]") {
  const auto all = moves_of("F600\nG51 X0 Y0 P2.\nG01 X20 ,R5\nY20\nM30\n");
  CHECK(std::get<Arc>(all.at(1).path).radius() == Approx(10));
  CHECK(reported_of_corners("G51 X0 Y0 I2. J1. K1.\nG01 X20 ,R5\nY20") == Places{"SC2263 3:9"});
}

TEST_CASE("where a program breaks off, its last corner is not reported", "[ipr][corners]") {
  Machine machine;
  machine.program.block_limit = 10;
  const Interpreted result =
      interpret("F600\n#1=[#1+1]\no1 if [#1 LT 0]\nM2\no1 endif\nG91 G01 X10 ,R1\nM99\n", machine);
  for (const Diagnostic& diagnostic : result.diagnostics) CHECK(diagnostic.code == Code::SC2310);
  CHECK(result.diagnostics.size() == 1);
  CHECK(places(interpret("F600\nG91 G01 X10 ,R1\nM99\n")) == Places{"SC2172 3:1"});
}

TEST_CASE("both moves of a corner lie in its plane", "[ipr][corners]") {
  CHECK(reported_of_corners("G01 X10 ,R2\nZ10") == Places{"SC2264 2:9"});
  CHECK(reported_of_corners("G01 X10 Z1 ,R2\nY10") == Places{"SC2264 2:12"});
  CHECK(reported_of_corners("G01 X10 ,R2\nG18 Z10") == Places{"SC2264 2:9"});
  CHECK(reported_of_corners("G01 X10 ,R2\nG17 Y10") == Places{});
}

TEST_CASE("a corner without room is refused with its numbers", "[ipr][corners]") {
  CHECK(message_of("G01 X10 ,R12\nY30") ==
        ",R12: a rounding of radius 12 mm takes 12 mm off both moves, which are 10 mm and 30 mm "
        "long");
  CHECK(message_of("G01 X10 ,C12\nY30") ==
        ",C12: a chamfer of 12 mm does not fit on both moves, which are 10 mm and 30 mm long");
  CHECK(message_of("G01 X10 ,R1\nX0") ==
        ",R1: no arc of radius 1 mm touches both moves, which are 10 mm and 10 mm long");
  CHECK(message_of("G01 X10 ,C3\nX0") ==
        ",C3: the second move leads back to where the piece would begin");
  CHECK(reported_of_corners("G01 X10 ,C6\nY10 ,C6\nX0") == Places{"SC2265 3:5"});
  CHECK(reported_of_corners("G01 X10 ,C5\nY5 ,C1\nX0") == Places{"SC2265 3:4"});
}

TEST_CASE("an error after a corner leaves it", "[ipr][corners][unknown]") {
  CHECK(reported_of_corners("G01 X10 ,R2\nY1.2.3\nX30 ,R1\nY20") == Places{"SC1004 3:2"});
  CHECK(reported_of_corners("G01 X1.2.3 ,R2\nY10") == Places{"SC1004 2:6"});
  CHECK(reported_of_corners("G17 G18\nG01 X10 ,R2\nZ10") == Places{"SC2002 2:5"});
  CHECK(reported_of_corners("G01 G02\n,R2\nG01 Z10") == Places{"SC2002 2:5"});
  CHECK(reported_of_corners("G01 X10 ,R#1.2.3\nY10 ,R1\nX0").size() == 1);
}

}  // namespace softcnc::ipr
