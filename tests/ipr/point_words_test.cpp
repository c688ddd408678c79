// SPDX-License-Identifier: MIT
// Curves by points: G05.2 with G05.3, and G06.1. The points are those of scipy's BSpline and
// CubicSpline.
#include <catch2/catch.hpp>

#include "ipr/curves.hpp"
#include "motion/geometry/spline.hpp"

namespace softcnc::ipr {
namespace {

constexpr const char* kSpline =
    "F600\nG06.1 X10 Y6 Z1\nX14 Y-5 Z2\n(c)\nN5 X25 Y3 Z-4\nX40 Y0 Z0\n";

void check_spline(const Nurbs& curve) {
  check_point(curve, 4, {3.9763940483483897, 3.774660666871126, 0.19831565100382567});
  check_point(curve, 15, {11.404582365351967, 3.3727405496955303, 1.6092666040581234});
  check_point(curve, 20, {12.825607544006814, -2.3302513630756305, 2.255536046809589});
  check_point(curve, 33, {20.282637128594686, -0.975003268947713, -2.0697359189402347});
  check_point(curve, 50, {36.02622583481678, 2.141177806681684, -1.9002974991835264});
}

}  // namespace

TEST_CASE("G05.2 is the NURBS of its points and weights over uniform knots", "[ipr][points]") {
  const auto curves = curves_of(
      "F600\nG05.2 L4 X2 Y8 P2\nX9 Y7 P.5\nN1 X14 Y-4 P1\n\nX20 Y3 P3\nX26 Y0 P1\nG05.3\nM30\n");
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].source.line == 2);
  CHECK(move_of(curves[0]).feed == 10);
  const Nurbs& curve = nurbs_of(curves[0]);
  CHECK(curve.spec().knots == std::vector<double>{0, 0, 0, 0, 1, 2, 3, 3, 3, 3});
  check_point(curve, 0.4, {2.2202486678507993, 6.7033747779751325, 0});
  check_point(curve, 1.0, {6.217391304347825, 5.608695652173912, 0});
  check_point(curve, 1.7, {14.513988477639156, -0.15505450325361614, 0});
  check_point(curve, 2.9, {22.833709597489122, 1.4900060569351914, 0});
}

TEST_CASE("P alone beside G05.2 is the weight of the start, and the order is 3", "[ipr][points]") {
  const auto curves =
      curves_of("F600\nG05.2 P3\nX2 Y8 P2\nG05.2 X9 Y7 P.5\nX14 Y-4 P1\nG05.3\nM30\n");
  const Nurbs& curve = nurbs_of(curves[0]);
  CHECK(curve.spec().weights == std::vector<double>{3, 2, 0.5, 1});
  check_point(curve, 0.4, {1.1607142857142858, 4.125, 0});
  check_point(curve, 1.0, {3.4, 7.8, 0});
  check_point(curve, 1.7, {11.24, 0.4769230769230774, 0});
}

TEST_CASE("in G91 control points of G05.2 count from its start", "[ipr][points]") {
  const auto moves = moves_of("F600 G91\nG00 X1\nG05.2 X2 Y8 P1\nX9 Y7 P1\nG05.3\nG01 Y1\nM30\n");
  CHECK(std::get<Nurbs>(moves[1].path).spec().control ==
        std::vector<AxisVector>{{1, 0, 0}, {3, 8, 0}, {10, 7, 0}});
  CHECK(end(moves[2].path) == AxisVector(10, 8, 0));
}

TEST_CASE("after G05.3 motion needs a code, and the position is the last point", "[ipr][points]") {
  const std::string curve = "F600\nG05.2 X2 Y8 P2\nX9 Y7 P1\nG05.3\n";
  CHECK(places(interpret(curve + "X1\nM30\n")) == Places{"SC2101 5:1"});
  const auto moves = moves_of(curve + "G91 G01 X1\nM30\n");
  CHECK(end(moves[1].path) == AxisVector(10, 7, 0));
}

TEST_CASE("control points of G05.2 may lie in space and in any plane", "[ipr][points]") {
  const auto curves = curves_of("F600 G18\nG05.2 X2 Z8 P1\nX9 Y5 Z7 P1\nG05.3\nM30\n");
  CHECK(nurbs_of(curves[0]).spec().control[2] == AxisVector(9, 5, 7));
}

TEST_CASE("G06.1 is the natural spline through the position and its points", "[ipr][points]") {
  const auto curves = curves_of(std::string(kSpline) + "G01 X50\nM30\n");
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].source.line == 2);
  CHECK(curves[0].number == 1);
  CHECK(move_of(curves[0]).feed == 10);
  check_spline(nurbs_of(curves[0]));
}

TEST_CASE("a first point in the position is the position", "[ipr][points]") {
  const auto curves =
      curves_of("F600\nG06.1 X0.0005 Y0\nX10 Y6 Z1\nX14 Y-5 Z2\nX25 Y3 Z-4\nX40 Y0 Z0\nG80\nM30\n");
  check_spline(nurbs_of(curves[0]));
  const auto bare =
      curves_of("G06.1 F600\nX10 Y6 Z1\nX14 Y-5 Z2\nX25 Y3 Z-4\nX40 Y0 Z0\nG80\nM30\n");
  check_spline(nurbs_of(bare[0]));
}

TEST_CASE("G06.1 in every block is one spline all the same", "[ipr][points]") {
  const auto curves = curves_of(
      "F600\nG06.1 X10 Y6 Z1\nG06.1 X14 Y-5 Z2\nG06.1 X25 Y3 Z-4\nG06.1 X40 Y0 Z0\nM30\n");
  REQUIRE(curves.size() == 1);
  check_spline(nurbs_of(curves[0]));
}

TEST_CASE("a spline ends at any other motion code, at a stop and at the end", "[ipr][points]") {
  for (const char* end : {"G00 X0\nM30\n", "G53 G00 X0\nM30\n", "G80\nM30\n", "M00\nM30\n", "M30\n",
                          "M02\n", "G02 X50 I5\nM30\n", "G05.2 X1 Y1 P1\nX2 Y0 P1\nG05.3\nM30\n"}) {
    if (std::string_view(end).starts_with("G53") && find_gcode('G', 53) == nullptr) continue;
    INFO(end);
    const auto curves = curves_of(kSpline + std::string(end));
    REQUIRE_FALSE(curves.empty());
    check_spline(nurbs_of(curves[0]));
  }
  const Interpreted open = interpret(kSpline);
  CHECK(places(open) == Places{"SC2205 6:0"});
  REQUIRE(open.blocks.size() == 2);
  check_spline(nurbs_of(open.blocks[0]));
}

TEST_CASE("an error of the line that ends a spline is not the spline's", "[ipr][points]") {
  const Interpreted result = interpret(std::string(kSpline) + "G01 X5 Q1\nM30\n");
  CHECK(places(result) == Places{"SC2004 7:8"});
  REQUIRE(result.blocks.size() == 2);
  check_spline(nurbs_of(result.blocks[0]));
}

TEST_CASE("a bad line within a spline leaves no block, and nothing follows from it",
          "[ipr][points]") {
  for (const char* bad :
       {"X..1\n", "I5\n", "M08\n", "G04 P1\n", "F100\n", "G91\n", "X1 Y2 Z3 A\n"}) {
    INFO(bad);
    const Interpreted result = interpret(std::string(kSpline) + bad + "X50\nG01 X60 Y0 Z0\nM30\n");
    CHECK(result.diagnostics.size() == 1);
    for (const Block& block : result.blocks) {
      const Move* move = std::get_if<Move>(&block.what);
      CHECK((move == nullptr || std::holds_alternative<softcnc::Line>(move->path)));
    }
  }
}

TEST_CASE("points of a curve that was left too early are not reported", "[ipr][points]") {
  const std::string head = "F600\nG5.2 P1\nX1 Y1 P1\n";
  CHECK(places(interpret(head + "G1 X2 Y2 P1\nX3 Y3 P1\nG5.3\nG1 X4\nG5.3\nM2\n")) ==
        Places{"SC3105 4:1", "SC3121 8:1"});
  CHECK(places(interpret("F600\nG5.4 P3\nX1 Y1 P1\nX2 Y3 P1\nG5.3\nM2\n")) == Places{"SC2001 2:1"});
}

TEST_CASE("a spline takes the most points that are promised, and no more", "[ipr][points]") {
  const auto program = [](std::size_t points, const std::string& end) {
    std::string text = "F600\nG06.1\n";
    for (std::size_t i = 1; i < points; ++i)
      text += "X" + std::to_string(i) + " Y" + std::to_string(i % 2) + "\n";
    return text + end + "G80\nM30\n";
  };
  const auto line = [](std::size_t number) { return std::to_string(number); };
  CHECK(curves_of(program(200, "")).size() == 1);
  // A stranger at the end keeps the curve from being made, which would take its time.
  CHECK(places(interpret(program(kMaxSplinePoints, "M08\n"))) ==
        Places{"SC3105 " + line(kMaxSplinePoints + 2) + ":1"});
  CHECK(places(interpret(program(kMaxSplinePoints + 3, "M08\n"))) ==
        Places{"SC3120 " + line(kMaxSplinePoints + 2) + ":1"});
}

TEST_CASE("a straight spline is a straight line", "[ipr][points]") {
  const auto curves = curves_of("F600\nG06.1 X10\nG80\nM30\n");
  REQUIRE(curves.size() == 1);
  CHECK(length(move_of(curves[0]).path) == Approx(10));
}

}  // namespace softcnc::ipr
