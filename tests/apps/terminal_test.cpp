// SPDX-License-Identifier: MIT
// At a terminal: the bar, and Enter where the program waits.
#include <catch2/catch.hpp>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kSoftcnc = SOFTCNC_BINARY " ";

}  // namespace

TEST_CASE("on a terminal M00 waits for Enter, and M06 where somebody changes tools",
          "[apps][terminal]") {
  const Folder folder;
  write(folder / "p.nc", "T3 M06\nG01 X1 F600\nM00\nX2\nM30\n");
  const Ended simulated = on_terminal(kSoftcnc + "run " + (folder / "p.nc"));
  CHECK(simulated.status == 0);
  CHECK(contains(simulated.out, "line 3: M00: press Enter "));
  CHECK_FALSE(contains(simulated.out, "M06"));
  const Ended ended = on_terminal(kSoftcnc + "run --realtime " + (folder / "p.nc"));
  CHECK(contains(ended.out, "line 1: M06 T3: press Enter "));
  CHECK(contains(ended.out, "line 3: M00: press Enter "));
  const Ended piped = on_terminal("cat " + (folder / "p.nc") + " | " + kSoftcnc + "run -");
  CHECK(piped.status == 0);
  CHECK_FALSE(contains(piped.out, "press Enter"));
}

TEST_CASE("single block waits for Enter before every block", "[apps][terminal]") {
  const Folder folder;
  write(folder / "p.nc", "G64 P0.1 F600\nG01 X1\nX2 Y1\nM08\nM00\nG00 X0\nM30\n");
  const Ended ended = on_terminal(kSoftcnc + "run --single-block " + (folder / "p.nc"));
  CHECK(ended.status == 0);
  CHECK_FALSE(contains(ended.out, "line 2: press Enter "));  // Enter has started the program
  for (const std::string at : {"line 3", "line 4", "line 5: M00", "line 6"})
    CHECK(contains(ended.out, at + ": press Enter "));
}

TEST_CASE("single block ends every block at rest", "[apps][terminal]") {
  const Folder folder;
  write(folder / "p.nc", "G64 P0.1 F600\nG01 X1\nX2 Y1\nX3\nM30\n");
  for (const std::string events : {"", " --at 0.05:override=50 --at 0.2:hold --at 0.3:resume"}) {
    const Ended ended = call("run --dry-run --single-block " + (folder / "p.nc") + events);
    REQUIRE(ended.status == 0);
    const Trace trace = parse_trace(ended.out);
    for (std::size_t i = 1; i < trace.rows.size(); ++i)
      if (trace.number(i, "block") != trace.number(i - 1, "block"))
        CHECK(std::min(trace.number(i, "v_mm_s"), trace.number(i - 1, "v_mm_s")) <= 1.0);
    CHECK(trace.number(trace.rows.size() - 1, "x_mm") == 3);
  }
}

TEST_CASE("what ends a run at a prompt leaves the machine where it rests", "[apps][terminal]") {
  const auto [answer, status] = GENERATE(table<std::string, int>({
      {"\x03", 130},  // Ctrl-C
      {"\x04", 130},  // Ctrl-D
      {"\x1c", 131},  // Ctrl-backslash
      {kHangUp, 129},
  }));
  const std::string method = GENERATE("arc-length", "taylor1");
  CAPTURE(status, method);
  const Folder folder;
  write(folder / "p.nc", "G00 X10\nM00\nG00 X100\nT1 M06\nX0\nM30\n");
  const Ended ended = on_terminal("exec " + kSoftcnc + "run " + (folder / "p.nc") + " --trace " +
                                      (folder / "t.csv") + " --set control.interpolation=" + method,
                                  answer);
  CHECK(ended.status == status);
  CHECK(contains(ended.out, "line 2: M00: press Enter "));
  CHECK_FALSE(contains(ended.out, "M06"));
  CHECK(folder.files() == std::vector<std::string>{"p.nc", "t.csv"});
  const Trace trace = parse_trace(read(folder / "t.csv"));
  REQUIRE(trace.rows.size() > 100);
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    if (trace.number(i, "x_mm") > 10 + 1e-9) FAIL_CHECK("row " << i);
  CHECK(trace.number(trace.rows.size() - 1, "x_mm") == Approx(10).margin(1e-3));
  CHECK(trace.number(trace.rows.size() - 1, "v_mm_s") == 0);
}

TEST_CASE("a prompt comes before anything after it moves", "[apps][terminal]") {
  const Folder folder;
  write(folder / "p.nc", "M00\nG00 X100\nM30\n");
  const Ended ended =
      on_terminal(kSoftcnc + "run " + (folder / "p.nc") + " --trace " + (folder / "t.csv"), "\x03");
  CHECK(ended.status == 130);
  const Trace trace = parse_trace(read(folder / "t.csv"));
  REQUIRE(!trace.rows.empty());
  for (std::size_t i = 0; i < trace.rows.size(); ++i) CHECK(trace.number(i, "x_mm") == 0);
}

TEST_CASE("each prompt wants an answer of its own", "[apps][terminal]") {
  const Folder folder;
  write(folder / "p.nc", "M00\nM00\nG01 X1 F600\nM00\nM30\n");
  const Ended ended = on_terminal(kSoftcnc + "run " + (folder / "p.nc"));
  CHECK(ended.status == 0);
  for (const char* line : {"line 1: M00: ", "line 2: M00: ", "line 4: M00: "})
    CHECK(contains(ended.out, line));
}

TEST_CASE("on a terminal a long run shows a bar with what is left", "[apps][terminal]") {
  const Folder folder;
  std::string part = "G90 G01 F600\n";
  for (int i = 0; i < 60; ++i) part += i % 2 == 0 ? "X100\n" : "X0\n";
  write(folder / "p.nc", part + "M30\n");
  const Ended ended = on_terminal(kSoftcnc + "run " + (folder / "p.nc"));
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "\rrunning ["));
  CHECK(contains(ended.out, " left\033[K"));
  CHECK_FALSE(contains(on_terminal(kSoftcnc + "run -q " + (folder / "p.nc")).out, "running"));
}

TEST_CASE("on a terminal check shows how far it is, and help below the first of a kind",
          "[apps][terminal]") {
  const Folder folder;
  std::string part = "G90 G01 F600\n";
  for (int i = 0; i < 100'000; ++i) part += i % 2 == 0 ? "X100\n" : "X0\n";
  write(folder / "p.nc", part + "M30\n");
  const Ended ended = on_terminal(kSoftcnc + "check " + (folder / "p.nc"));
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "\rchecking ["));
  CHECK(contains(ended.out, " left\033[K"));
  write(folder / "e.nc", "G999\nG998\nM30\n");
  const std::string out = on_terminal(kSoftcnc + "check " + (folder / "e.nc")).out;
  const std::string help = "= help: see docs/gcode.md for the codes softcnc knows";
  CHECK(contains(out, help));
  CHECK(out.find(help) == out.rfind(help));
  CHECK_FALSE(contains(call("check " + (folder / "e.nc")).out, "help:"));
}

TEST_CASE("diagnostics are in colour on a terminal, unless NO_COLOR is set", "[apps][terminal]") {
  const std::string check = kSoftcnc + "check " + data("two_errors.nc");
  CHECK(shows(on_terminal(check).out, "\033[1;31merror:\033[0m ... [SC2001]"));
  CHECK_FALSE(contains(on_terminal("NO_COLOR=1 " + check).out, "\033"));
}
