// SPDX-License-Identifier: MIT
// Lengths without a decimal point: when they are told, and what they are as increments.
#include <catch2/catch.hpp>
#include <vector>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

Interpreted run_integers(const std::string& text, Dialect dialect = Dialect::fanuc,
                         IntegerUnit unit = IntegerUnit::unstated) {
  InterpreterOptions options;
  options.dialect = dialect;
  Machine machine;
  machine.program.integers = unit;
  return interpret(text, machine, options);
}

std::vector<AxisVector> ends_by_increments(const std::string& text,
                                           Dialect dialect = Dialect::fanuc) {
  std::vector<AxisVector> all;
  const Interpreted result = run_integers(text, dialect, IntegerUnit::increments);
  for (const Diagnostic& diagnostic : result.diagnostics) FAIL(render(diagnostic));
  for (const Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what)) all.push_back(end(move->path));
  return all;
}

}  // namespace

TEST_CASE("a program of whole numbers is told if they look like increments", "[ipr][dialects]") {
  const Interpreted result = run_integers("G21 G90\nG00 X1000 Y500\nG01 Z-500 F100\nX0\nM30");
  REQUIRE(places(result) == Places{"SC1057 2:5"});
  CHECK(result.diagnostics[0].message ==
        "X1000 without a decimal point is 1000 mm; a control that counts increments goes 1 mm "
        "(here and on 1 more line)");
  CHECK(places(run_integers("G20\nG00 X5000\nM30", Dialect::haas)) == Places{"SC1057 2:5"});
  CHECK(run_integers("G20\nG00 X5000\nM30").diagnostics[0].message ==
        "X5000 without a decimal point is 5000 inch; a control that counts increments goes 0.5 "
        "inch");
}

TEST_CASE("a program that has both kinds of lengths is told", "[ipr][dialects]") {
  const Interpreted result = run_integers("G0 X10. Y20.\nX5\nG3 X3 I-1 F100\nM30");
  REQUIRE(places(result) == Places{"SC1057 2:1"});
  CHECK(result.diagnostics[0].message.ends_with("(here and on 1 more line)"));
  CHECK(run_integers("G20\nG0 X1 Y.5\nM30").diagnostics[0].message ==
        "X1 without a decimal point is 1 inch; a control that counts increments goes 0.0001 inch");
}

TEST_CASE("ordinary programs are not", "[ipr][dialects]") {
  for (const char* text :
       {"G0 X10 Y20\nG1 Z-5 F100\nX0\nM30", "G0 X10. Y20.\nG28 Z0\nG3 X20. Y20. I5. J0 F100.\nM30",
        "G0 X1.\nG4 X3\nG4 P500\nM30", "#1=5\nG0 X1.5\nX#1\nX[#1+2]\nM30",
        "G0 Z5.\nG91 G99 G81 X1. Z-1. R-2. F100 K300\nM30",
        "G65 P2 X100. A5. D7 H2 A#1\nM30\nO2\nG0 X1.\nM99",
        "G0 X100.\nG43 H1 Z5.\nT2\nS5000 M3\nN100 G1 F500 X1.\nM30"}) {
    CAPTURE(text);
    CHECK(places(run_integers(text)).empty());
  }
  CHECK(places(run_integers("G0 X1000 Y0.5\nM30", Dialect::linuxcnc)).empty());
  CHECK(places(run_integers("G0 X1000 Y0.5\nM30", Dialect::grbl)).empty());
}

TEST_CASE("every line counts once, whatever the order in which they run", "[ipr][dialects]") {
  const Interpreted result = run_integers(
      "G91\nM98 P2\n#1=0\nWHILE [#1 LT 5] DO1\nG0 X1\nX.5\n#1=#1+1\nEND1\nM98 P2\nM30\nO2\nG0 "
      "Y2\nM99");
  REQUIRE(places(result) == Places{"SC1057 12:4"});
  CHECK(result.diagnostics[0].message.ends_with("(here and on 1 more line)"));
}

TEST_CASE("as increments they are thousandths of a mm or ten-thousandths of an inch",
          "[ipr][dialects]") {
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    const auto points = ends_by_increments(
        "G21 G90\nG0 X1000 Y500.\nG1 Z-500 F100.\nG3 X3000 I1000\nG20 G1 X10000\n#1=2\nG21 "
        "X#1\nM30",
        dialect);
    REQUIRE(points.size() == 5);
    CHECK(near(points[0], {1, 500, 0}));
    CHECK(near(points[1], {1, 500, -0.5}));
    CHECK(near(points[2], {3, 500, -0.5}));
    CHECK(near(points[3], {25.4, 500, -0.5}));
    CHECK(near(points[4], {2, 500, -0.5}));
  }
}

TEST_CASE("increments are the lengths alone", "[ipr][dialects]") {
  const auto points = ends_by_increments(
      "G0 Z10.\nG99 G83 X1000 Z-2000 R1000 Q1500 K2 F100\nG80\nG4 P500\nM98 P2 L2\nM30\nO2\nG0 "
      "Y3000\nM99");
  REQUIRE_FALSE(points.empty());
  CHECK(near(points.back(), {1, 3, 1}));
  double deepest = 0;
  for (const AxisVector& point : points) deepest = std::min(deepest, point.z());
  CHECK(deepest == Approx(-2));
}

TEST_CASE("in haas I J K of pecks are lengths, J and K of a pattern angles", "[ipr][dialects]") {
  const auto pecks = ends_by_increments(
      "G0 Z10.\nG99 G83 X1000 Z-4000 R1000 I2000 J500 K1000 F100.\nG80\nM30", Dialect::haas);
  REQUIRE(pecks.size() == 14);
  CHECK(near(pecks[3], {1, 0, -1}));
  CHECK(near(pecks[6], {1, 0, -2.5}));
  CHECK(near(pecks[9], {1, 0, -3.5}));
  const auto circle = ends_by_increments(
      "G0 Z10.\nG98 G81 Z-4000 R1000 L0 F100.\nG71 X2000 I5000 J90 K90 L2\nG80\nM30",
      Dialect::haas);
  REQUIRE(circle.size() == 9);
  CHECK(near(circle[1], {2, 5, 10}));
  CHECK(near(circle[5], {-3, 0, 10}));
}

TEST_CASE("the radius of polar coordinates counts increments, the angle does not",
          "[ipr][dialects]") {
  const auto polar = ends_by_increments("G16 G0 X10000 Y90\nX5000 Y0\nG15 X5000 Y1000\nM30");
  REQUIRE(polar.size() == 3);
  CHECK(near(polar[0], {0, 10, 0}));
  CHECK(near(polar[1], {5, 0, 0}));
  CHECK(near(polar[2], {5, 1, 0}));
  const auto corner = ends_by_increments("G1 F600 X10000 ,R1000\nY10000\nM30");
  REQUIRE(corner.size() == 3);
  CHECK(near(corner[0], {9, 0, 0}));
  CHECK(ends_by_increments("F600\nG12 I2000 K4000 Q1000 Z-1000 D0\nM30").size() == 8);
}

TEST_CASE("arguments of G65 count increments by their letters", "[ipr][dialects]") {
  const auto passed = [](const std::string& words, int number, Dialect dialect,
                         IntegerUnit unit = IntegerUnit::unstated) {
    const Interpreted result =
        run_integers("G65 P2 " + words + "\nM30\nO2\nG91 G0 X#" + std::to_string(number) + "\nM99",
                     dialect, unit);
    return end(std::get<Move>(result.blocks.at(0).what).path).x();
  };
  const std::string letters = "ABCIJKDEFHMQRSTUVWXYZ", whole = "DEFHMST";
  const int numbers[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas})
    for (std::size_t i = 0; i < letters.size(); ++i) {
      CAPTURE(name(dialect), letters[i]);
      const double unit = whole.find(letters[i]) == std::string::npos ? 0.001 : 1;
      CHECK(passed(letters[i] + std::string("5"), numbers[i], dialect) == Approx(5 * unit));
      CHECK(passed(letters[i] + std::string("5."), numbers[i], dialect) == 5);
    }
  CHECK(passed("A[2+3]", 1, Dialect::haas) == 5);
  CHECK(passed("A5", 1, Dialect::linuxcnc) == 5);
  CHECK(passed("A5", 1, Dialect::fanuc, IntegerUnit::units) == 5);
  CHECK(passed("A5", 1, Dialect::fanuc, IntegerUnit::increments) == Approx(0.005));
  const Interpreted inch = run_integers("G20 G65 P2 A5\nM30\nO2\nG0 X#1\nM99", Dialect::haas);
  CHECK(end(std::get<Move>(inch.blocks.at(0).what).path).x() == Approx(0.0005 * 25.4));
}

TEST_CASE("an argument without a decimal point is reported once", "[ipr][dialects]") {
  const std::string text = "G65 P2 D5 A5 B3\nG65 P2 L2 A5.\nG65 P2 C0 C-7\nM30\nO2\nM99";
  const Interpreted result = run_integers(text, Dialect::haas);
  REQUIRE(places(result) == Places{"SC1057 1:11"});
  CHECK(result.diagnostics[0].message ==
        "A5 without a decimal point is the argument 0.005, in increments; a control that counts "
        "units passes 5 (here and on 1 more line)");
  CHECK(run_integers(text, Dialect::haas, IntegerUnit::units).diagnostics.empty());
  CHECK(run_integers(text, Dialect::fanuc, IntegerUnit::increments).diagnostics.empty());
  CHECK(run_integers(text, Dialect::linuxcnc).diagnostics.empty());
}

TEST_CASE("in haas a feed without a decimal point is reported once", "[ipr][dialects]") {
  const std::string text = "G1 X10. F10\nX20. F250.\nX30. F0\nX40. F30\nM98 P2\nM30\nO2\nM99";
  const Interpreted result = run_integers(text, Dialect::haas);
  REQUIRE_FALSE(result.diagnostics.empty());
  CHECK(places(result).back() == "SC1057 1:9");
  CHECK(result.diagnostics.back().message ==
        "F10 without a decimal point is a feed of 10; setting 77 of a Haas control may make it a "
        "tenth to a ten-thousandth of that (here and on 1 more line)");
  CHECK(places(run_integers("G1 X10. F10.\nX20. F#1\nM30", Dialect::haas)).empty());
  CHECK(places(run_integers("G1 X10. F10\nM30", Dialect::haas, IntegerUnit::units)).empty());
  CHECK(places(run_integers("G1 X10. F10\nM30", Dialect::fanuc)).empty());
}

TEST_CASE("units that the machine file states are not told", "[ipr][dialects]") {
  CHECK(places(run_integers("G0 X1000 Y0.5\nM30", Dialect::fanuc, IntegerUnit::units)).empty());
  CHECK(places(run_integers("G0 X1000 Y0.5\nM30")) == Places{"SC1057 1:4"});
}

TEST_CASE("linuxcnc and grbl have units whatever the machine", "[ipr][dialects]") {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::grbl}) {
    const Interpreted result = run_integers("G0 X7\nM2", dialect, IntegerUnit::increments);
    CHECK(end(std::get<Move>(result.blocks[0].what).path).x() == 7);
  }
}

}  // namespace softcnc::ipr
