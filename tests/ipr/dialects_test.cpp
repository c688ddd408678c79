// SPDX-License-Identifier: MIT
// What each dialect reads in its own way beside the table of differences. Expected values follow
// from the meaning that the manuals named in docs/gcode.md give to the words.
#include <catch2/catch.hpp>
#include <vector>

#include "ipr/ends.hpp"
#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

Interpreted interpret_in(const std::string& text, Dialect dialect) {
  return interpret(text, {}, in(dialect));
}

std::vector<double> dwells(const std::string& text, Dialect dialect) {
  std::vector<double> all;
  const Interpreted result = interpret(text, {}, in(dialect));
  for (const Diagnostic& one : result.diagnostics)
    if (one.severity() != Severity::note) FAIL(render(one));
  for (const Block& block : result.blocks)
    if (const auto* dwell = std::get_if<Dwell>(&block.what)) all.push_back(dwell->duration);
  return all;
}

std::size_t hole_count(const std::string& text, Dialect dialect) {
  std::size_t count = 0;
  for (const Move& move : moves_of(text, {}, in(dialect)))
    if (!move.rapid) ++count;
  return count;
}

}  // namespace

TEST_CASE("a dwell counts by the dialect, in haas by its decimal point", "[ipr][dialects]") {
  const std::string text = "G4 P5\nG4 P5.\nG0 Z5.\nG99 G82 X1. Z-1. R2. P0.5 F100.\nG80\nM30";
  CHECK(dwells(text, Dialect::linuxcnc) == std::vector<double>{5, 5, 0.5});
  CHECK(dwells(text, Dialect::grbl) == std::vector<double>{5, 5, 0.5});
  CHECK(dwells(text, Dialect::haas) == std::vector<double>{0.005, 5, 0.5});
  CHECK(dwells("G4 P500\nG0 Z5.\nG99 G82 X1. Z-1. R2. P500 F100.\nM30", Dialect::haas) ==
        std::vector<double>{0.5, 0.5});
  CHECK(dwells("G4 P5\nM30", Dialect::fanuc) == std::vector<double>{0.005});
}

TEST_CASE("cycles are repeated by K in fanuc, by L in haas", "[ipr][dialects]") {
  const std::string begin = "G0 Z5.\nG91 G99 G81 X1. Z-1. R-3. F100. ";
  CHECK(hole_count(begin + "K3\nM30", Dialect::fanuc) == 3);
  CHECK(hole_count(begin + "L3\nM30", Dialect::haas) == 3);
  CHECK(hole_count(begin + "L0\nX2.\nM30", Dialect::haas) == 1);
  const Interpreted refused = interpret_in(begin + "K3\nM30", Dialect::haas);
  CHECK(places(refused) == Places{"SC2007 2:33"});
}

TEST_CASE("M98 P of five digits is a number in haas, with a count in fanuc", "[ipr][dialects]") {
  const std::string text = "G91\nM98 P30002\nM30\nO30002\nG0 X1.\nM99\nO2\nG0 X5.\nM99";
  CHECK(places_along_x(text, Dialect::haas) == std::vector<double>{1});
  CHECK(places_along_x(text, Dialect::fanuc) == std::vector<double>{5, 10, 15});
}

TEST_CASE("E after a number is a word in fanuc and haas", "[ipr][dialects]") {
  const std::string text = "%\nO0020\nG65P0106F600E41.\nM30\nO0106\nG90G01X#8F#9\nM99\n%\n";
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    const auto moves = moves_of(text, {}, in(dialect));
    REQUIRE(moves.size() == 1);
    CHECK(end(moves[0].path).x() == 41);
    CHECK(moves[0].feed == 10);
  }
  CHECK(places(interpret_in("G0 X1E1\nM30", Dialect::fanuc)) == Places{"SC2004 1:6"});
  CHECK(places(interpret_in("G0 X1E1\nM30", Dialect::linuxcnc)) == Places{"SC1006 1:4"});
  CHECK(places(interpret_in("G0 X1E1\nM30", Dialect::grbl)) == Places{"SC1006 1:4"});
}

TEST_CASE("two letters of a keyword or a function are enough in fanuc and haas",
          "[ipr][dialects]") {
  const std::string loop =
      "#1=1\nWH[#1LE3]DO1\nG01X#1F100.\n#1=#1+1\nEN1\nIF[#1EQ4]TH#2=7\nIF[#1EQ4]GO20\nG0X99\n"
      "N20G0X#2\nGO30\nG0X98\nN30M30";
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    CHECK(places_along_x(loop, dialect) == std::vector<double>{1, 2, 3, 7});
    CHECK(places_along_x("G0XRO[1.2]\nX[SQ[16]+AB[-1]]\nX[FI[7.9]]\nX[FU[7.1]]\nM30", dialect)[1] ==
          Approx(5));
    CHECK_THAT(
        places_along_x("#1=CO[60]\nG0X[#1*4]\nX[SI[30]]\nX[AT[1]/[1]]\nX[EX[0]]\nM30", dialect),
        Catch::Matchers::Approx(std::vector<double>{2, 0.5, 45, 1}));
  }
  CHECK(places(interpret_in("#1=1\nWH[#1LE3]DO1\nM30", Dialect::linuxcnc))[0] == "SC1020 2:1");
  CHECK(places(interpret_in("G0 X[SI[30]]\nM30", Dialect::linuxcnc)) == Places{"SC1018 1:6"});
}

TEST_CASE("P of a cycle without a dwell has no effect in fanuc and haas", "[ipr][dialects]") {
  const std::string text = "G0 Z10.\nG99 G81 X1. Z-1. R1. P500 F100.\nX2. P600\nG85 X3.\nG80\nM30";
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas}) {
    const Interpreted result = interpret_in(text, dialect);
    CHECK(places(result) == Places{"SC2230 2:22"});
    CHECK(result.blocks.size() ==
          interpret_in("G0 Z10.\nG99 G81 X1. Z-1. R1. F100.\nX2.\nG85 X3.\nG80\nM30", dialect)
              .blocks.size());
  }
  CHECK(places(interpret_in("G0 Z10.\nG99 G81 X1. Z-1. R1. P500 F100.\nM30", Dialect::linuxcnc)) ==
        Places{"SC2004 2:22"});
}

TEST_CASE("H beside G41 or G42 asks for D in fanuc", "[ipr][dialects]") {
  const std::string text = "G1 F100.\nG42 H19 Y10.\nX50.\nG40 Y-10.\nM30";
  const Interpreted result = interpret_in(text, Dialect::fanuc);
  CHECK(places(result) == Places{"SC2231 2:5"});
  CHECK(result.diagnostics[0].message ==
        "H19 beside G42 is the number of a length; the radius is that of D: D19");
}

TEST_CASE("grbl starts in G00", "[ipr][dialects]") {
  const std::string text = "G21 G90\nZ5\nX10 Y10\nG1 Z-1 F100.\nM2";
  const auto moves = moves_of(text, {}, in(Dialect::grbl));
  REQUIRE(moves.size() == 3);
  CHECK(moves[0].rapid);
  CHECK(moves[1].rapid);
  CHECK_FALSE(moves[2].rapid);
  CHECK(near(end(moves[1].path), {10, 10, 5}));
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::haas})
    CHECK(places(interpret_in(text, dialect))[0] == "SC2101 2:1");
}

TEST_CASE("grbl's senders' lines are skipped with one note", "[ipr][dialects]") {
  const Interpreted result =
      interpret_in("$H\n$X\n?\nG1 X1 F100*57\n N10 X2*7 \n$J=G91 X10 F500\n!\n~\n$110=500\nX3\nM2",
                   Dialect::grbl);
  CHECK(places(result) == Places{"SC1055 1:1"});
  CHECK(result.diagnostics[0].message ==
        "what is meant for a sender of grbl is skipped, here and on 8 more lines");
  std::vector<double> ends;
  for (const Block& block : result.blocks)
    if (const auto* move = std::get_if<Move>(&block.what)) ends.push_back(end(move->path).x());
  CHECK(ends == std::vector<double>{1, 2, 3});
}

TEST_CASE("elsewhere each of them is an error that names the dialect", "[ipr][dialects]") {
  for (const Dialect dialect : {Dialect::linuxcnc, Dialect::fanuc, Dialect::haas}) {
    for (const char* line : {"$H", "$$", "$J=G91 X1 F9.", "?", "!", "~", "$N0=G54", "$RST=*"}) {
      CAPTURE(line);
      const Interpreted result = interpret_in(std::string(line) + "\nM2", dialect);
      REQUIRE(places(result) == Places{"SC1054 1:1"});
      CHECK(result.diagnostics[0].message.find("--dialect grbl") != std::string::npos);
    }
    CHECK(places(interpret_in("G1 F9.\nX1*57\nM2", dialect)) == Places{"SC1054 2:3"});
  }
  CHECK(places(interpret_in("$0 M3 S100\nM2", Dialect::linuxcnc)) == Places{"SC1001 1:1"});
  const Interpreted product = interpret_in("#1=2\nG0 X[#1*57]\nM2", Dialect::grbl);
  CHECK(places(product) == Places{"SC1056 1:1"});
  CHECK(product.blocks.size() == 2);
}

}  // namespace softcnc::ipr
