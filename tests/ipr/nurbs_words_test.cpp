// SPDX-License-Identifier: MIT
// G06.2 over its lines.
#include <catch2/catch.hpp>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

struct ReadCurve {
  Move move;
  SourcePos source;
  const NurbsSpec& spec() const { return std::get<Nurbs>(move.path).spec(); }
};

ReadCurve only_curve(const std::string& program) {
  for (Block& block : blocks_of(program))
    if (auto* move = std::get_if<Move>(&block.what))
      if (std::holds_alternative<Nurbs>(move->path)) return {std::move(*move), block.source};
  FAIL("no curve");
  return {Move{softcnc::Line(AxisVector::Zero(), AxisVector::Ones())}, {}};
}

const std::vector<double> kClampedCubic{0, 0, 0, 0, 1, 1, 1, 1};

}  // namespace

TEST_CASE("a curve takes its points, weights, knots, feed and line from its blocks",
          "[ipr][nurbs]") {
  const ReadCurve curve = only_curve(
      "F600\n\nN7 G06.2 P4 K0 X0 Y0\n(c)\nR2 K0 Y5 X5\n\nN8 K0 X10 Y-5 R.5\nK0 X15 Y0\n"
      "K1\nK1\nN9\nK1\nK1\nM30\n");
  CHECK(curve.source.line == 3);
  CHECK(curve.move.feed == 10.0);
  CHECK_FALSE(curve.move.rapid);
  CHECK(curve.spec().degree == 3);
  CHECK(curve.spec().knots == kClampedCubic);
  CHECK(curve.spec().weights == std::vector<double>{1, 2, 0.5, 1});
  REQUIRE(curve.spec().control.size() == 4);
  CHECK(curve.spec().control[1] == AxisVector(5, 5, 0));
  CHECK(curve.spec().control[3] == AxisVector(15, 0, 0));
}

TEST_CASE("without P the order is 4", "[ipr][nurbs]") {
  CHECK(only_curve("F600\nG06.2 K0 X0\nK0 X1\nK0 X2\nK0 X3\nK1\nK1\nK1\nK1\nM30\n").spec().degree ==
        3);
}

TEST_CASE("a first block without axes is the position, and the second names them", "[ipr][nurbs]") {
  const ReadCurve curve = only_curve("F600 G00 X3 Y4\nG06.2 P2 K0 R3\nK0 X5 Y6\nK1\nK1\nM30\n");
  CHECK(curve.spec().control[0] == AxisVector(3, 4, 0));
  CHECK(curve.spec().weights == std::vector<double>{3, 1});
}

TEST_CASE("a curve begins in the position, also if its first point is a rounding off",
          "[ipr][nurbs]") {
  const auto moves = moves_of("F600 G01 X10.0004\nG06.2 P2 K0 X10\nK0 X20\nK1\nK1\nM30\n");
  REQUIRE(moves.size() == 2);
  CHECK(start(moves[1].path) == end(moves[0].path));
}

TEST_CASE("the first point may lie one BLU off, and no more", "[ipr][nurbs]") {
  const auto program = [](const std::string& first) {
    return "F600\nG06.2 P2 K0 X" + first + "\nK0 X20\nK1\nK1\nM30\n";
  };
  CHECK(places(interpret(program("0.0024"))).empty());
  CHECK(places(interpret(program("0.0026"))) == Places{"SC3109 2:13"});
  Machine fine;
  for (Axis& axis : fine.axes) axis.blu = 0.0001;
  CHECK(places(interpret(program("0.0009"), fine)).empty());
  CHECK(places(interpret(program("0.0011"), fine)) == Places{"SC3109 2:13"});
}

TEST_CASE("in G91 points are distances from the point before, in G20 inches", "[ipr][nurbs]") {
  const ReadCurve steps = only_curve("G91 F600\nG06.2 P2 K0 X0\nK0 X5 \nK1 X5\nK2\nK2\nM30\n");
  CHECK(steps.spec().control[2] == AxisVector(10, 0, 0));
  const ReadCurve inches = only_curve("G20 F60\nG06.2 P2 K0 X0 Y0\nK0 X1 Y-1\nK1\nK1\nM30\n");
  CHECK(inches.spec().control[1] == AxisVector(25.4, -25.4, 0));
  CHECK(inches.move.feed == Approx(25.4));
}

TEST_CASE("a curve ends by count, and motion needs a code again", "[ipr][nurbs]") {
  const std::string curve = "F600\nG06.2 P2 K0 X0\nK0 X5\nK1\nK1\n";
  CHECK(places(interpret(curve + "X6\nM30\n")) == Places{"SC2101 6:1"});
  CHECK(places(interpret(curve + "K1\nM30\n")) == Places{"SC2004 6:1"});
  const auto moves = moves_of(curve + "G01 X6\nM30\n");
  REQUIRE(moves.size() == 2);
  CHECK(start(moves[1].path) == AxisVector(5, 0, 0));
}

TEST_CASE("a bad curve gives no block, and the position is the next one given", "[ipr][nurbs]") {
  const Interpreted result =
      interpret("F600\nG06.2 P2 K0 X0\nK0 X5 I1\nK1\nK1\nG00 X5\nG02 X9 I2\nM30\n");
  CHECK(places(result) == Places{"SC2004 3:7"});
  REQUIRE(result.blocks.size() == 2);
  CHECK(end(std::get<Move>(result.blocks[0].what).path) == AxisVector(9, 0, 0));
}

TEST_CASE("LinuxCNC's form, with G06.2, P and Q in every block, is the same curve",
          "[ipr][nurbs]") {
  const std::string start = "F600\nG06.2 P4 K0 X0 Y0 Q1\n";
  const Interpreted result =
      interpret(start +
                "G06.2 P4 K0 X5 Y5 R2 Q1\nG06.2 K0 X10 Y-5 R.5\nK0 X15 Y0\nG06.2 K1\nG6.2 K1\nK1\n"
                "G06.2 P4 K1\nG01 X20\nM30\n");
  CHECK(places(result) == Places{"SC3114 2:19"});
  REQUIRE(result.blocks.size() == 3);
  const auto& move = std::get<Move>(result.blocks[0].what);
  CHECK(std::get<Nurbs>(move.path).spec().knots == kClampedCubic);
  CHECK(std::get<Nurbs>(move.path).spec().weights == std::vector<double>{1, 2, 0.5, 1});
}

TEST_CASE("in the form of LinuxCNC's samples, G06.2 stands again before each closing knot",
          "[ipr][nurbs]") {
  const Interpreted result = interpret(
      "G06.2 X0 Y0 R1 K0 P3 Q1 F300\nX10 Y10 R1 K0\nX20 Y0 R1 K0\nG06.2 K1\nG06.2 K1\nG06.2 K1\n"
      "G01 X30\nM30\n");
  CHECK(places(result) == Places{"SC3114 1:22"});
  REQUIRE(result.blocks.size() == 3);
  const NurbsSpec& spec = std::get<Nurbs>(std::get<Move>(result.blocks[0].what).path).spec();
  CHECK(spec.degree == 2);
  CHECK(spec.knots == std::vector<double>{0, 0, 0, 1, 1, 1});
  CHECK(spec.weights == std::vector<double>{1, 1, 1});
  CHECK(spec.control[1] == AxisVector(10, 10, 0));
  CHECK(spec.control[2] == AxisVector(20, 0, 0));
  CHECK(end(std::get<Move>(result.blocks[1].what).path) == AxisVector(30, 0, 0));
}

TEST_CASE("a closing knot of any form may have G06.2, but no P and no point", "[ipr][nurbs]") {
  const std::string points = "F600\nG06.2 P2 K0 X0\nK0 X5\n";
  CHECK(places(interpret(points + "G06.2 K1\nK1\nM30\n")).empty());
  CHECK(places(interpret(points + "K1\nG06.2 K1\nM30\n")).empty());
  CHECK(places(interpret(points + "G06.2 K1 P2\nM30\n")) == Places{"SC3105 4:1"});
  CHECK(places(interpret(points + "G06.2 K1 X9\nM30\n")) == Places{"SC3105 4:1"});
  CHECK(places(interpret(points + "G06.2 K1\nK1\nM30\n", {}, {.dialect = Dialect::fanuc})) ==
        Places{"SC3105 4:1"});
}

TEST_CASE("G06.2 with another P, or after a block without it, begins another curve",
          "[ipr][nurbs]") {
  CHECK(places(interpret("F600\nG06.2 P3 K0 X0\nG06.2 P2 K0 X0\nK0 X1\nK1\nK1\nM30\n")) ==
        Places{"SC3105 3:1"});
  CHECK(places(interpret("F600\nG06.2 K0 X0\nK0 X1\nG06.2 K0 X1\nK0 X2\nK0 X3\nK0 X4\nK1\nK1\n"
                         "K1\nK1\nM30\n")) == Places{"SC3105 4:1"});
}

TEST_CASE("to FANUC, G06.2 stands once, Q means nothing, and the order is 4 at most",
          "[ipr][nurbs]") {
  const InterpreterOptions fanuc{.dialect = Dialect::fanuc};
  CHECK(places(interpret("F600\nG06.2 P2 K0 X0\nG06.2 K0 X1\nM30\n", {}, fanuc)) ==
        Places{"SC3105 3:1"});
  CHECK(places(interpret("F600\nG06.2 P2 K0 X0\nG06.2 K0 X1\nG06.2 K1\nG06.2 K1\nG01 X3\nM30\n", {},
                         fanuc)) == Places{"SC3105 3:1"});
  CHECK(places(interpret("F600\nG06.2 P2 K0 X0 Q1\nK0 X1\nK1\nK1\nM30\n", {}, fanuc)) ==
        Places{"SC2004 2:16"});
  const std::string fifth =
      "G06.2 P5 K0 X0 Y0\nK0 X1\nK0 X2 Y1\nK0 X1\nK0 X0 Y0\nK1\nK1\nK1\nK1\nK1\n";
  CHECK(places(interpret("F600\n" + fifth + fifth + "M30\n", {}, fanuc)) == Places{"SC3113 2:7"});
}

TEST_CASE("a code that does not end motion spoils a curve once", "[ipr][nurbs]") {
  CHECK(places(interpret("F600\nG06.2 P2 K0 X0\nM08\nK0 X1\nK1\nK1\nG01 X5\nM30\n")) ==
        Places{"SC3105 3:1"});
}

TEST_CASE("blocks of a curve that was left too early are not reported", "[ipr][nurbs]") {
  const std::string head = "F600\nG06.2 P2 K0 X0\nK0 X1\n";
  for (const char* code : {"G1", "G2"})
    CHECK(places(interpret(head + code +
                           " K.5 X2 Y2\nK.6 X3\nX4 K.7 R2\nK1\nK1\nG1 X5\nX6 K1\nM30\n")) ==
          Places{"SC3105 4:1", "SC2004 10:4"});
  CHECK(places(interpret(head + "M98 P7\nK1\nK1\nG1 X5\nM30\nO7\nX8\nM99\n")) ==
        Places{"SC3105 4:1"});
}

TEST_CASE("of a curve that ends too early only that is reported", "[ipr][nurbs]") {
  CHECK(places(interpret("F600\nG06.2 P3 K0 X0\nK0 R2\nK0 X2\nK1\nK1\nK1\nG1 X5\nM30\n")) ==
        Places{"SC3002 3:1"});
}

TEST_CASE("an axis that the first block of a curve lacks is reported once", "[ipr][nurbs]") {
  CHECK(places(interpret("F600\nG06.2 P2 K0 X0\nK0 X1 Y1\nK.5 X2 Y2\nK1\nK1\nM30\n")) ==
        Places{"SC3103 3:7"});
}

TEST_CASE("control points count work offsets and rotation", "[ipr][nurbs]") {
  Diagnostics diagnostics;
  Reader reader = Reader::from_text("F600\nG06.2 P2 K0\nK0 X10 Y0\nK1\nK1\nM30\n");
  Parser parser(reader, diagnostics);
  MachineState state;
  state.work[0] = {AxisVector(5, 7, 0), 1.5707963267948966};
  const Machine machine;
  Interpreter interpreter(parser, machine, diagnostics, {}, state);
  const auto block = interpreter.next();
  REQUIRE(block);
  CHECK((end(std::get<Move>(block->what).path) - AxisVector(5, 17, 0)).norm() < 1e-12);
}

TEST_CASE("P, F and R in one first block", "[ipr][nurbs]") {
  const ReadCurve curve = only_curve("G06.2 R2 F300 X0 K0 P2\nK0 X1\nK1\nK1\nM30\n");
  CHECK(curve.move.feed == 5.0);
  CHECK(curve.spec().weights.front() == 2.0);
}

}  // namespace softcnc::ipr
