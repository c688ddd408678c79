// SPDX-License-Identifier: MIT
// check: every diagnostic of every file on stdout, and nothing else.
#include <algorithm>
#include <catch2/catch.hpp>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;

TEST_CASE("check of good programs says nothing", "[apps][check]") {
  const Ended ended = call("check $programs/02_square.nc $data/zigzag.nc");
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
  CHECK(ended.err.empty());
}

TEST_CASE("check reports everything wrong with every file, on stdout", "[apps][check]") {
  const Ended ended = shell("cd $data; $softcnc check two_errors.nc zigzag.nc beyond.nc none.nc");
  CHECK(ended.status == 5);  // the first that applies of 2, 5, 1, 3
  CHECK(ended.err.empty());
  for (const char* line :
       {"two_errors.nc:3:6: error: ... [SC1004]", "two_errors.nc:5:5: error: ... [SC2001]",
        "beyond.nc:4:2: error: X reaches 1010.5 mm... [SC4001]",
        "beyond.nc:6:1: error: ... [SC4001]", "none.nc: error: cannot be read: ... [SC6001]"}) {
    CAPTURE(line, ended.out);
    CHECK(shows(ended.out, line));
  }
  CHECK(ended.out.find("zigzag.nc") == std::string::npos);
  CHECK(shell("cd $data; $softcnc check two_errors.nc beyond.nc").status == 1);
  CHECK(shell("cd $data; $softcnc check beyond.nc").status == 3);
}

TEST_CASE("check goes on to look at the travel after an error of the program", "[apps][check]") {
  const Ended ended = call("check -", "G01 F600 X10\nX20 Y\nX30 Y0\nX2000\nM30\n");
  CHECK(ended.status == 1);
  CHECK(shows(ended.out, "<stdin>:2:5: error: ... [SC1002]"));
  CHECK(shows(ended.out, "<stdin>:4:1: error: X reaches 2000 mm... [SC4001]"));
}

TEST_CASE("check reports once of each axis that the moves of a line leave", "[apps][check]") {
  const Ended ended = call("check -", "G00 X0 Y0 Z5 F100\nG99 G91 G81 X40 Y30 Z-2 R-1 L500\nM30\n");
  CHECK(ended.status == 3);
  CHECK(shows(ended.out, "<stdin>:2:1: error: X reaches ... [SC4001]"));
  CHECK(shows(ended.out, "<stdin>:2:1: error: Y reaches ... [SC4001]"));
  CHECK(std::count(ended.out.begin(), ended.out.end(), '^') == 2);
}

TEST_CASE("check reports no travel after offsets that an error has left unknown", "[apps][check]") {
  const auto carets = [](const std::string& program) {
    const std::string out = call("check -", program + "M30\n").out;
    return std::count(out.begin(), out.end(), '^');
  };
  CHECK(carets("G92 X0\nG0 X1200\n") == 1);
  CHECK(carets("G0 X-5..00\nG92 X0\nG0 X1200\n") == 1);
  CHECK(carets("G0 X-5..00\nG10 L20 P1 X0\nG0 X1200\n") == 1);
  CHECK(carets("G0 Z-5..00\nG10 L10 P1 Z0\nG43 H1\nG0 Z-1200\n") == 1);
  CHECK(carets("G0 Z-500\nG33 Z0 K1\nG92 Z0\nG1 Z-1200\n") == 1);
  CHECK(carets("M70\nG20\nM72\nG0 X1500\n") == 1);
  CHECK(carets("G68 X0 Y0 R90\nG0 X1500\n") == 1);
  CHECK(carets("G51 X0 P0.5\nG0 X3000\n") == 1);
}

TEST_CASE("check reports once what is wrong with all moves of a line", "[apps][check]") {
  const Ended ended = call("check -", "G91 G81 R1 X1 Z-2000 F100 L3\nM30\n");
  CHECK(std::count(ended.out.begin(), ended.out.end(), '^') == 1);
}

TEST_CASE("check reports a wrong machine file, exit status 2", "[apps][check]") {
  const Ended ended = call("check $data/square.nc --set axis.x.velocity=3");
  CHECK(ended.status == 2);
  CHECK(shows(ended.out, "error: ... [SC7001]"));
  CHECK(ended.err.empty());
}

TEST_CASE("many errors of the planner are reported with their lines in time", "[apps][check]") {
  std::string part = "G90 G01 F600\n";
  for (int i = 0; i < 20000; ++i) part += "X" + std::to_string(2000 + i % 2) + "\n";
  const Ended ended = call("check -", part + "M30\n");
  CHECK(ended.status == 3);
  CHECK(shows(ended.out, "<stdin>:2:1: error: X reaches 2001 mm, 1001 mm beyond... [SC4001]"));
  CHECK(ended.out.find("; 10001 lines leave it there, this one first") != std::string::npos);
}

TEST_CASE("a line with / and M01 count as they are switched", "[apps][check]") {
  const std::string part = "/ X1 G48\nM01\nM30\n";
  CHECK(call("check -", part).status == 1);
  CHECK(call("check --block-skip -", part).status == 0);
  CHECK(call("blocks --block-skip --optional-stop -", part).out ==
        "{\"line\":2,\"block\":1,\"kind\":\"stop\",\"code\":1}\n"
        "{\"line\":3,\"block\":2,\"kind\":\"end\",\"code\":30}\n");
}

TEST_CASE("check warns where a line means something else in the other dialect", "[apps][check]") {
  const std::string part = "G04 P1\nG04 P2\nM30\n";
  const Ended ended = call("check -", part);
  CHECK(ended.status == 0);
  CHECK(ended.out ==
        "<stdin>:1:5: warning: G04 P counts seconds; in the fanuc dialect: counts "
        "milliseconds (here and on 1 more line) [SC2120]\n"
        "    1 | G04 P1\n"
        "      |     ^~\n");
  CHECK(begins_showing(call("check --dialect fanuc -", part).out,
                       "<stdin>:1:5: warning: G04 P counts milliseconds; in the "
                       "linuxcnc dialect: counts seconds (here... [SC2120]"));
  for (const char* command : {"blocks -", "run --dry-run -", "run -q --backend none -"})
    CHECK(call(command, part).err.find("SC2120") == std::string::npos);
}

TEST_CASE("check reports of an endless loop all that it reports of others", "[apps][check]") {
  const Folder folder;
  const std::string part = folder / "part.nc";
  write(part, "(loop)\nM98 P2\nM30\nO2\nWHILE [1] DO 1\nG00 X2000\nX0 Q1\nEND 1\nM99\n");
  const Ended ended = call("check --set program.block_limit=1000 " + part);
  CHECK(ended.status == 1);
  CHECK(ended.out == part +
                         ":7:4: error: unused word Q [SC2004]\n"
                         "    7 | X0 Q1\n"
                         "      |    ^~\n" +
                         part + ":2:1: note: called from here\n" + part +
                         ":5:1: error: 'DO 1' has run more than 1000 blocks [SC2310]\n"
                         "    5 | WHILE [1] DO 1\n"
                         "      | ^~~~~~~~~~~~~~\n" +
                         part + ":2:1: note: called from here\n" + part +
                         ":6:1: error: X reaches 2000 mm, 1000 mm beyond its travel from "
                         "-1000 to 1000 mm [SC4001]\n"
                         "    6 | G00 X2000\n"
                         "      | ^~~\n" +
                         part + ":2:1: note: called from here\n" + part +
                         ":5:1: note: the program looks like one for fanuc (WHILE DO): --dialect "
                         "fanuc [SC1059]\n"
                         "    5 | WHILE [1] DO 1\n");
}

TEST_CASE("a diagnostic in a subprogram names the calls that led there", "[apps][check]") {
  const Folder folder;
  write(folder / "part.nc", "(calls)\no<middle> call\nM30\n");
  write(folder / "middle.nc", "o<middle> sub\n  o<inner> call [1]\no<middle> endsub\n");
  write(folder / "inner.nc", "o<inner> sub\nG1 X#1\no<inner> endsub\n");
  const std::string part = folder / "part.nc", middle = folder / "middle.nc";
  CHECK(call("check " + part).out ==
        (folder / "inner.nc") +
            ":2:1: error: G01 needs a feed, and F is not set [SC2102]\n"
            "    2 | G1 X#1\n"
            "      | ^~\n" +
            middle + ":2:3: note: called from here\n" + part + ":2:1: note: called from here\n");
  const std::string as_json = call("check --diagnostics json " + part).out;
  CHECK(as_json.find("\"called_from\":[{\"file\":\"" + middle +
                     "\",\"line\":2,\"column\":3},"
                     "{\"file\":\"" +
                     part + "\",\"line\":2,\"column\":1}]") != std::string::npos);
  const std::string sarif = call("check --diagnostics sarif " + part).out;
  CHECK(sarif.find("\"relatedLocations\":[{\"physicalLocation\":{\"artifactLocation\":{\"uri\":"
                   "\"file://" +
                   middle +
                   "\"},\"region\":{\"startLine\":2,\"startColumn\":3}},"
                   "\"message\":{\"text\":\"called from here\"}},") != std::string::npos);
}

TEST_CASE("what the planner reports of a subprogram names its calls too", "[apps][check]") {
  const Ended ended =
      call("check -", "O1\nM98 P2\nG0 X0\nM98 P3\nM30\nO2\nG0 X1\nM99\nO3\nG0 X5000\nM99\n");
  CHECK(ended.status == 3);
  CHECK(shows(ended.out, "<stdin>:10:1: error: ... [SC4001]"));
  CHECK(ended.out.ends_with("<stdin>:4:1: note: called from here\n"));
  CHECK(ended.out.find("<stdin>:2:1: note") == std::string::npos);
}

TEST_CASE("a program that cannot be read to its end is reported once", "[apps][check]") {
  for (const char* command : {"check", "blocks", "run --dry-run"}) {
    const Ended ended = call(std::string(command) + " /proc/self/mem");
    CAPTURE(command, ended.out, ended.err);
    const std::string told = ended.out + ended.err;
    CHECK(ended.status == 5);
    const auto first = where_shown(told, "/proc/self/mem: error: cannot ... [SC6002]");
    REQUIRE(first != std::string::npos);
    CHECK(told.find("SC6002", told.find("SC6002", first) + 1) == std::string::npos);
  }
}

TEST_CASE("check reports a loop without an end, and once where it leads", "[apps][check]") {
  const Folder folder;
  const std::string part = folder / "part.nc";
  const auto told = [&](const std::string& program) {
    shell("printf '" + program + "' > " + part);
    const Ended ended = call("check " + part);
    std::vector<std::string> codes;
    for (std::size_t at = 0; (at = ended.out.find(": error: ", at)) != std::string::npos; ++at)
      codes.push_back(ended.out.substr(ended.out.find(" [SC", at) + 2, 6));
    std::sort(codes.begin(), codes.end());
    return codes;
  };
  using Codes = std::vector<std::string>;
  const std::string begin = "F100 G91\nG1 X900\n#1=1\no1 while [#1 LT 5]\n",
                    end = "o1 endwhile\nM30\n";
  CHECK(told(begin + "G1 Y1\n" + end) == Codes{"SC2310", "SC4001"});
  CHECK(told(begin + "G1 Y0.001\n" + end) == Codes{"SC2310"});
  CHECK(told("F100 G91\no2 repeat [11]\nG1 Z-100\no2 endrepeat\n" + begin + "G1 Y1\n" + end) ==
        Codes{"SC2310", "SC4001", "SC4001"});
  CHECK(told("F100 G91\no2 repeat [11]\nG1 X100\no2 endrepeat\nM30\n") == Codes{"SC4001"});
}

TEST_CASE("check looks at moves on both sides of lines that are missing", "[apps][check]") {
  const Ended ended = call("check -", "G21 G90 F100\nG1 X10\nX0 Q5\nX10\nX0 Q5\nX10\nM2\n");
  CHECK(ended.status == 1);
  CHECK(shows(ended.out, "<stdin>:3:4: error: ... [SC2004]"));
  CHECK(shows(ended.out, "<stdin>:5:4: error: ... [SC2004]"));
}
