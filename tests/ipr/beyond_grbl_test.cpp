// SPDX-License-Identifier: MIT
// What the grbl dialect runs and grbl 1.1 refuses: one note for each code and file.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "ipr/dialects/grbl_reading.hpp"
#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

using Notes = std::vector<std::string>;

/// "2:1 G81, which it does not have", of all that is noted of grbl.
Notes noted(const std::string& text, Dialect dialect = Dialect::grbl) {
  InterpreterOptions options;
  options.dialect = dialect;
  options.unreachable_too = true;
  const std::string begin = "grbl 1.1 refuses ";
  Notes all;
  for (const Diagnostic& d : interpret(text, {}, options).diagnostics) {
    if (d.code != Code::SC1056) continue;
    CHECK(d.severity() == Severity::note);
    const bool refuses = d.message.starts_with(begin);
    all.push_back(std::to_string(d.pos.line) + ":" + std::to_string(d.pos.column) + " " +
                  (refuses ? d.message.substr(begin.size()) : d.message));
  }
  return all;
}

/// The program of an arc from (0, 0) to (x, 0) about (i, 0).
Notes arc_noted(const std::string& x, const std::string& i) {
  return noted("F100 G2 X" + x + " I" + i + "\nM2\n");
}

}  // namespace

TEST_CASE("a code that grbl does not have is noted once, and runs", "[ipr][grbl]") {
  const std::string cycles = "G98\nG81 X1 Z-1 R1 F9\nX2\nG80\nG81 X3 Z-1 R1\nG80\nM2\n";
  CHECK(noted(cycles) ==
        Notes{"1:1 G98, which it does not have", "2:1 G81, which it does not have"});
  CHECK(noted(cycles, Dialect::linuxcnc).empty());
  InterpreterOptions options;
  options.dialect = Dialect::grbl;
  CHECK(interpret(cycles, {}, options).blocks.size() ==
        interpret(cycles, {}, InterpreterOptions{}).blocks.size());
  CHECK(noted("F100\nG41.1 D3 G1 X10\nX20\nG40 X30\nM2\n") ==
        Notes{"2:1 G41.1, which it does not have"});
  CHECK(noted("F100\nG5 X3 I1 J1 P-1 Q1\nM2\n") == Notes{"2:1 G05, which it does not have"});
  CHECK(noted("T1 M6\nG43 H1\nG64\nG61.1\nG90.1\nM2\n") ==
        Notes{"1:4 M06, which it does not have", "2:1 G43, which it does not have",
              "3:1 G64, which it does not have", "4:1 G61.1, which it does not have",
              "5:1 G90.1, which it does not have"});
  CHECK(noted("M98 P2\nM98 P2\nM2\nO2\nM99\n") ==
        Notes{"1:1 M98, which it does not have", "5:1 M99, which it does not have"});
}

TEST_CASE("the codes of grbl are not noted", "[ipr][grbl]") {
  CHECK(noted("G17 G21 G40 G49 G54 G61 G80 G90 G91.1 G94\nG10 L2 P1 X0\nG10 L20 P2 Y0\nG28.1\n"
              "G30.1\nG28 Z0\nG30 Z0\nG43.1 Z0\nG53 G0 X1\nG92 X0\nG92.1\nG4 P0\nG55\nG56\nG57\n"
              "G58\nG59\nG18\nG19\nG17\nG20\nG21\nG91\nG90\nS9 M3\nM4\nM5\nM7\nM8\nM9\nM0\nM1\n"
              "F100 G1 X2\nG2 X4 I1\nG3 X2 R1\nG93 G1 X1 F1\nN9 T1\nM30\n") == Notes{});
}

TEST_CASE("words, offsets of tools and what is computed are noted, too", "[ipr][grbl]") {
  CHECK(noted("G10 L1 P1 R2\nG10 L1 P2 R2\nG10 L20 P1 X0\nM2\n") ==
        Notes{"1:5 G10 L1; it has L2 and L20"});
  CHECK(noted("@3 ^30\nM2\n") ==
        Notes{"1:1 the word @, which it does not have", "1:4 the word ^, which it does not have"});
  const std::string computed = " grbl 1.1 has no O-words, variables and expressions";
  CHECK(noted("#1=2\nX#1\nX[1+1]\nM2\n") == Notes{"1:1" + computed});
  CHECK(noted("(#1 and [2]) X1 ; o1 sub\nX[1+1]\nM2\n") == Notes{"2:2" + computed});
  CHECK(noted("X1\no1 repeat [2]\nY1\no1 endrepeat\nM2\n") == Notes{"2:1" + computed});
}

TEST_CASE("nothing is noted of a line with an error", "[ipr][grbl]") {
  CHECK(noted("G81 X..1\nG205 Q1\nG64 X1..2\nX[1+\nM2\n") == Notes{});
}

TEST_CASE("turns of arcs, and ends that are too far off their circle, are noted", "[ipr][grbl]") {
  CHECK(noted("F100 G2 X2 I1 P2\nG2 X0 I-1 P3\nM2\n") == Notes{"1:15 P, the turns of an arc"});
  const std::string off = " mm, more than 0.005 mm and 0.1 % of the radius, or than 0.5 mm";
  CHECK(arc_noted("2.005", "1") == Notes{});
  CHECK(arc_noted("2.006", "1") == Notes{"1:9 an arc whose radii differ by 0.006" + off});
  CHECK(arc_noted("40.02", "20") == Notes{});
  CHECK(arc_noted("40.021", "20") == Notes{"1:9 an arc whose radii differ by 0.021" + off});
  CHECK(arc_noted("1800.5", "900") == Notes{});
  CHECK(arc_noted("1800.6", "900") == Notes{"1:9 an arc whose radii differ by 0.6" + off});
  CHECK(noted("F100 G2 X2.006 R1.003\nM2\n") == Notes{});
  CHECK(noted("F100 G20 G2 X0.0802 I0.04\nM2\n").size() == 1);  // 0.0051 mm
}

TEST_CASE("of radii that differ grbl takes what its parser does", "[ipr][grbl]") {
  CHECK(takes_grbl_radii(1, 1.005));
  CHECK_FALSE(takes_grbl_radii(1, 1.0051));
  CHECK_FALSE(takes_grbl_radii(1, 0.9949));
  CHECK(takes_grbl_radii(10, 9.99));
  CHECK_FALSE(takes_grbl_radii(10, 10.0101));
  CHECK(takes_grbl_radii(1000, 1000.5));
  CHECK_FALSE(takes_grbl_radii(1000, 999.4999));
}

TEST_CASE("a called file is noted by itself", "[ipr][grbl]") {
  const auto folder = std::filesystem::temp_directory_path() / "softcnc_beyond_grbl";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "part.nc") << "o<part> sub\nG64\nG64\no<part> endsub\n";
  InterpreterOptions options;
  options.dialect = Dialect::grbl;
  options.folder = folder.string();
  Places all;
  for (const Diagnostic& d :
       interpret("G64\no<part> call\no<part> call\nM2\n", {}, options).diagnostics)
    all.push_back(std::to_string(d.pos.file) + " " + std::to_string(d.pos.line));
  std::filesystem::remove_all(folder);
  CHECK(all == Places{"0 1", "0 2", "1 2", "1 4"});
}

}  // namespace softcnc::ipr
