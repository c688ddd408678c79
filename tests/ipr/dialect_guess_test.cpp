// SPDX-License-Identifier: MIT
// Programs as they are written for each control, and the dialect that their lines show.
#include "ipr/dialects/dialect_guess.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "ipr/interpret.hpp"

namespace softcnc::ipr {
namespace {

DialectGuess guess(const std::string& text) {
  DialectGuess guess;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) guess.see(line, ++number);
  return guess;
}

std::string shown(const std::string& text) {
  const DialectGuess found = guess(text);
  if (!found.dialect()) return "none";
  return std::string(name(*found.dialect())) + " " + std::to_string(found.line()) + " " +
         found.mark();
}

}  // namespace

TEST_CASE("a program shows its dialect", "[ipr][dialects]") {
  CHECK(shown("%\nO1234\n#100=5\nWHILE[#100 LT 9]DO1\nG65 P9001 A1\nEND1\nM30\n%") ==
        "fanuc 4 WHILE DO");
  CHECK(shown("%\nO1234\nG90 G54.1 P3 G0 X0. Y0.\nM30\n%") == "fanuc 3 G54.1");
  CHECK(shown("O1\nG0 X1.\n#1=#2+1\nM30") == "fanuc 3 an operator without brackets");
  CHECK(shown("%\nO1234\nG154 P3 G0 X0. Y0.\nM30\n%") == "haas 3 G154");
  CHECK(shown("G0 X1.\nG12 I1. D1 F9.\nG187 P2\nM97 P100\nM30") == "haas 2 G12");
  CHECK(shown("G110 G0 X0\nM30") == "haas 1 G110");
  CHECK(shown("G0 X0\no<hole> sub\no<hole> endsub\nM2") == "linuxcnc 2 an O-word");
  CHECK(shown("o100 call [1]\nM2") == "linuxcnc 1 an O-word");
  CHECK(shown("#<depth>=3\nG0 Z#<depth>\nM2") == "linuxcnc 1 a variable with a name");
  CHECK(shown("$H\nG0 X1\nM2") == "grbl 1 a line for a sender of grbl");
  CHECK(shown("(made for grbl)\nG0 X1\nM2") == "grbl 1 'GRBL' in a comment");
  CHECK(shown("G21 G90\nX1 Y2\nG1 X2 F100\nM2") == "grbl 2 coordinates before any motion code");
  CHECK(shown("N10 G0 X1*57\nN20 X2*3\nM2") == "grbl 1 a checksum of a sender");
}

TEST_CASE("what every control has shows none", "[ipr][dialects]") {
  for (const char* text : {"", "G21 G90\nG0 X1 Y2\nG1 Z-1 F100\nM30", "%\nG0 X1\nM30\n%",
                           "O0001\nG0 X1.\nM30", "G92 X0 Y0\nG28 X0\nG10 L2 P1 X0\nG0 X1\nM30",
                           "G81 X1 Z-1 R1 F100\nX2\nM30", "(for LinuxCNC and FANUC)\nG0 X1\nM30",
                           "G43 H1 Z5.\nG0 X1.\nM30", "#1=3\nG0 X[#1*57]\nM30"}) {
    CAPTURE(text);
    CHECK(shown(text) == "none");
  }
}

TEST_CASE("a text in another encoding shows no dialect", "[ipr][dialects]") {
  using namespace std::string_literals;
  CHECK(shown("X\0001\0\n\0X\0002\0\n"s) == "none");
}

TEST_CASE("with auto the program is read in the dialect that it shows", "[ipr][dialects]") {
  InterpreterOptions options;
  options.guess_dialect = true;
  const Interpreted haas = interpret("%\nO1\nG154 X1.\nG04 P500\nM30\n%", {}, options);
  REQUIRE_FALSE(haas.diagnostics.empty());
  CHECK(places(haas)[0] == "SC1058 3:0");
  CHECK(haas.diagnostics[0].message == "the program is read in the haas dialect; G154 shows it");
  CHECK(haas.diagnostics[0].source_line == "G154 X1.");
  const Interpreted grbl = interpret("$H\nX1\nM2", {}, options);
  CHECK(places(grbl) == Places{"SC1058 1:0", "SC1055 1:1"});
  const Interpreted fanuc = interpret("O1\n#1=2\n#1=#1+3\nG0 X#1\nG4 P250\nM30\n", {}, options);
  REQUIRE(fanuc.blocks.size() == 3);
  CHECK(std::get<Dwell>(fanuc.blocks[1].what).duration == 0.25);
  const Interpreted none = interpret("G0 X1\nM2", {}, options);
  CHECK(places(none) == Places{"SC1058 0:0"});
  CHECK(none.diagnostics[0].message ==
        "the program is read in the linuxcnc dialect; its first lines show no other");
}

TEST_CASE("a pipe is read as far as the dialect needs it", "[ipr][dialects]") {
  Reader reader = Reader::fed();
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  const Machine machine;
  InterpreterOptions options;
  options.guess_dialect = true;
  Interpreter interpreter(parser, machine, diagnostics, options);
  REQUIRE(reader.feed("G21\nX1\n"));
  CHECK_FALSE(interpreter.next());
  CHECK(interpreter.waiting());
  CHECK(diagnostics.all().empty());
  REQUIRE(reader.feed("M2\n"));
  reader.end_feed();
  const auto block = interpreter.next();
  REQUIRE(block);
  CHECK(std::get<Move>(block->what).rapid);
  REQUIRE(diagnostics.all().size() == 1);
  CHECK(diagnostics.all()[0].code == Code::SC1058);
}

}  // namespace softcnc::ipr
