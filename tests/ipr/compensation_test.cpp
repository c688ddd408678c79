// SPDX-License-Identifier: MIT
// Cutter compensation against numbers of LinuxCNC's rs274 (T1: radius 5 mm) and against distances.
#include "ipr/compensation/compensation.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "ipr/handlers/handlers.hpp"
#include "ipr/interpret.hpp"
#include "support/property.hpp"

namespace softcnc::ipr {
namespace {

Machine compensation_mill() {
  Machine machine;
  machine.tools[1].radius = 5;
  machine.tools[2].radius = 3;
  machine.tools[3].radius = -2;
  machine.tools[4].radius = 1.5;
  return machine;
}

std::vector<Move> compensated_moves(const std::string& text) {
  return moves_of("T1 M06 F100\n" + text + "\nM02\n", compensation_mill());
}

/// Ends of the moves; of an arc its centre, and its sense as the height (1: counter-clockwise),
/// stand after its end.
std::vector<AxisVector> compensated_ends(const std::string& text) {
  std::vector<AxisVector> all;
  AxisVector position = AxisVector::Zero();
  for (const Move& move : compensated_moves(text)) {
    CHECK((start(move.path) - position).norm() < 1e-9);
    all.push_back(position = end(move.path));
    if (const auto* arc = std::get_if<Arc>(&move.path))
      all.emplace_back(arc->center().x(), arc->center().y(), arc->ccw() ? 1 : -1);
  }
  return all;
}

void check_compensated(const std::string& text, const std::vector<AxisVector>& expected) {
  INFO(text);
  const std::vector<AxisVector> all = compensated_ends(text);
  REQUIRE(all.size() == expected.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    INFO(i << ": " << all[i].transpose());
    CHECK((all[i] - expected[i]).norm() < 1e-4);  // rs274 has 1e-4 inch of slack at corners
  }
}

Places reported_of_compensation(const std::string& text) {
  return places(interpret("T1 M06 F100\n" + text + "\nM02\n", compensation_mill()));
}

}  // namespace

TEST_CASE("the tool enters beside the end, goes round outside corners and cuts inside ones off",
          "[ipr][compensation]") {
  check_compensated("G41 G01 X10 Y10\nX30\nY40\nX0\nG40 X-20", {{6.46446609406, 13.5355339059, 0},
                                                                {10, 15, 0},
                                                                {10, 10, -1},
                                                                {25, 15, 0},
                                                                {25, 35, 0},
                                                                {0, 35, 0},
                                                                {-20, 40, 0}});
}

TEST_CASE("arcs are cut off at lines and at each other", "[ipr][compensation]") {
  check_compensated(
      "G41 G01 X10 Y10\nX30\nG02 X50 Y10 R12\nG02 X70 Y10 R12\nG03 X70 Y50 R30\nG03 X50 Y50 R11",
      {{6.46446609406, 13.5355339059, 0},
       {10, 15, 0},
       {10, 10, -1},
       {27.6037302307, 15, 0},
       {50, 17.1144775042, 0},
       {40, 3.36675041929, -1},
       {69.3333647939, 17.5754907443, 0},
       {60, 3.36675041929, -1},
       {66.2732200375, 46.6666666667, 0},
       {47.6393202250, 30, 1},
       {65.4545454545, 47.9170110477, 0},
       {70, 50, -1},
       {54.5454545455, 47.9170110477, 0},
       {60, 45.4174243050, 1}});
  check_compensated("G41 G01 X10 Y10\nG02 X30 Y10 I10 J0\nG01 X50\nG03 X60 Y20 J10\nG40 G01 X0 Y0",
                    {{5.16806546031, 12.2391332722, 0},
                     {34.1421356237, 15, 0},
                     {20, 10, -1},
                     {50, 15, 0},
                     {55, 20, 0},
                     {50, 20, 1},
                     {0, 0, 0}});
}

TEST_CASE("an arc as the first move ends beside its end in the same direction",
          "[ipr][compensation]") {
  check_compensated("G41 G03 X10 Y10 R10\nX30 R40", {{5, 10, 0},
                                                     {-7.5, 10, 1},
                                                     {11.25, 14.8412291828, 0},
                                                     {10, 10, -1},
                                                     {28.75, 14.8412291828, 0},
                                                     {20, 48.7298334621, 1}});
  check_compensated("G41 G02 X10 Y0 R10\nG01 X30",
                    {{11.0472717803, 5, 0}, {8.125, -3.24759526419, -1}, {30, 5, 0}});
}

TEST_CASE("a tool of negative radius runs on the other side", "[ipr][compensation]") {
  check_compensated("G41 D3 G01 X10 Y10\nX30", {{10.8284271247, 8, 0}, {30, 8, 0}});
  check_compensated("G41.1 D-3 G01 X10 Y10\nX30", {{10.6213203436, 8.5, 0}, {30, 8.5, 0}});
  check_compensated("G42.1 D3 G01 X10 Y10\nX30", {{10.6213203436, 8.5, 0}, {30, 8.5, 0}});
  check_compensated("G42 G01 X10 Y10\nX30", {{12.0710678119, 5, 0}, {30, 5, 0}});
}

TEST_CASE("the diameter of G41.1 is in the units in force", "[ipr][compensation]") {
  check_compensated("G20\nG41.1 D1 G01 X1 Y0\nX2", {{25.4, 12.7, 0}, {50.8, 12.7, 0}});
}

TEST_CASE("what stands between two moves of the contour keeps its place", "[ipr][compensation]") {
  const auto blocks =
      blocks_of("T1 M06 F100\nG42 G01 X10 Y10\nX30\nZ-5\nG04 P1\nM03 S100\nF200 Y40\nM02\n",
                compensation_mill());
  REQUIRE(blocks.size() == 9);
  const auto move = [&](std::size_t i) { return std::get<Move>(blocks[i].what); };
  CHECK((end(move(2).path) - AxisVector(30, 5, 0)).norm() < 1e-9);
  CHECK((end(move(3).path) - AxisVector(30, 5, -5)).norm() < 1e-9);
  CHECK(std::get<Dwell>(blocks[4].what).duration == 1);
  CHECK(std::get<Action>(blocks[5].what).kind == Action::Kind::spindle);
  CHECK(std::holds_alternative<Arc>(move(6).path));
  CHECK(move(6).feed == Approx(200 / 60.0));
  CHECK(move(2).feed == Approx(100 / 60.0));
  CHECK(blocks[3].source.line == 4);
  CHECK(blocks[6].source.line == 7);
  CHECK((end(move(7).path) - AxisVector(35, 40, -5)).norm() < 1e-9);
  CHECK(std::get<Action>(blocks[8].what).kind == Action::Kind::end);
}

TEST_CASE("heights change evenly along the moves of the tool", "[ipr][compensation]") {
  check_compensated("G41 G01 X20\nX50 Z-3\nY40 Z-6\nX20 Z-7",
                    {{20, 5, 0}, {45, 5, -3}, {45, 35, -6}, {20, 35, -7}});
  const auto helix = compensated_moves("G41 G01 X20\nG03 X20 Y0 I0 J20 Z-10 \nG01 X40");
  const Arc& arc = std::get<Arc>(helix[1].path);
  CHECK(arc.radius() == Approx(15));
  CHECK(std::abs(arc.sweep()) == Approx(2 * std::numbers::pi));
  CHECK((end(helix[1].path) - AxisVector(20, 5, -10)).norm() < 1e-9);
}

TEST_CASE("a full circle keeps its turn on either side", "[ipr][compensation]") {
  for (const auto& [code, radius] : {std::pair("G41", 15.0), std::pair("G42", 25.0)}) {
    const auto circle =
        compensated_moves(std::string(code) + " G01 X33.3\nG03 I0 J20\nG40 G01 X0 Y50");
    const auto* arc = std::get_if<Arc>(&circle[circle.size() - 2].path);
    REQUIRE(arc != nullptr);
    CHECK(arc->radius() == Approx(radius));
    CHECK(arc->sweep() == Approx(2 * std::numbers::pi));
  }
}

TEST_CASE("rapids go beside the contour too, round corners as well", "[ipr][compensation]") {
  const auto all = compensated_moves("G41 G01 X30\nG00 X60\nY-20");
  REQUIRE(all.size() == 4);
  CHECK(std::holds_alternative<Arc>(all[2].path));
  CHECK(all[2].rapid);
  CHECK((end(all[3].path) - AxisVector(65, -20, 0)).norm() < 1e-9);
}

TEST_CASE("the other planes", "[ipr][compensation]") {
  const auto zx = compensated_moves("G18 G42 G01 Z20\nZ40\nX30\nG40 Z80");
  REQUIRE(zx.size() == 5);  // seen against Y: Z to the right, X up; the tool right of Z is below
  CHECK((end(zx[1].path) - AxisVector(-5, 0, 40)).norm() < 1e-9);
  CHECK((end(zx[3].path) - AxisVector(30, 0, 45)).norm() < 1e-9);
  const auto yz = compensated_moves("G19 G41 G01 Y20\nY40\nZ30\nG40 Z80");
  CHECK((end(yz[1].path) - AxisVector(0, 35, 5)).norm() < 1e-9);
  CHECK((end(yz[2].path) - AxisVector(0, 35, 30)).norm() < 1e-9);
}

TEST_CASE("the tool follows a turned work system", "[ipr][compensation]") {
  MachineState state;
  state.work[0].rotation = std::numbers::pi / 2;
  Diagnostics diagnostics;
  Reader reader = Reader::from_text("T1 M06 F100\nG41 G01 X20\nX40\nM02\n");
  Parser parser(reader, diagnostics);
  const Machine machine = compensation_mill();
  Interpreter interpreter(parser, machine, diagnostics, {}, state);
  interpreter.next();
  interpreter.next();
  const auto block = interpreter.next();
  CHECK((end(std::get<Move>(block->what).path) - AxisVector(-5, 40, 0)).norm() < 1e-9);
}

TEST_CASE("a turned work system tilts the other planes", "[ipr][compensation]") {
  MachineState state;
  state.work[0].rotation = 0.1;
  Diagnostics diagnostics;
  Reader reader = Reader::from_text("G18 F100 G41.1 D3\nM02\n");
  Parser parser(reader, diagnostics);
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, {}, state);
  while (interpreter.next()) continue;
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].code == Code::SC2140);
  CHECK(diagnostics.all()[0].pos.column == 10);
  CHECK(diagnostics.all()[0].message ==
        "G41.1 in a plane that the rotation of the work system tilts");
}

TEST_CASE("an arc that enters keeps its turns", "[ipr][compensation]") {
  const auto sweep = [](const std::string& turns) {
    const std::vector<Move> all =
        compensated_moves("G0 X-10 Y-20\nG41 D4\nG3 X20 Y0 Z-6 R40" + turns + "\nG1 Y40");
    return std::get<Arc>(all[1].path).sweep();
  };
  const double last = sweep("");
  CHECK((last > 0 && last < 2 * std::numbers::pi));
  CHECK(sweep(" P3") == Approx(last + 4 * std::numbers::pi));
}

TEST_CASE("after G40 the tool leaves on a line", "[ipr][compensation]") {
  check_compensated("G41 G01 X20\nX40\nG40\nG00 Z10\nX40 Y0\nX50",
                    {{20, 5, 0}, {40, 5, 0}, {40, 5, 10}, {40, 0, 10}, {50, 0, 10}});
  check_compensated("G41 G01 X20\nX40\nG40 X40 Y0", {{20, 5, 0}, {40, 5, 0}, {40, 0, 0}});
  check_compensated("G41 G01 X20\nX40\nG40\nG91 X10", {{20, 5, 0}, {40, 5, 0}, {50, 0, 0}});
}

TEST_CASE("after G40 a move across the plane alone goes straight, in every plane",
          "[ipr][compensation]") {
  const auto message = [](const std::string& text) {
    const auto result = interpret("F100\n" + text + "\nM02\n", compensation_mill());
    REQUIRE(result.diagnostics.size() == 1);
    return result.diagnostics.front().message;
  };
  check_compensated("G18 G41.1 D10 G01 Z20\nZ40\nG40\nG01 Y7",
                    {{5, 0, 20}, {5, 0, 40}, {5, 7, 40}});
  CHECK(
      message("G41.1 D3 G1 X10 Y0\nG1 X20\nG40\nG0 Z10\nG2 X30 Y0 I5 J0") ==
      "G02 after G40, which leaves the tool beside the contour, at X20 Y1.5; the first move in the "
      "plane leads away on a line");
  CHECK(message("G20 G41.1 D0.1 G1 X1 Y0 F4\nG1 X2\nG40\nG3 X3 Y0 I0.5 J0").find("at X2 Y0.05;") !=
        std::string::npos);
}

TEST_CASE("a program may end beside the contour", "[ipr][compensation]") {
  check_compensated("G41 G01 X20\nX40", {{20, 5, 0}, {40, 5, 0}});
  CHECK(compensated_ends("G41 G01 X20\nX40 M30").size() == 2);
}

TEST_CASE("moves across the plane may come before the first one in it", "[ipr][compensation]") {
  check_compensated("G41\nG01 Z-5\nX20\nX40", {{0, 0, -5}, {20, 5, -5}, {40, 5, -5}});
}

TEST_CASE("with a radius of 0 moves stay as they are", "[ipr][compensation]") {
  const auto result = interpret("F100 G41 G01 X10\nY10\nX2\nG40 X0\nM02\n", compensation_mill());
  CHECK(places(result) == Places{"SC2148 1:6"});
  CHECK(result.blocks.size() == 5);
}

TEST_CASE("a path that goes back goes round its end", "[ipr][compensation]") {
  check_compensated("G42 G01 X10 Y10\nX30\nX10",
                    {{12.0710678119, 5, 0}, {30, 5, 0}, {30, 15, 0}, {30, 10, 1}, {10, 15, 0}});
  // The tool would be between the two branches.
  CHECK(reported_of_compensation("G42 G01 X25\nX40\nG02 X20 Y20 I0 J20") == Places{});
  CHECK(reported_of_compensation("G41 G01 X25\nX40\nG02 X20 Y20 I0 J20") == Places{"SC2146 4:1"});
}

TEST_CASE("a corner that lines miss by rounding is none", "[ipr][compensation]") {
  CHECK(compensated_ends("G41 G01 X20\nX40 Y0.0000001\nX60").size() == 3);
}

TEST_CASE("what the tool cannot reach is reported at the move that it would gouge",
          "[ipr][compensation]") {
  CHECK(reported_of_compensation("G41 G01 X10 Y10\nX30\nX33\nY40") == Places{"SC2146 5:1"});
  CHECK(reported_of_compensation("G41 G01 X10 Y10\nX33\nY19\nX0") == Places{"SC2147 4:1"});
  CHECK(reported_of_compensation("G41 G01 X10 Y10\nX33\nY20\nX0") == Places{});  // it just fits
  CHECK(reported_of_compensation("G41 G01 X10 Y10\nX30\nG03 X30 Y18 R4\nG01 X0") ==
        Places{"SC2145 4:1"});
  CHECK(reported_of_compensation("G41 G01 X10 Y10\nX30\nG03 X30 Y20 R5\nG01 X0") ==
        Places{"SC2145 4:1"});
  CHECK(reported_of_compensation("G41 G01 X5\nX20") == Places{"SC2143 2:1"});
}

TEST_CASE("a move that comes back to its neighbour is reported", "[ipr][compensation]") {
  const std::string entry = "G41.1 D4 G01 X10 Y0\nX50\n";
  CHECK(reported_of_compensation(entry + "G03 X30.05 Y1 R10\nG01 Y20") == Places{"SC2150 4:1"});
  CHECK(reported_of_compensation(entry + "G03 X31 Y2 Z-9 R10\nG01 Y20") ==
        Places{});  // at another height
  CHECK(reported_of_compensation(entry + "G03 X31 Y4.1 R10\nG01 X28 Y20") ==
        Places{});  // it just passes
  CHECK(reported_of_compensation("G42.1 D4 G01 X10 Y0\nX50\nG02 X30.05 Y-1 R10\nG01 Y-20") ==
        Places{"SC2150 4:1"});
  // A full circle and the arc that leaves it, which crosses the contour of its beginning.
  CHECK(reported_of_compensation(
            "G41.1 D4 G01 X30 Y0\nG03 X30 Y0 I-20 J0\nG03 X20 Y10 R10\nG40 G01 X10 Y5") ==
        Places{});
  // A line into the arc before: it ends beside the tool's way there, or reaches across it.
  CHECK(reported_of_compensation("G41.1 D8 G01 X-20 Y0\nX0\nG03 X-10 Y10 I0 J10\nG01 X4 Y10") ==
        Places{});
  CHECK(reported_of_compensation("G41.1 D8 G01 X-20 Y0\nX0\nG03 X-10 Y10 I0 J10\nG01 X5 Y10") ==
        Places{"SC2150 5:1"});
}

TEST_CASE("a move that leads back through its neighbour after an outside corner is reported",
          "[ipr][compensation]") {
  const std::string entry = "G41.1 D6 G01 X0 Y10\n";
  // The arc passes over the line, whose other side it is on, and comes down through it.
  CHECK(reported_of_compensation(entry + "X-40 Y9\nG02 X10 Y-1 R100\nG40 G01 X30 Y-9") ==
        Places{"SC2150 4:1"});
  CHECK(reported_of_compensation(entry + "X-40 Y9\nG02 X-30 Y9.5 R100\nG40 G01 X30 Y90") ==
        Places{});
  CHECK(reported_of_compensation(entry + "X-40 Y9\nG01 X10 Y40\nG40 G01 X30 Y90") == Places{});
}

TEST_CASE("an error before the contour, or in it, causes no other", "[ipr][compensation]") {
  CHECK(reported_of_compensation("G41 D77 G01 X10\nX11\nY10\nG42.1 D2 X30\nX50\nG40 Y9") ==
        Places{"SC2142 2:5"});
  CHECK(reported_of_compensation("G41 G01 X20\nX40\nX--1\nY10\nX39\nX38\nY50\nG40 X0") ==
        Places{"SC1003 4:2"});
  CHECK(reported_of_compensation("G41 G01 X20\nX40\nY20 $\nX0\nX-1\nG40 X-9") ==
        Places{"SC1001 4:5"});
}

namespace {

/// How far a point is from a curve in the plane of X and Y, mm; by projection, not by offsets.
double distance(const AxisVector& point, const Path& path) {
  const double to_ends = std::min((point - start(path)).norm(), (point - end(path)).norm());
  const auto* arc = std::get_if<Arc>(&path);
  if (arc == nullptr) {
    const AxisVector way = end(path) - start(path);
    const double part = way.dot(point - start(path)) / way.squaredNorm();
    if (part < 0 || part > 1) return to_ends;
    return (point - start(path) - part * way).norm();
  }
  const AxisVector from = start(path) - arc->center(), arm = point - arc->center();
  const double sense = arc->ccw() ? 1 : -1;
  double angle = sense * std::atan2(from.x() * arm.y() - from.y() * arm.x(), from.dot(arm));
  if (angle < 0) angle += 2 * std::numbers::pi;
  if (angle > std::abs(arc->sweep())) return to_ends;
  return std::abs(arm.norm() - arc->radius());
}

/// A way from left to right: lines and arcs at angles of up to 60 degrees.
std::string random_contour() {
  std::string text;
  for (int i = test::integer(2, 9); i > 0; --i) {
    const double across = test::real(8, 40), up = across * test::real(-1.7, 1.7);
    const double chord = std::hypot(across, up);
    const std::string to = " X" + number_text(across) + " Y" + number_text(up);
    if (test::integer(0, 1) == 0)
      text += "G01" + to + "\n";
    else
      text += (test::integer(0, 1) == 0 ? "G02" : "G03") + to + " R" +
              number_text(chord * test::real(1, 4) + 0.001) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("the tool is as far from the contour as its radius, all the way",
          "[ipr][compensation][property]") {
  int good = 0;
  test::holds(
      [&] {
        const bool left = test::integer(0, 1) == 0;
        const double radius = test::real(0.1, 6);
        const std::string contour = "G91\n" + random_contour();
        const std::string head = "F100 G01 X20\n";
        const auto beside = interpret((left ? "G41.1 D" : "G42.1 D") + number_text(2 * radius) +
                                      head + contour + "M02\n");
        if (!beside.diagnostics.empty()) return;
        ++good;
        const auto along = moves_of(head + contour + "M02\n");
        const double r = std::stod(number_text(2 * radius)) / 2;
        bool entry = true;
        for (const Block& block : beside.blocks) {
          const auto* move = std::get_if<Move>(&block.what);
          if (move == nullptr || std::exchange(entry, false)) continue;
          for (int i = 0; i <= 20; ++i) {
            const AxisVector point = position(move->path, length(move->path) * i / 20);
            double nearest = 1e9;
            for (std::size_t k = 1; k < along.size(); ++k)
              nearest = std::min(nearest, distance(point, along[k].path));
            RC_ASSERT(std::abs(nearest - r) < 2e-6);
          }
        }
      },
      2000);
  CHECK(good > 1500 / test::kPart);
}

namespace {

/// Points along the path, evenly; not its ends, where neighbours join.
std::vector<AxisVector> points_within(const Path& path) {
  constexpr int kParts = 80;
  std::vector<AxisVector> points;
  for (int i = 1; i < kParts; ++i) points.push_back(position(path, length(path) * i / kParts));
  return points;
}

/// Twice the area of the triangle in the plane of X and Y, mm^2; its sign reports the turn.
double turn_of(const AxisVector& a, const AxisVector& b, const AxisVector& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool chords_cross(const std::vector<AxisVector>& a, const std::vector<AxisVector>& b) {
  for (std::size_t i = 1; i < a.size(); ++i)
    for (std::size_t k = 1; k < b.size(); ++k)
      if (turn_of(a[i - 1], a[i], b[k - 1]) * turn_of(a[i - 1], a[i], b[k]) < 0 &&
          turn_of(b[k - 1], b[k], a[i - 1]) * turn_of(b[k - 1], b[k], a[i]) < 0)
        return true;
  return false;
}

std::string long_arc() {
  const double chord = test::real(1, 30), angle = test::real(0, 6.28);
  return (test::integer(0, 1) == 0 ? "G02 X" : "G03 X") + number_text(chord * std::cos(angle)) +
         " Y" + number_text(chord * std::sin(angle)) + " R-" +
         number_text(chord * test::real(0.6, 2));
}

}  // namespace

TEST_CASE("paths beside neighbours that have no report do not cross",
          "[ipr][compensation][property]") {
  int good = 0, reported = 0;
  test::holds(
      [&] {
        const std::string line = "G01 X" + number_text(test::real(5, 60)) + " Y0\n";
        const auto beside = interpret((test::integer(0, 1) == 0 ? "G41.1 D4" : "G42.1 D4") +
                                      std::string(" F100 G01 X20\nG91\n") + line + long_arc() +
                                      "\n" + line + "M02\n");
        if (!beside.diagnostics.empty()) {
          reported += beside.diagnostics.front().code == Code::SC2150 ? 1 : 0;
          return;
        }
        ++good;
        std::vector<std::vector<AxisVector>> along;  // of moves of the contour, by their lines
        for (const Block& block : beside.blocks)
          if (const auto* move = std::get_if<Move>(&block.what); move && block.source.line > 2)
            along.push_back(points_within(move->path));
        for (std::size_t i = 1; i < along.size(); ++i)
          RC_ASSERT(!chords_cross(along[i - 1], along[i]));
      },
      1000);
  CHECK(good > 240 / test::kPart);
  CHECK(reported > 240 / test::kPart);
}

TEST_CASE("in the fanuc dialect the first line leads square to the next move",
          "[ipr][compensation][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  const auto ends_by = [&](const std::string& text) {
    std::vector<AxisVector> all;
    for (const Move& move : moves_of("F100 D1\n" + text + "\nM30\n", compensation_mill(), fanuc))
      all.push_back(end(move.path));
    return all;
  };
  const auto inside = ends_by("G41 G01 X15\nG03 I-15\nG40 G01 X0");  // radius 5 in a bore of 15
  REQUIRE(inside.size() == 3);
  CHECK((inside[0] - AxisVector(10, 0, 0)).norm() < 1e-9);
  CHECK((inside[1] - AxisVector(10, 0, 0)).norm() < 1e-9);
  CHECK((inside[2] - AxisVector(0, 0, 0)).norm() < 1e-9);
  const auto outside = ends_by("G41 G01 X3\nY-20\nG40 X20");  // shorter than the radius
  REQUIRE(outside.size() == 3);
  CHECK((outside[0] - AxisVector(8, 0, 0)).norm() < 1e-9);
  CHECK((outside[1] - AxisVector(8, -20, 0)).norm() < 1e-9);
}

TEST_CASE("in the fanuc dialect D stays in force", "[ipr][compensation][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  const auto place = [&](const std::string& text) {  // of the tool beside Y20
    const auto all = moves_of("T1 M06 F100\n" + text + "\nM30\n", compensation_mill(), fanuc);
    return end(all.back().path).y();
  };
  const auto told_by = [&](const std::string& text, InterpreterOptions options) {
    return places(interpret("T1 M06 F100\n" + text + "\nM30\n", compensation_mill(), options));
  };
  CHECK(place("G1 G41 D2 X20 Y0\nX40\nG40 Y20\nG41 X60\nX80") == 23);
  CHECK(place("D2\nG1 G41 X20 Y20\nX40") == 23);
  CHECK(place("G0 X0 D2\nG1 G42 X20 Y20\nX40") == 17);
  CHECK(place("G1 G41 D2 X20 Y20\nX40\nG41 D2 X60\nG41 X70\nD2 X80") == 23);
  CHECK(place("G1 G41 D2 X20 Y20\nX40\nG40 Y40\nX0\nD4\nG41 X20 Y20\nX40") == 21.5);
  CHECK(told_by("D2\nG1 G41 X20\nX40\nG42 Y30\nX60", fanuc) == Places{"SC2141 5:1"});
  CHECK(told_by("D2\nG1 G41 X20\nX40\nG41 D1 Y30", fanuc) == Places{"SC2141 5:1"});
  CHECK(told_by("D2\nG1 G41 X20\nX40\nD1 Y30", fanuc) == Places{"SC2141 5:1"});
  CHECK(told_by("D2\nG1 G41 X20\nX40\nH1 X50", fanuc) == Places{"SC2140 5:1"});
  CHECK(told_by("D7\nG1 G41 X20\nX40", fanuc) == Places{"SC2142 3:4"});
  CHECK(told_by("G1 G41 X20\nX40\nG41 X50", fanuc) == Places{"SC2148 2:4"});
  CHECK(told_by("D0\nG1 G41 X20\nX40", fanuc).empty());
  CHECK(told_by("D2\nG1 X20", {}) == Places{"SC2004 2:1"});
  CHECK(told_by("G1 G41 D2 X20\nX40\nG41 D2 X50", {}) == Places{"SC2141 4:1"});
}

}  // namespace softcnc::ipr
