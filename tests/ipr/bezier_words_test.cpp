// SPDX-License-Identifier: MIT
// G05 and G05.1: a Bezier curve in a line. The points are those of scipy's BSpline.
#include <catch2/catch.hpp>

#include "ipr/curves.hpp"

namespace softcnc::ipr {
namespace {}  // namespace

TEST_CASE("G05 is the cubic of its end and its two control points", "[ipr][bezier]") {
  const auto curves = curves_of("G00 X1 Y2 F600\nG05 I3 J6 P-4 Q5 X20 Y-3\nM30\n");
  REQUIRE(curves.size() == 1);
  CHECK(curves[0].source.line == 2);
  CHECK(move_of(curves[0]).feed == 10);
  const Nurbs& curve = nurbs_of(curves[0]);
  CHECK(curve.spec().degree == 3);
  check_point(curve, 0, {1, 2, 0});
  check_point(curve, 0.25, {4.671875, 4.453125, 0});
  check_point(curve, 0.5, {10.125, 3.625, 0});
  check_point(curve, 0.8, {16.776, 0.015999999999999126, 0});
  check_point(curve, 1, {20, -3, 0});
}

TEST_CASE("G05 without I and J goes on in the direction of the one before", "[ipr][bezier]") {
  for (const char* again : {"G05 ", ""}) {
    const auto curves = curves_of(std::string("G00 X1 Y2 F600\nG05 I3 J6 P-4 Q5 X20 Y-3\nM08\n") +
                                  again + "X30 Y1 P-2 Q-7\nM30\n");
    REQUIRE(curves.size() == 2);
    const Nurbs& curve = nurbs_of(curves[1]);
    check_point(curve, 0.25, {22.96875, -5.46875, 0});
    check_point(curve, 0.5, {25.75, -5.5, 0});
    check_point(curve, 0.8, {28.576, -2.584, 0});
    const PathPoint end = at(move_of(curves[0]).path, length(move_of(curves[0]).path));
    CHECK((end.dq - at(move_of(curves[1]).path, 0).dq).norm() < 1e-9);
  }
}

TEST_CASE("G05 goes on only right after a G05", "[ipr][bezier]") {
  const std::string first = "F600 G05 X10 Y0 I1 J2 P-1 Q2\n";
  CHECK(places(interpret("F600 G05 X10 Y0 P-1 Q2\nM30\n")) == Places{"SC3118 1:6"});
  CHECK(places(interpret(first + "G01 X12\nG05 X20 P-1 Q3\nM30\n")) == Places{"SC3118 3:1"});
  CHECK(places(interpret(first + "G80\nG05 X20 P-1 Q3\nM30\n")) == Places{"SC3118 3:1"});
  CHECK(places(interpret(first + "G05.1 X12 I1 J1\nG05 X20 P-1 Q3\nM30\n")) ==
        Places{"SC3118 3:1"});
}

TEST_CASE("what a bad G05 leads to is not reported again", "[ipr][bezier]") {
  CHECK(places(interpret("F600 G05 X10 Y0 I1 J2 P-1\nX20 P-1 Q3\nM30\n")) == Places{"SC2005 1:6"});
  CHECK(places(interpret("F600 G05 X1..0 Y0 I1 J2 P-1 Q1\nX20 P-1 Q3\nG01 X3\nM30\n")) ==
        Places{"SC1004 1:11"});
}

TEST_CASE("G05.1 is the quadratic of its end and its control point", "[ipr][bezier]") {
  const auto curves = curves_of("G00 X30 Y1 F600\nG05.1 I5 J9 X42 Y-1\nX50 I1 J-3\nM30\n");
  REQUIRE(curves.size() == 2);
  const Nurbs& curve = nurbs_of(curves[0]);
  CHECK(curve.spec().degree == 2);
  check_point(curve, 0.25, {32.625, 4.25, 0});
  check_point(curve, 0.5, {35.5, 5, 0});
  check_point(curve, 0.8, {39.28, 2.6, 0});
  check_point(nurbs_of(curves[1]), 0, {42, -1, 0});
  check_point(nurbs_of(curves[1]), 1, {50, -1, 0});
}

TEST_CASE("G05 and G05.1 lie in the plane in force, P along its first axis", "[ipr][bezier]") {
  const auto zx = curves_of("G00 Z1 X2 F600\nG18 G05 K3 I6 P-4 Q5 Z20 X-3\nM30\n");
  check_point(nurbs_of(zx[0]), 0.25, {4.453125, 0, 4.671875});
  const auto yz = curves_of("G00 Y30 Z1 F600\nG19 G05.1 J5 K9 Y42 Z-1\nM30\n");
  check_point(nurbs_of(yz[0]), 0.25, {0, 32.625, 4.25});
}

TEST_CASE("curves of a line count inches, distances and turned coordinates", "[ipr][bezier]") {
  const auto inches = curves_of("G20 F60 G91\nG05 X1 Y2 I.5 J0 P0 Q-.5\nM30\n");
  const NurbsSpec& spec = nurbs_of(inches[0]).spec();
  CHECK((spec.control[1] - AxisVector(12.7, 0, 0)).norm() < 1e-12);
  CHECK((spec.control[2] - AxisVector(25.4, 38.1, 0)).norm() < 1e-12);

  Diagnostics diagnostics;
  Reader reader = Reader::from_text("F600 G05 X10 Y0 I1 J2 P-3 Q4\nM30\n");
  Parser parser(reader, diagnostics);
  MachineState state;
  state.work[0] = {AxisVector(5, 7, 0), 1.5707963267948966};
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, {}, state);
  const auto block = interpreter.next();
  REQUIRE(block);
  const std::vector<AxisVector> expected{{0, 0, 0}, {-2, 1, 0}, {1, 14, 0}, {5, 17, 0}};
  for (std::size_t i = 0; i < 4; ++i)
    CHECK((nurbs_of(*block).spec().control[i] - expected[i]).norm() < 1e-12);
}

TEST_CASE("to FANUC, G05 and G05.1 are switches without effect, reported once", "[ipr][bezier]") {
  const std::string program =
      "G01 X1 F600\nG05 P10000\nX2\nG05.1 Q1 R5\nX3\nG05.1 Q0\nG05 P0\nX4\nM30\n";
  const Interpreted result = interpret(program, {}, kFanuc);
  CHECK(places(result) == Places{"SC3115 2:1"});
  CHECK(result.blocks.size() == 5);
  CHECK(places(interpret("G05 X1 Y2 I1 J1 P1 Q1\nG05.1 X1 I1 J1\nM30\n", {}, kFanuc)) ==
        Places{"SC3116 1:1", "SC3116 2:1"});
}

TEST_CASE("a curve whose first handle has no length is run all the same", "[ipr][bezier]") {
  const auto curves = curves_of("F600 G05 X10 Y0 I0 J0 P-1 Q2\nG05.1 X20 I0 J0\nM30\n");
  REQUIRE(curves.size() == 2);
  CHECK(length(move_of(curves[1]).path) == Approx(10));
}

}  // namespace softcnc::ipr
