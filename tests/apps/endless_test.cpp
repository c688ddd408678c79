// SPDX-License-Identifier: MIT
// Programs that never end are found by reading alone.
#include "runtime/check/endless.hpp"

#include <catch2/catch.hpp>

#include "apps/shell.hpp"
#include "support/sanitized.hpp"

namespace softcnc::app {
namespace {

using test::Folder;
using test::write;

struct Stopping final : runtime::Watcher {
  bool wants_stop() override { return true; }
  void sees(const Setpoint&) override {}
  void pause(const runtime::Pause&) override {}
  void wait_for_input(int) override {}
};

}  // namespace

TEST_CASE("a program without an end is read in a moment, and found out", "[apps][endless]") {
  const Folder folder;
  const auto is_found = [&](const std::string& text, runtime::Watcher* watcher = nullptr) {
    write(folder / "part.nc", text);
    auto program = runtime::Program::open(folder / "part.nc");
    REQUIRE(program);
    Machine machine;
    machine.program.block_limit = 5000;
    return runtime::is_endless(*program, machine, {}, watcher);
  };
  const std::string loop = "o1 while [1]\nG00 X1\nX0\no1 endwhile\nM30\n";
  CHECK(is_found(loop));
  CHECK_FALSE(is_found("o1 repeat [100]\nG00 X1\nX0\no1 endrepeat\nM30\n"));
  CHECK_FALSE(is_found("G00 X1 Q2\nM30\n"));
  Stopping stopping;
  CHECK_FALSE(is_found(loop, &stopping));
}

TEST_CASE("an endless loop through a pipe is reported as one in a file, in about the same time",
          "[apps][endless]") {
  if (softcnc::test::kSanitized) return;  // where times say nothing
  const Folder folder;
  const std::string begin = "G21 G90 F800\n#1=0\n", end = "  G0 X0\no1 endwhile\nM2\n";
  const std::string loop =
      GENERATE_COPY(begin + "o1 while [#1 LT 5]\n  G0 Y[#1*2]\n  G1 X20\n" + end,
                    begin + "o1 while [1]\n  G1 X20\n  G2 X10 Q1 I5\n" + end);
  write(folder / "p.nc", loop);
  const auto check = [&](const std::string& what) {
    return test::shell("cd " + (folder / "") + "; " + what);
  };
  const std::string of_file = "$softcnc check --set program.block_limit=300000 p.nc";
  const test::Ended file = check(of_file);
  CHECK(file.status == 1);
  CHECK(test::shows(file.out,
                    "p.nc:3:1: error: 'o1 while' has run more than 300000 blocks [SC2310]"));
  const test::Ended piped =
      check("ulimit -t 10; cat p.nc | $softcnc check --set program.block_limit=300000 -");
  std::string expected = file.out;
  for (std::size_t at = 0; (at = expected.find("p.nc", at)) != std::string::npos;)
    expected.replace(at, 4, "<stdin>");
  CHECK(piped.status == 1);
  CHECK(piped.out == expected);
}

TEST_CASE("a loop through a pipe that ends is planned to its end", "[apps][endless]") {
  const Folder folder;
  const std::string rounds = softcnc::test::kSanitized ? "800" : "8000";
  write(folder / "p.nc", "G21 G90 F6000\no1 repeat [" + rounds +
                             "]\n  G1 X20 (a comment, so that much is read)\n  X0\n"
                             "o1 endrepeat\nG1 X2000\nM2\n");
  const test::Ended piped = test::shell("cd " + (folder / "") + "; cat p.nc | $softcnc check -");
  CHECK(piped.status == 3);
  CHECK(test::shows(piped.out, "<stdin>:6:1: error: X reaches 2000 mm... [SC4001]"));
  CHECK(test::shell("cd " + (folder / "") + "; $softcnc check p.nc").status == 3);
}

}  // namespace softcnc::app
