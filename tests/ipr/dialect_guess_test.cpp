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

std::string guessed(const std::string& text) {
  const DialectGuess found = guess(text);
  if (!found.dialect()) return "none";
  return std::string(name(*found.dialect())) + " " + std::to_string(found.line()) + " " +
         found.mark();
}

}  // namespace

TEST_CASE("a program shows its dialect", "[ipr][dialects]") {
  CHECK(guessed("%\nO1234\n#100=5\nWHILE[#100 LT 9]DO1\nG65 P9001 A1\nEND1\nM30\n%") ==
        "fanuc 4 WHILE DO");
  CHECK(guessed("%\nO1234\nG90 G54.1 P3 G0 X0. Y0.\nM30\n%") == "fanuc 3 G54.1");
  CHECK(guessed("O1\nG0 X1.\n#1=#2+1\nM30") == "fanuc 3 an operator without brackets");
  CHECK(guessed("%\nO1234\nG154 P3 G0 X0. Y0.\nM30\n%") == "haas 3 G154");
  CHECK(guessed("G0 X1.\nG12 I1. D1 F9.\nG187 P2\nM97 P100\nM30") == "haas 2 G12");
  CHECK(guessed("G110 G0 X0\nM30") == "haas 1 G110");
  CHECK(guessed("G0 X0\no<hole> sub\no<hole> endsub\nM2") == "linuxcnc 2 an O-word");
  CHECK(guessed("o100 call [1]\nM2") == "linuxcnc 1 an O-word");
  CHECK(guessed("#<depth>=3\nG0 Z#<depth>\nM2") == "linuxcnc 1 a variable with a name");
  CHECK(guessed("$H\nG0 X1\nM2") == "grbl 1 a line for a sender of grbl");
  CHECK(guessed("(made for grbl)\nG0 X1\nM2") == "grbl 1 'GRBL' in a comment");
  CHECK(guessed("G21 G90\nX1 Y2\nG1 X2 F100\nM2") == "grbl 2 coordinates before any motion code");
  CHECK(guessed("N10 G0 X1*57\nN20 X2*3\nM2") == "grbl 1 a checksum of a sender");
}

TEST_CASE("what every control has shows none", "[ipr][dialects]") {
  for (const char* text : {"", "G21 G90\nG0 X1 Y2\nG1 Z-1 F100\nM30", "%\nG0 X1\nM30\n%",
                           "G92 X0 Y0\nG28 X0\nG10 L2 P1 X0\nG0 X1\nM30",
                           "G81 X1 Z-1 R1 F100\nX2\nM30", "(for LinuxCNC and FANUC)\nG0 X1\nM30",
                           "G43 H1 Z5.\nG0 X1.\nM30", "#1=3\nG0 X[#1*57]\nM30"}) {
    CAPTURE(text);
    CHECK(guessed(text) == "none");
  }
}

TEST_CASE("the number of a program alone shows fanuc", "[ipr][dialects]") {
  // Heads as posts and people write them: Fusion, Mastercam, HSMWorks, SolidCAM, Edgecam, GibbsCAM,
  // BobCAD, NX, by hand; with coordinates before any G00, G64, G33 and M62 after them.
  for (const char* text :
       {"%\nO1001 (FACE)\nN10 G90 G94 G17\nN15 G21\nN20 G28 G91 Z0.\n",
        "%\nO0000(CONTOUR)\n(DATE=DD-MM-YY - 01-01-25)\nN100 G21\nN102 G0 G17 G40 G49 G80 G90\n",
        "O0007 (PLATE)\nT1 M6\nG54\nG0 G90 X10. Y10.\nG0 G91 G28 Z0\nM30\n", "%\n:0012\nG0 X1.\n",
        "%\nO00012\nT5 M06\nG00 G90 G54 X0 Y0 S5000 M03\n", "%\n<PLATE>\nG0 X1.\n",
        "%\n\n(TOOL 1)\nO12345678\nG0 X1.\n", "O7\nG0 X1.\nM30", "o0012 ( lower case )\ng0 x1.\n",
        "%\nN1 O0100\nG91 G28 Z0\n", "O0001;\nG00 X1.;\nM30;\n", "/O5\nG0 X1.\n",
        "O0001\nT1 M6\nG90 G54 X1. Y2. S900 M3\nG43 Z9. H1\n", "O0001\nG90 X1.\nG1 X2. F9\n",
        "O0001\nG0 X1.\nG64 P0.01\nG33 Z1 K1\nM62 P1\nG59.1\n"}) {
    CAPTURE(text);
    CHECK(guessed(text).starts_with("fanuc "));
    CHECK(guessed(text).ends_with(" the number of a program"));
  }
  CHECK(guessed("%\nO0001\n(HAAS VF-2)\nG0 X1.\n") == "haas 3 'HAAS' in a comment");
  CHECK(guessed("O1\nN5 [#1 LT 2] M99 P9\n") == "haas 2 a condition before M99");
  CHECK(guessed("G81 Z-1. R.1 F9. L0\nG70 I5. J15. L12\n") == "haas 2 a pattern of holes");
  CHECK(guessed("G70\nG71\nG81 X1 Z-1 R1 L2\n") == "none");
}

TEST_CASE("against the number of a program count O-words, names and lines for senders",
          "[ipr][dialects]") {
  CHECK(guessed("O0001\nG0 X1\no100 sub\no100 endsub\nM2") == "linuxcnc 3 an O-word");
  CHECK(guessed("O0001\no[#1+1] call\nM2") == "linuxcnc 2 an O-word");
  CHECK(guessed("O0001\n#<depth>=3\nM2") == "linuxcnc 2 a variable with a name");
  CHECK(guessed("(for LinuxCNC)\nO0001\nG0 X1\nM2") == "linuxcnc 1 'LINUXCNC' in a comment");
  CHECK(guessed("$H\nO0001\nG0 X1\nM2") == "grbl 1 a line for a sender of grbl");
  CHECK(guessed("O0001\nG0 X1*57\nM2") == "grbl 2 a checksum of a sender");
  for (const char* text : {"o100 sub", "O[100]", "O#1", "O", "<PLATE", "O1 X1"}) {
    CAPTURE(text);
    CHECK(guessed(std::string(text) + "\nG0 X1\nM2").find("number of a program") ==
          std::string::npos);
  }
}

TEST_CASE("a text in another encoding shows no dialect", "[ipr][dialects]") {
  using namespace std::string_literals;
  CHECK(guessed("X\0001\0\n\0X\0002\0\n"s) == "none");
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

TEST_CASE("the note of the dialect shows its line as it is written", "[ipr][dialects]") {
  InterpreterOptions options;
  options.guess_dialect = true;
  const Interpreted sums = interpret("G0 X1*57\nG1 X2 *3\nM2", {}, options);
  REQUIRE(places(sums) == Places{"SC1058 1:0", "SC2102 2:1", "SC1055 1:6"});
  CHECK(sums.diagnostics[0].source_line == "G0 X1*57");
  CHECK(sums.diagnostics[1].source_line == "G1 X2 *3");
  CHECK(interpret("\xEF\xBB\xBF(grbl)\nG0 X1\nM2", {}, options).diagnostics[0].source_line ==
        "(grbl)");
}

TEST_CASE("a line that a reader does not yet hold as a whole shows nothing", "[ipr][dialects]") {
  std::string lines;
  for (int i = 0; i < 293; ++i) lines += "(" + std::string(220, '-') + ")\n";
  int shown = 0;
  for (std::size_t more = 0; more < 300; ++more) {
    Reader reader = Reader::fed();
    REQUIRE(
        reader.feed("(" + std::string(more, '-') + ")\n" + lines + "O0001         (PLATE)\nM2\n"));
    reader.end_feed();
    const DialectGuess found = guess_dialect(reader);
    if (found.dialect()) CHECK(found.text() == "O0001         (PLATE)");
    shown += found.dialect() ? 1 : 0;
  }
  CHECK((shown > 0 && shown < 300));
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
