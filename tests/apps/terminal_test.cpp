// SPDX-License-Identifier: MIT
// At a terminal: the bar, and Enter where the program waits.
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

namespace {

/// Runs a shell command on a terminal of its own; answers each prompt with Enter.
Ended on_terminal(const std::string& command) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  REQUIRE(child >= 0);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  Ended ended;
  std::array<char, 4096> piece{};
  const std::string prompt = "press Enter ";
  for (ssize_t n = 0; (n = ::read(terminal, piece.data(), piece.size())) > 0;) {
    ended.out.append(piece.data(), static_cast<std::size_t>(n));
    if (ended.out.ends_with(prompt)) CHECK(::write(terminal, "\n", 1) == 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  ended.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return ended;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string kSoftcnc = SOFTCNC_BINARY " ";

}  // namespace

TEST_CASE("on a terminal M06 and M00 wait for Enter", "[apps][terminal]") {
  const Folder folder;
  write(folder / "p.nc", "T3 M06\nG01 X1 F600\nM00\nX2\nM30\n");
  const Ended ended = on_terminal(kSoftcnc + "run " + (folder / "p.nc"));
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "line 1: M06 T3: press Enter "));
  CHECK(contains(ended.out, "line 3: M00: press Enter "));
  CHECK(contains(ended.out, "times faster than real time"));
  const Ended piped = on_terminal("cat " + (folder / "p.nc") + " | " + kSoftcnc + "run -");
  CHECK(piped.status == 0);
  CHECK_FALSE(contains(piped.out, "press Enter"));
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

TEST_CASE("diagnostics are in colour on a terminal, unless NO_COLOR is set", "[apps][terminal]") {
  const std::string check = kSoftcnc + "check " + data("two_errors.nc");
  CHECK(contains(on_terminal(check).out, "\033[1;31merror SC2001\033[0m: "));
  CHECK_FALSE(contains(on_terminal("NO_COLOR=1 " + check).out, "\033"));
}
