// SPDX-License-Identifier: MIT
// One cause, one error: what many lines of a program share is shown once.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

std::string rotary(int lines) {
  std::string program = "G21 G90\nG1 F100\n";
  for (int i = 1; i <= lines; ++i)
    program += "X" + std::to_string(i % 100) + " A" + std::to_string(i) + "\n";
  return program + "M2\n";
}

Ended check_program(const Folder& folder, const std::string& program,
                    const std::string& options = {}) {
  write(folder / "p.nc", program);
  return shell("cd " + (folder / "") + "; $softcnc check " + options + " p.nc");
}

}  // namespace

TEST_CASE("an axis that the machine does not have is one error, however many lines name it",
          "[apps][check]") {
  const Folder folder;
  for (const int lines : {3, 5000}) {
    const Ended ended = check_program(folder, rotary(lines));
    CHECK(ended.status == 1);
    CHECK(ended.out ==
          "p.nc:3:4: error: the machine has no axis A [SC2008]\n"
          "    3 | X1 A1\n"
          "      |    ^~\n"
          "p.nc:3:4: note: the machine has no axis A, here and on " +
              std::to_string(lines - 1) + " more lines (last: " + std::to_string(lines + 2) +
              ") [SC6005]\n"
              "    3 | X1 A1\n"
              "      |    ^~\n");
  }
  CHECK(shows(check_program(folder, rotary(2)).out, " on 1 more line (last: 4) [SC6005]"));
  CHECK(check_program(folder, rotary(1)).out.find("SC6005") == std::string::npos);
}

TEST_CASE("one cause does not hide another, nor another error", "[apps][check]") {
  const Folder folder;
  const std::string out =
      check_program(folder, "G21 G90\nG1 X1 A1 F100\nX2 B2\nX1.2.3\nX3 A3\nM301\nM302\nM301\nM2\n")
          .out;
  CHECK(shows(out, "p.nc:2:7: error: the machine has no axis A [SC2008]"));
  CHECK(shows(out, "p.nc:3:4: error: the machine has no axis B [SC2008]"));
  CHECK(shows(out, "p.nc:4:2: error: ... [SC1004]"));
  CHECK(shows(out, "p.nc:6:1: error: M301 ... [SC2001]"));
  CHECK(shows(out, "p.nc:7:1: error: M302 ... [SC2001]"));
  CHECK(shows(out, "p.nc:2:7: note: the machine has no axis A, here and on 1 more line"));
  CHECK(shows(out, "p.nc:6:1: note: M301 ..., here and on 1 more line"));
  CHECK(out.find("axis B, here") == std::string::npos);
}

TEST_CASE("of other errors with the same text ten are shown, and the rest is counted",
          "[apps][check]") {
  const Folder folder;
  std::string program = "G21 G90 F100\n";
  for (int i = 0; i < 5000; ++i) program += "G1 X1 Y\n";
  const Ended ended = check_program(folder, program + "M2\n");
  CHECK(ended.status == 1);
  const json list = json::parse(check_program(folder, program + "M2\n", "--diagnostics json").out);
  REQUIRE(list.size() == 11);
  for (std::size_t i = 0; i < 10; ++i) CHECK(list[i]["code"] == "SC1002");
  CHECK(list[10]["code"] == "SC6005");
  CHECK(list[10]["line"] == 2);
  CHECK(shows(ended.out, ", here and on 4999 more lines (last: 5001) [SC6005]"));
}

TEST_CASE("of errors of one code a hundred are shown, and the rest is counted", "[apps][check]") {
  const Folder folder;
  std::string program;
  for (int i = 0; i < 300; ++i) program += "#" + std::to_string(9000 + i) + "=1\n";
  const std::string out = check_program(folder, program + "M2\n").out;
  CHECK(shows(out,
              "p.nc:1:1: note: 200 more errors SC1025 like this one and the 99 shown, the last on "
              "line 300 [SC6005]\n"));
}

TEST_CASE("errors of a program that looks like one of another dialect name it", "[apps][check]") {
  const Folder folder;
  const std::string grbl = "(grbl, TinyG, g2core)\nG21 G90\nZ5\nX10 Y10\nG1 Z-1 F100\nM2\n";
  const std::string out = check_program(folder, grbl).out;
  CHECK(shows(out, "p.nc:3:1: error: Z with no motion code in force [SC2101]"));
  CHECK(shows(out,
              "p.nc:1:1: note: the program looks like one for grbl ('GRBL' in a comment): "
              "--dialect grbl [SC1059]\n"));
  CHECK(check_program(folder, grbl, "--dialect grbl").status == 0);
  const std::string chosen = check_program(folder, grbl, "--dialect auto").out;
  CHECK(shows(chosen,
              "p.nc:1:1: note: the program is read in the grbl dialect; 'GRBL' in a comment "
              "shows it [SC1058]\n"));
  CHECK(chosen.find("SC1059") == std::string::npos);
  CHECK(check_program(folder, "(for grbl)\nG0 X1\nM2\n").out.empty());
  CHECK(shows(check_program(folder, "%\nO0001\nG65 P9 A1\n#1=#2+1\nM30\n%\n").out,
              "note: the program looks like one for fanuc (an operator without brackets): "
              "--dialect fanuc [SC1059]"));
  const std::string numbered = "%\nO0001\nT1 M6\nG0 G91 G28 Z0\nM30\n%\n";
  CHECK(shows(check_program(folder, numbered).out,
              "p.nc:2:1: note: the program looks like one for fanuc (the number of a program): "
              "--dialect fanuc [SC1059]\n"));
  CHECK(shows(check_program(folder, numbered, "--dialect auto").out,
              "p.nc:2:1: note: the program is read in the fanuc dialect; the number of a program "
              "shows it [SC1058]\n"));
  CHECK(check_program(folder, numbered, "--dialect auto").status == 0);
  const std::string haas = check_program(folder, "O0001\nG0 X1..2\nM30\n", "--dialect haas").out;
  CHECK(shows(haas, "SC1004"));
  CHECK(haas.find("SC1059") == std::string::npos);
}

TEST_CASE("warnings of refused codes that nothing runs are counted as errors are",
          "[apps][check]") {
  const Folder folder;
  std::string program = "o<touch> sub\n";
  for (int i = 0; i < 30; ++i) program += "G33 Z-" + std::to_string(i + 1) + " K1\n";
  const Ended ended = check_program(folder, program + "o<touch> endsub\nG0 X1\nM2\n");
  CHECK(ended.status == 0);
  CHECK(
      shows(ended.out,
            "p.nc:2:1: warning: G33 is refused: threads need a spindle with an encoder, which the "
            "axes could follow; nothing runs this line [SC2114]\n"));
  CHECK(shows(ended.out, "p.nc:11:1: warning: "));
  CHECK_FALSE(shows(ended.out, "p.nc:12:1: warning: "));
  CHECK(shows(ended.out, "runs this line, here and on 29 more lines (last: 31) [SC6005]"));
}

TEST_CASE("every command says a cause once, and a pipe does, too", "[apps]") {
  const Folder folder;
  write(folder / "p.nc", rotary(50));
  for (const char* command : {"run", "blocks", "run --dry-run", "check"}) {
    for (const char* part : {"p.nc", "- < p.nc"}) {
      CAPTURE(command, part);
      const Ended ended = shell("cd " + (folder / "") + "; $softcnc " + command + " " + part);
      const std::string all = ended.out + ended.err;
      CHECK(ended.status == 1);
      CHECK(shows(all, ":3:4: error: the machine has no axis A [SC2008]"));
      CHECK(shows(all, ":3:4: note: the machine has no axis A, here and on 49 more lines"));
      CHECK(all.find("[SC2008]") == all.rfind("[SC2008]"));
    }
  }
}

TEST_CASE("documents have the note, too", "[apps][check]") {
  const Folder folder;
  const json list = json::parse(check_program(folder, rotary(9), "--diagnostics json").out);
  REQUIRE(list.size() == 2);
  CHECK(list[0]["code"] == "SC2008");
  CHECK(list[1]["code"] == "SC6005");
  CHECK(list[1]["severity"] == "note");
}

TEST_CASE("a program for another kind of control is one error", "[apps][check]") {
  const Folder folder;
  const auto only = [&](const std::string& program, const std::string& place,
                        const std::string& control) {
    for (const char* dialect : {"--dialect linuxcnc", "--dialect fanuc"}) {
      const std::string out = check_program(folder, program, dialect).out;
      CAPTURE(out);
      CHECK(shows(out,
                  ":1: error: the program is made for ...; softcnc reads G-code "
                  "as LinuxCNC and FANUC's controls do [SC2383]\n"));
      CHECK(out.starts_with("p.nc:" + place + ": error: the program is made for " + control + ";"));
      CHECK(out.find("SC", out.find("SC2383") + 1) == std::string::npos);
    }
  };
  only(
      "0 BEGIN PGM PART MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 L X+0 Y+0 R0 FMAX M3\n"
      "3 END PGM PART MM\n",
      "1:1", "a Heidenhain control, in Klartext");
  only(
      "N10 G17 G54 G90\nN20 MSG(\"roughing\")\nN30 DEF REAL DEPTH=5\nN40 G0 X=R1 Y=R2\n"
      "N50 CYCLE81(10,0,2,-5)\nN60 M30\n",
      "2:1", "a Sinumerik control");
  only("G28\nM104 S200\nG92 E0\nG1 X91 Y92 F3600\nG1 X92 Y91 E0.02\nG1 X93 Y91 E0.04\n", "2:1",
       "a 3-D printer");
  only("$PART.MIN%\nO1000\nG15 H1\nNAT01\nV1=10\nCALL O2000\nM02\n", "1:1", "an Okuma control");
}

TEST_CASE("a program with one word of another control is read as G-code", "[apps][check]") {
  const Folder folder;
  for (const char* program :
       {"G1 X10 F100\nMSG(\"hello\")\nX20 Y\nM30\n", "G1 X10 E5 F100\nX20 Y\nM30\n",
        "M104\nG1 X10 F100\nM84\nX20 Y\nM30\n"}) {
    const std::string out = check_program(folder, program).out;
    CAPTURE(out);
    CHECK(out.find("SC2383") == std::string::npos);
    CHECK(shows(out, "error: no number after Y... [SC1002]"));
  }
}

TEST_CASE("arcs whose centres are places are one error", "[apps][check]") {
  const Folder folder;
  std::string part = "G21 G90\nG0 X10 Y0\n";
  for (int i = 0; i < 50; ++i) part += i % 2 == 0 ? "G3 X0 Y10 I2 J2 F500\n" : "G3 X10 Y0 I2 J2\n";
  const Ended ended = check_program(folder, part + "M2\n");
  CHECK(shows(ended.out, "p.nc:3:4: error: G03 ends ...; its centre fits with G90.1... [SC2103]"));
  CHECK(shows(ended.out,
              "note: an arc ends off its circle, and its centre fits with G90.1, as a "
              "place, here and on 49 more lines (last: 52) [SC6005]"));
  CHECK(ended.out.find("SC2103") == ended.out.rfind("SC2103"));
}

TEST_CASE("a file that is no text is one error", "[apps][check]") {
  const Folder folder;
  const auto said_of = [&](const std::string& text) { return check_program(folder, text); };
  const Ended picture = said_of("\x89PNG\r\n\x1a\n\x01\x02\nG1\n\x03\n");
  CHECK(picture.status == 1);
  CHECK(shows(picture.out,
              "p.nc:1:1: error: the file is a PNG picture, not a part program [SC1060]"));
  CHECK(picture.out.find(": error: ") == picture.out.rfind(": error: "));
  CHECK(shows(said_of("solid part\nfacet normal 0 0 1\n").out, "the file is an STL model"));
  CHECK(shows(said_of("\x01\x02\x03\x04\x05\x06 G1\n").out, "the file is no text"));
}

TEST_CASE("a Sinumerik program without a header is known by its words", "[apps][check]") {
  const Folder folder;
  const Ended ended = check_program(folder,
                                    "N10 G0 G90 X0 Y0\nN20 R1=10\nN30 IF R1>2 GOTOF END1\n"
                                    "N40 G1 X=R1 F200\nN50 END1:\nN60 M30\n");
  CHECK(shows(ended.out, "the program is made for a Sinumerik control"));
  CHECK(ended.out.find(": error: ") == ended.out.rfind(": error: "));
}

TEST_CASE("likely slips are named", "[apps][check]") {
  const Folder folder;
  const auto said_of = [&](const std::string& line) {
    return check_program(folder, "G21 G90 F100\nG0 X5 Z5\n" + line + "\nM2\n").out;
  };
  CHECK(shows(said_of("G0 X1l"), "no number after L; is the digit 1 meant? [SC1002]"));
  CHECK(shows(said_of("Gl X1"), "no number after G; is the digit 1 meant? [SC1002]"));
  CHECK_FALSE(shows(said_of("G0 X1L"), "is the digit 1 meant?"));
  CHECK(
      shows(said_of("G70"), "G70 is not supported in the linuxcnc dialect; G20 is inch [SC2001]"));
  CHECK(shows(said_of("G71"), "G71 is not supported in the linuxcnc dialect; G21 is mm [SC2001]"));
  CHECK(
      shows(said_of("G28 Z0"), "warning: G28 Z0 goes to Z0 of the work system first... [SC2116]"));
  CHECK(said_of("G91 G28 Z0").empty());
  CHECK(said_of("G28 Z5").empty());
}
