// SPDX-License-Identifier: MIT
// Programs that never end are found by reading alone.
#include "endless.hpp"

#include <catch2/catch.hpp>

#include "apps/shell.hpp"

namespace softcnc::app {
namespace {

using test::Folder;
using test::write;

struct Stopping final : Watcher {
  bool wants_stop() override { return true; }
  void sees(const Setpoint&) override {}
  void pause(const Pause&) override {}
  void wait_for_input(int) override {}
};

}  // namespace

TEST_CASE("a program without an end is read in a moment, and found out", "[apps][endless]") {
  const Folder folder;
  const auto is_found = [&](const std::string& text, Watcher* watcher = nullptr) {
    write(folder / "part.nc", text);
    auto program = Program::open(folder / "part.nc");
    REQUIRE(program);
    Machine machine;
    machine.program.block_limit = 5000;
    return is_endless(*program, machine, {}, watcher);
  };
  const std::string loop = "o1 while [1]\nG00 X1\nX0\no1 endwhile\nM30\n";
  CHECK(is_found(loop));
  CHECK_FALSE(is_found("o1 repeat [100]\nG00 X1\nX0\no1 endrepeat\nM30\n"));
  CHECK_FALSE(is_found("G00 X1 Q2\nM30\n"));
  Stopping stopping;
  CHECK_FALSE(is_found(loop, &stopping));
}

}  // namespace softcnc::app
