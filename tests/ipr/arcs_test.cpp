// SPDX-License-Identifier: MIT
// G02 and G03 by centre and by radius, in every plane.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "ipr/interpret.hpp"
#include "support/property.hpp"

namespace softcnc::ipr {
namespace {

using std::numbers::pi;

Arc only_arc(const std::string& program) {
  auto moves = moves_of(program);
  REQUIRE_FALSE(moves.empty());
  REQUIRE(std::holds_alternative<Arc>(moves.back().path));
  return std::get<Arc>(moves.back().path);
}

void check_near(const AxisVector& a, const AxisVector& b, double tolerance = 1e-12) {
  INFO(a.transpose() << " against " << b.transpose());
  CHECK((a - b).norm() <= tolerance);
}

}  // namespace

TEST_CASE("an arc by its centre goes round it", "[ipr][arcs]") {
  const Arc arc = only_arc("F100 G00 X10 Y0\nG03 X0 Y10 I-10 J0\nM30\n");
  check_near(arc.center(), {0, 0, 0});
  CHECK(arc.ccw());
  CHECK(arc.sweep() == Approx(pi / 2).epsilon(1e-14));
  check_near(arc.position(arc.length() / 2), {10 * std::sqrt(0.5), 10 * std::sqrt(0.5), 0});
}

TEST_CASE("clockwise is the other way round", "[ipr][arcs]") {
  const Arc arc = only_arc("F100 G00 X10 Y0\nG02 X0 Y10 I-10 J0\nM30\n");
  CHECK(arc.sweep() == Approx(-3 * pi / 2).epsilon(1e-14));
}

TEST_CASE("an arc without an end in its plane is a full circle", "[ipr][arcs]") {
  const Arc circle = only_arc("F100 G00 X10 Y0\nG02 I-10\nM30\n");
  CHECK(circle.sweep() == Approx(-2 * pi).epsilon(1e-14));
  const Arc helix = only_arc("F100 G00 X10 Y0\nG03 I-10 Z-4\nM30\n");
  CHECK(helix.length() == Approx(std::hypot(20 * pi, 4)).epsilon(1e-14));
  CHECK(helix.to().z() == -4);
}

TEST_CASE("an end rounded to 3 decimals leaves a nearly full circle what it is", "[ipr][arcs]") {
  const Arc on_ray = only_arc("F100 G00 X10\nG03 X9.999 Y0 I-10\nM30\n");
  CHECK(on_ray.sweep() == Approx(2 * pi).epsilon(1e-14));
  CHECK(on_ray.length() == Approx(2 * pi * 9.9995).epsilon(1e-8));
  const Arc gap = only_arc("F100 G00 X10\nG03 X9.999 Y-0.1 I-10 J0\nM30\n");
  CHECK(gap.sweep() == Approx(2 * pi - std::atan2(0.1, 9.999)).epsilon(1e-14));
  check_near(gap.center(), {0, 0, 0});
}

// Both are accepted, and just more refused, by rs274 of LinuxCNC 2.9.
TEST_CASE("the end of an arc may be off its circle by more in inches", "[ipr][arcs]") {
  CHECK(only_arc("F100 G00 X10\nG03 X-10.028 I-10\nM30\n").to().x() == -10.028);
  CHECK(only_arc("G20 F4 G00 X1\nG03 X-1.0028 I-1\nM30\n").to().x() == Approx(-25.47112));
  CHECK(places(interpret("F100 G00 X10\nG03 X-10.0285 I-10\nM30\n")) == Places{"SC2103 2:5"});
  CHECK(places(interpret("G20 F4 G00 X1\nG03 X-1.0029 I-1\nM30\n")) == Places{"SC2103 2:5"});
}

TEST_CASE("the planes have their own axes and their own sense", "[ipr][arcs]") {
  // Quarter circles counter-clockwise, seen against the axis across the plane.
  check_near(only_arc("G17 F100 G00 X10\nG03 X0 Y10 I-10\nM30\n").position(10 * pi / 4),
             {10 * std::sqrt(0.5), 10 * std::sqrt(0.5), 0});
  check_near(only_arc("G18 F100 G00 Z10\nG03 Z0 X10 K-10\nM30\n").position(10 * pi / 4),
             {10 * std::sqrt(0.5), 0, 10 * std::sqrt(0.5)});
  check_near(only_arc("G19 F100 G00 Y10\nG03 Y0 Z10 J-10\nM30\n").position(10 * pi / 4),
             {0, 10 * std::sqrt(0.5), 10 * std::sqrt(0.5)});
}

TEST_CASE("a positive R is the short arc, a negative one the long arc", "[ipr][arcs]") {
  const Arc narrow = only_arc("F100\nG03 X10 Y0 R10\nM30\n");
  CHECK(narrow.sweep() == Approx(pi / 3).epsilon(1e-12));
  check_near(narrow.center(), {5, std::sqrt(75.0), 0});
  const Arc wide = only_arc("F100\nG03 X10 Y0 R-10\nM30\n");
  CHECK(wide.sweep() == Approx(5 * pi / 3).epsilon(1e-12));
  check_near(wide.center(), {5, -std::sqrt(75.0), 0});
  CHECK(only_arc("F100\nG02 X10 Y0 R10\nM30\n").sweep() == Approx(-pi / 3).epsilon(1e-12));
  CHECK(only_arc("F100\nG02 X10 Y0 R-10\nM30\n").sweep() == Approx(-5 * pi / 3).epsilon(1e-12));
}

TEST_CASE("an R that falls short by rounding is a half circle", "[ipr][arcs]") {
  const Arc arc = only_arc("F100\nG03 X20 R9.999\nM30\n");
  CHECK(std::abs(arc.sweep()) == Approx(pi).epsilon(1e-6));
}

TEST_CASE("centre and radius tell the same arc", "[ipr][arcs][property]") {
  test::holds([] {
    const double radius = test::real(0.5, 50);
    const double from = test::real(0, 2 * pi), sweep = test::real(0.05, pi - 0.05);
    const bool ccw = test::integer(0, 1) == 1, wide = test::integer(0, 1) == 1;
    const double turn = (ccw ? 1 : -1) * (wide ? 2 * pi - sweep : sweep);
    const auto word = [](char letter, double value) {
      std::array<char, 48> text{};
      std::snprintf(text.data(), text.size(), "%c%.12f ", letter, value);
      return std::string(text.data());
    };
    const double x = radius * std::cos(from), y = radius * std::sin(from);
    const std::string head =
        "F100 G00 " + word('X', x) + word('Y', y) + (ccw ? "\nG03 " : "\nG02 ") +
        word('X', radius * std::cos(from + turn)) + word('Y', radius * std::sin(from + turn));
    const Arc by_center = only_arc(head + word('I', -x) + word('J', -y) + "\nM30\n");
    const Arc by_radius = only_arc(head + word('R', wide ? -radius : radius) + "\nM30\n");
    RC_ASSERT(std::abs(by_center.sweep() - turn) < 1e-9);
    RC_ASSERT(std::abs(by_radius.sweep() - turn) < 1e-4);
    RC_ASSERT((by_radius.center() - by_center.center()).norm() < 1e-4 * radius);
  });
}

TEST_CASE("P counts the turns of an arc", "[ipr][arcs]") {
  const auto sweep = [](const std::string& program) {
    return std::get<Arc>(moves_of("F100\n" + program + "\nM30\n").back().path).sweep();
  };
  constexpr double kTurn = 2 * std::numbers::pi;
  CHECK(sweep("G02 X0 Y0 I5 P3") == Approx(-3 * kTurn));
  CHECK(sweep("G03 X10 Y0 I5 P2 Z3") == Approx(1.5 * kTurn));
  CHECK(sweep("G02 X10 R5 P3") == Approx(-2.5 * kTurn));
  CHECK(sweep("G02 X10 I5 P1") == Approx(-0.5 * kTurn));
}

TEST_CASE("in G90.1 the centre is a place", "[ipr][arcs]") {
  const auto center = [](const std::string& program) {
    return std::get<Arc>(moves_of("F100\n" + program + "\nM30\n").back().path).center();
  };
  CHECK(center("G00 X1 Y1\nG90.1 G02 X9 I5 J1") == AxisVector(5, 1, 0));
  CHECK(center("G91 G90.1 G03 X10 I5 J0") == AxisVector(5, 0, 0));
  CHECK(center("G90.1 G10 L2 P1 X100 Y50\nG00 X0 Y0\nG03 X10 I5 J0") == AxisVector(105, 50, 0));
  CHECK(center("G90.1\nG91.1 G00 X1\nG02 X11 I5") == AxisVector(6, 0, 0));
  CHECK(center("G18 G90.1 G02 X10 I5 K0").x() == 5);
}

TEST_CASE("in the fanuc dialect R counts beside a centre", "[ipr][arcs][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  const auto moves = moves_of("G17 G02 X10. Y0 I0. J0. K0. R5. F100\nM30\n", {}, fanuc);
  REQUIRE(moves.size() == 1);
  CHECK(std::get<Arc>(moves[0].path).radius() == Approx(5));
  CHECK(places(interpret("G02 X10 R5 I5 F100\nM30\n")) == Places{"SC2106 1:9"});
}

TEST_CASE("radii differ by a thousandth, but by 2.828 mm at most", "[ipr][arcs]") {
  // rs274 accepts the first of each pair and refuses the second.
  const auto differs = [&](const std::string& line) {
    return places(interpret("F1000\n" + line + "\nM30\n"));
  };
  CHECK(differs("G02 X6000 I3001.414").empty());
  CHECK(differs("G02 X6000 I3001.415") == Places{"SC2103 2:5"});
  CHECK(differs("G18 G03 X6000 I3001.415") == Places{"SC2103 2:9"});
  CHECK(differs("G20 G02 X2000 I1000.1414").empty());
  CHECK(differs("G20 G02 X2000 I1000.1415") == Places{"SC2103 2:9"});
}

TEST_CASE("a 0 across the plane beside a centre changes nothing, which is noted once",
          "[ipr][arcs]") {
  const auto read = interpret(
      "F100\nG17 G02 X10 I5 J0 K0.000\nG18 G02 X0 I-5 J0\nG19 G03 Y10 I0 J5\nG91 G17 G90.1\n"
      "G02 X10 I5 J10 K0\nM30\n");
  CHECK(places(read) == Places{"SC2171 2:19"});
  REQUIRE(read.blocks.size() == 5);
  CHECK(std::get<Arc>(std::get<Move>(read.blocks[0].what).path).center() == AxisVector(5, 0, 0));
  CHECK(std::get<Arc>(std::get<Move>(read.blocks[1].what).path).center() == AxisVector(5, 0, 0));
  CHECK(std::get<Arc>(std::get<Move>(read.blocks[2].what).path).center() == AxisVector(0, 5, 0));
  CHECK(std::get<Arc>(std::get<Move>(read.blocks[3].what).path).center() == AxisVector(5, 10, 0));
  CHECK(places(interpret("F100 G02 X10 I5 K1\nM30\n")) == Places{"SC2105 1:17"});
  CHECK(places(interpret("F100 G18 G02 X10 I5 J-1\nM30\n")) == Places{"SC2105 1:21"});
  CHECK(places(interpret("F100 G02 X10 K0\nM30\n")) == Places{"SC2105 1:14"});
}

TEST_CASE("in the fanuc dialect a 0 across the plane beside a centre is none",
          "[ipr][arcs][fanuc]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  const auto moves = moves_of("G17 G02 X10. Y0 I5. J0 K0 F100\nM30\n", {}, fanuc);
  CHECK(std::get<Arc>(moves.back().path).center() == AxisVector(5, 0, 0));
  const auto reported = [&](const std::string& line, InterpreterOptions options) {
    return places(interpret("F100\n" + line + "\nM30\n", {}, options));
  };
  CHECK(reported("G02 X10. I5. K0", fanuc).empty());
  CHECK(reported("G02 X10 I5 K1", fanuc) == Places{"SC2105 2:12"});
  CHECK(reported("G02 X10 K0", fanuc) == Places{"SC2105 2:9"});
  CHECK(reported("G02 X10 R5 K0", {}) == Places{"SC2106 2:9"});
}

}  // namespace softcnc::ipr
