// SPDX-License-Identifier: MIT
// The canned cycles as Haas' mills have them: without R, taps that start the spindle, pecks that
// lessen, and patterns of holes (G70 to G72). Haas' mill operator's manual, by the code.
#include <catch2/catch.hpp>
#include <cmath>

#include "ipr/cycle_stops.hpp"
#include "ipr/interpret.hpp"
#include "ipr/reported.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

/// Of cycles, from Z20 on, while the spindle stands.
std::string haas_stops(const std::string& text) {
  return stops_behind("R0,0,20 ", "F100. S500 G00 Z20.\n" + text + "\nM30\n", kHaas);
}

/// Where the feeds down to Z-5 end.
std::vector<AxisVector> haas_holes(const std::string& text) {
  std::vector<AxisVector> all;
  for (const Move& move : moves_of("F100. G00 Z20.\n" + text + "\nM30\n", {}, kHaas))
    if (!move.rapid && std::abs(end(move.path).z() + 5) < 1e-9) all.push_back(end(move.path));
  return all;
}

/// Whether the text makes holes at these angles, degrees, and distances from a place of X Y.
void check_holes(const std::string& text, const AxisVector& centre,
                 const std::vector<std::pair<double, double>>& wanted) {
  CAPTURE(text);
  const auto all = haas_holes(text);
  REQUIRE(all.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto [angle, distance] = wanted[i];
    CAPTURE(i, angle, all[i].x(), all[i].y());
    CHECK(near(all[i], {centre.x() + distance * std::cos(rad_from_deg(angle)),
                        centre.y() + distance * std::sin(rad_from_deg(angle)), -5}));
  }
}

const std::string kDrill = "G98 G81 Z-5. R1. L0\n";

}  // namespace

TEST_CASE("without R Haas' cycles begin at the height of the start", "[ipr][cycles][haas]") {
  CHECK(haas_stops("G99 G81 X1. Z-5.\nX2.") == "R1,0,20 F1,0,-5 R1,0,20 R2,0,20 F2,0,-5 R2,0,20 ");
  CHECK(haas_stops("G98 G83 X1. Z-5. Q20.\nX2. R2.") ==
        "R1,0,20 F1,0,0 R1,0,20 R1,0,0.254 F1,0,-5 R1,0,20 R2,0,20 R2,0,2 F2,0,-5 R2,0,20 ");
  CHECK(haas_stops("G91 G99 G81 X1. Z-25.\nX2.") ==
        "R1,0,20 F1,0,-5 R1,0,20 R3,0,20 F3,0,-5 R3,0,20 ");
  CHECK(haas_stops("G99 G81 X1. Z-5. R1.\nG82 X2. Z-6. P.5") ==
        "R1,0,20 R1,0,1 F1,0,-5 R1,0,1 R2,0,1 F2,0,-6 D0.5 R2,0,1 ");
  CHECK(reported("F1. G81 X1. Z-5.", Dialect::fanuc) == Places{"SC2005 1:5"});
}

TEST_CASE("Haas' taps start the spindle and leave it as it was", "[ipr][cycles][haas]") {
  CHECK(haas_stops("G98 G84 X1. Z-6. R1.\nX2.") ==
        "R1,0,20 R1,0,1 S500 F1,0,-6 S-500 F1,0,1 S0 R1,0,20 "
        "R2,0,20 R2,0,1 S500 F2,0,-6 S-500 F2,0,1 S0 R2,0,20 ");
  CHECK(haas_stops("G99 G74 X1. Z-6. R1. P.5") ==
        "R1,0,20 R1,0,1 S-500 F1,0,-6 S500 D0.5 F1,0,1 S0 ");
  CHECK(haas_stops("M03\nG99 G84 X1. Z-6. R1.") ==
        "S500 R1,0,20 R1,0,1 F1,0,-6 S-500 F1,0,1 S500 ");
  CHECK(haas_stops("M04\nG99 G84 X1. Z-6. R1.") ==
        "S-500 R1,0,20 R1,0,1 S500 F1,0,-6 S-500 F1,0,1 S-500 ");
  CHECK(haas_reported("T1 M06\nG00 G90 X2. Y2. Z5.\nG84 Z-6. R1. F500. S500\nG80").empty());
  CHECK(haas_reported("F1. G84 X1. Z-5. R1.") == Places{"SC2163 1:5"});
  CHECK(haas_reported("F1. S0 G84 X1. Z-5. R1.") == Places{"SC2163 1:8"});
  CHECK(haas_reported("F1. S..9\nG84 X1. Z-5. R1.") == Places{"SC1004 1:6"});
  CHECK(reported("F1. S9 G84 X1. Z-5. R1.", Dialect::fanuc) == Places{"SC2163 1:8"});
  CHECK(haas_reported("F1. S9 G84 X1. Z-5. R1.\nG86 X2.") == Places{"SC2163 2:1"});
}

TEST_CASE("a feed per turn counts in a tap that starts the spindle", "[ipr][cycles][haas]") {
  const auto moves = moves_of("G95 F1.25 S600\nG00 Z5.\nG99 G84 X1. Z-6. R1.\nM30\n", {}, kHaas);
  REQUIRE(moves.size() == 5);
  CHECK(moves[3].feed == Approx(1.25 * 10));
  CHECK(moves[4].feed == Approx(1.25 * 10));
  CHECK(haas_reported("G95 F1.25 S600\nG00 Z5.\nG99 G84 X1. Z-6. R1.\nG80 G01 X2.") ==
        Places{"SC2222 4:5"});
}

TEST_CASE("Haas' pecks lessen by J from I down to K", "[ipr][cycles][haas]") {
  CHECK(haas_stops("G98 G73 X1. Z-10. R2. I4. J1. K2.") ==
        "R1,0,20 R1,0,2 F1,0,-2 R1,0,-1.746 F1,0,-5 R1,0,-4.746 F1,0,-7 R1,0,-6.746 "
        "F1,0,-9 R1,0,-8.746 F1,0,-10 R1,0,20 ");
  CHECK(haas_stops("G99 G83 X1. Z-10. R2. I4. J2. K3.\nX2. Z-2.") ==
        "R1,0,20 R1,0,2 F1,0,-2 R1,0,2 R1,0,-1.746 F1,0,-5 R1,0,2 R1,0,-4.746 F1,0,-8 R1,0,2 "
        "R1,0,-7.746 F1,0,-10 R1,0,2 R2,0,2 F2,0,-2 R2,0,2 ");
  CHECK(haas_stops("G99 G83 X1. Z-4. R2. I4. J0 K1.\nG83 X2. Q5.") ==
        "R1,0,20 R1,0,2 F1,0,-2 R1,0,2 R1,0,-1.746 F1,0,-4 R1,0,2 "
        "R2,0,2 F2,0,-3 R2,0,2 R2,0,-2.746 F2,0,-4 R2,0,2 ");
  CHECK(haas_stops("G20 G99 G83 X1. Z-.2 R.1 I.2 J.1 K.1") ==
        "R25.4,0,20 R25.4,0,2.54 F25.4,0,-2.54 R25.4,0,2.54 R25.4,0,-2.286 F25.4,0,-5.08 "
        "R25.4,0,2.54 ");
  CHECK(haas_stops("G51 Z0 P2.\nG99 G83 X0 Z-3. R1. I4. J1. K1.") ==
        "R0,0,2 F0,0,-2 R0,0,2 R0,0,-1.746 F0,0,-5 R0,0,2 R0,0,-4.746 F0,0,-6 R0,0,2 ");
}

TEST_CASE("Haas' G73 goes out to R after the depth of K", "[ipr][cycles][haas]") {
  CHECK(haas_stops("G98 G73 X1. Z-8. R2. Q2. K4.") ==
        "R1,0,20 R1,0,2 F1,0,0 R1,0,0.254 F1,0,-2 R1,0,2 R1,0,-1.746 F1,0,-4 R1,0,-3.746 "
        "F1,0,-6 R1,0,2 R1,0,-5.746 F1,0,-8 R1,0,20 ");
  CHECK(haas_stops("G99 G73 X1. Z-2. R2. Q2. K1.\nX2. Q3.") ==
        "R1,0,20 R1,0,2 F1,0,0 R1,0,2 R1,0,0.254 F1,0,-2 R1,0,2 "
        "R2,0,2 F2,0,-1 R2,0,2 R2,0,-0.746 F2,0,-2 R2,0,2 ");
}

TEST_CASE("words of pecks that do not fit are refused", "[ipr][cycles][haas]") {
  const auto of = [](const std::string& words, InterpreterOptions options = kHaas) {
    return reported("F9. G00 Z5.\nG99 G73 X1. Z-5. R1. " + words, options);
  };
  CHECK(of("I1. J.1 K.5").empty());
  CHECK(of("I1. K.5") == Places{"SC2005 2:22"});
  CHECK(of("I0 J0 K1.") == Places{"SC2007 2:22"});
  CHECK(of("I1. J-.1 K1.") == Places{"SC2007 2:22"});
  CHECK(of("I1. J.1 K.5 Q1.") == Places{"SC2007 2:34"});
  CHECK(of("K1.") == Places{"SC2007 2:22"});
  CHECK(of("Q1. K0") == Places{"SC2007 2:26"});
  CHECK(of("Q1. I2.", kFanuc) == Places{"SC2004 2:26"});
  CHECK(of("I.0001 J0 K.0001") == Places{"SC2007 2:5"});
  CHECK(haas_reported("F9. G00 Z5.\nG99 G83 X1. Z-5. R1. Q1. K2.") == Places{"SC2007 2:26"});
}

TEST_CASE("G70 drills a circle", "[ipr][cycles][haas][patterns]") {
  check_holes(kDrill + "G70 I10. J0 L4", {0, 0, 0}, {{0, 10}, {90, 10}, {180, 10}, {270, 10}});
  CHECK(haas_holes(kDrill + "G70 I10. J0 L4").at(3) == AxisVector(0, -10, -5));
  check_holes(kDrill + "G70 I5. J15. L3", {0, 0, 0}, {{15, 5}, {135, 5}, {255, 5}});
  check_holes(kDrill + "G70 I-5. J15. L3", {0, 0, 0}, {{15, 5}, {255, 5}, {135, 5}});
  check_holes(kDrill + "G70 X3. Y-4. I2. L1", {3, -4, 0}, {{0, 2}});
  check_holes("G00 X7. Y2.\n" + kDrill + "G91 G70 X3. I2. L2\nG90", {10, 2, 0}, {{0, 2}, {180, 2}});
  check_holes("G98 G81 Z-5. R1. G70 I10. J30. L2", {0, 0, 0}, {{30, 10}, {210, 10}});
  check_holes("G98 G81 X2. Z-5. R1. G70 I10. L1", {2, 0, 0}, {{0, 10}});
  check_holes("G20\nG98 G81 Z-.19685039370 R.1 L0\nG70 I1. J90. L1", {0, 0, 0}, {{90, 25.4}});
}

TEST_CASE("G71 drills an arc, G72 a line", "[ipr][cycles][haas][patterns]") {
  check_holes(kDrill + "G71 I5. J30. K20. L3", {0, 0, 0}, {{30, 5}, {50, 5}, {70, 5}});
  check_holes(kDrill + "G71 I5. J30. K-20. L3", {0, 0, 0}, {{30, 5}, {10, 5}, {-10, 5}});
  check_holes(kDrill + "G71 X1. Y1. I5. K60. L2", {1, 1, 0}, {{0, 5}, {60, 5}});
  check_holes(kDrill + "G72 I2. J45. L3", {0, 0, 0}, {{0, 0}, {45, 2}, {45, 4}});
  check_holes(kDrill + "G72 X1. Y2. I2. L2", {1, 2, 0}, {{0, 0}, {0, 2}});
}

TEST_CASE("a pattern is made by the cycle in force", "[ipr][cycles][haas][patterns]") {
  CHECK(haas_stops(kDrill + "G72 I3. L2\nX9.") ==
        "R0,0,1 F0,0,-5 R0,0,20 R3,0,20 R3,0,1 F3,0,-5 R3,0,20 R9,0,20 R9,0,1 F9,0,-5 R9,0,20 ");
  CHECK(haas_stops("G99 G84 Z-5. R1. L0\nG72 X1. I3. L2\nG80") ==
        "R1,0,20 R1,0,1 S500 F1,0,-5 S-500 F1,0,1 S0 R4,0,1 S500 F4,0,-5 S-500 F4,0,1 S0 ");
  CHECK(haas_stops("G99 G83 Z-5. R1. I4. J1. K1. L0\nG72 I3. L1\nG80") ==
        "R0,0,1 F0,0,-3 R0,0,1 R0,0,-2.746 F0,0,-5 R0,0,1 ");
  CHECK(haas_stops("G68 X0 Y0 R90.\n" + kDrill + "G72 X1. Y0 I3. L1\nG80") ==
        "R0,1,20 R0,1,1 F0,1,-5 R0,1,20 ");
  CHECK(haas_stops("G18 G99 G81 Y-5. R1. L0\nG72 X3. I2. L2\nG80") ==
        "R0,1,20 R3,1,20 F3,-5,20 R3,1,20 R3,1,22 F3,-5,22 R3,1,22 ");
  CHECK(
      near(last_place("F9. G00 Z5.\n" + kDrill + "G70 I10. L4\nG80 G91 G00 X1. Z1.\nM30\n", kHaas),
           {1, -10, 6}));
}

TEST_CASE("beside a pattern K is no depth of G73", "[ipr][cycles][haas][patterns]") {
  const InterpreterOptions check{.dialect = Dialect::haas, .compare_dialects = true};
  const std::string begin = "G98 F9. G00 Z5.\n";
  CHECK(reported(begin + "G73 Z-5. R1. Q2. K4. X1.", check) == Places{"SC2387 2:18"});
  CHECK(reported(begin + "G73 Z-5. R1. Q2. G71 I5. K30. L2", check).empty());
  CHECK(haas_stops("G99 G73 Z-4. R1. Q3. G71 I5. K90. L1\nG80") ==
        "R5,0,20 R5,0,1 F5,0,-2 R5,0,-1.746 F5,0,-4 R5,0,1 ");
}

TEST_CASE("patterns that cannot be made are refused", "[ipr][cycles][haas][patterns]") {
  const auto of = [](const std::string& line, InterpreterOptions options = kHaas) {
    return reported("F9. G00 Z5.\n" + kDrill + line, options);
  };
  CHECK(of("G70 I5. L4").empty());
  CHECK(of("G70 L4") == Places{"SC2005 3:1"});
  CHECK(of("G72 I5.") == Places{"SC2005 3:1"});
  CHECK(of("G71 I5. L4") == Places{"SC2005 3:1"});
  CHECK(of("G70 I0 L4") == Places{"SC2007 3:5"});
  CHECK(of("G72 I0. J30. L4") == Places{"SC2007 3:5"});
  CHECK(of("G70 I5. L0") == Places{"SC2007 3:9"});
  CHECK(of("G70 I5. L1.5") == Places{"SC2007 3:9"});
  CHECK(of("G70 I5. L10001") == Places{"SC2007 3:9"});
  CHECK(of("G70 I5. L4 Z-2.") == Places{"SC2004 3:12"});
  CHECK(of("G70 I5. L4 K3.") == Places{"SC2004 3:12"});
  CHECK(of("G72 I999999. L3") == Places{"SC3008 3:1"});
  CHECK(of("G80\nG70 I5. L4") == Places{"SC2101 4:1"});
  CHECK(of("G16\nG70 X1. I5. L4") == Places{"SC2251 4:1"});
  CHECK(haas_reported("G70 I5. L4") == Places{"SC2101 1:1"});
  CHECK(haas_reported("F9. G00 Z5.\nG81 R1. L0\nG70 I5. L4") == Places{"SC2160 2:1"});
  CHECK(haas_reported("F9. G00 Z5.\nG81 X0 R1. L0\nG70 I5. L4") == Places{"SC2005 2:1"});
  CHECK(haas_reported("F9. G00 Z5.\nG41.1 D1. G01 X9.\nG70 I5. L4\nG40") == Places{"SC2140 3:1"});
  CHECK(reported("G70 I5. L4", Dialect::fanuc) == Places{"SC2001 1:1"});
  CHECK(reported("G71 I5. L4") == Places{"SC2001 1:1"});
}

TEST_CASE("G47, G150 and M109 are refused with what they do", "[ipr][haas]") {
  const auto said = [](const std::string& line) {
    const Interpreted result = interpret(line + "\nG00 X1.\nM30\n", {}, kHaas);
    REQUIRE(result.diagnostics.size() == 1);
    CHECK(result.diagnostics[0].code == Code::SC2114);
    return result.diagnostics[0].message;
  };
  CHECK(said("G47 P0 X2. Y2. I45. J.5 R.05 Z-.005 F15. E10. (TEXT)") ==
        "G47 is refused: it engraves a text or a serial number in the letters of the control");
  CHECK(said("G150 P1001 Z-1. G41 D1 J1. Q1. R.1 K.1 F9.") ==
        "G150 is refused: it clears a pocket whose outline is the program of P, by paths of the "
        "control");
  CHECK(said("M109 P501 (Y OR N?)") ==
        "M109 is refused: it shows a text to the operator and puts the key pressed into the "
        "variable of P");
  CHECK(reported("G47 P0", Dialect::fanuc) == Places{"SC2001 1:1"});
  CHECK(reported("M109", Dialect::fanuc) == Places{"SC2001 1:1"});
  CHECK(interpret("M109\nM30\n", {}, {}).diagnostics[0].message.find("[mcode.109]") !=
        std::string::npos);
}

}  // namespace softcnc::ipr
