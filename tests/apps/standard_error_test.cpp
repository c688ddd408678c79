// SPDX-License-Identifier: MIT
// Nobody reads what is said: a run goes on, and ends by its own status.
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

namespace {

/// The statuses of a command whose standard error cannot be written in three ways: a full disk,
/// closed, a pipe whose reader has gone.
std::vector<int> unheard(const std::string& command) {
  std::vector<int> statuses;
  for (const char* where : {"2>/dev/full", "2>&-"})
    statuses.push_back(shell(command + " " + where).status);
  const Folder folder;
  const Ended gone = shell("mkfifo " + (folder / "p") + "; exec 3<>" + (folder / "p") + " 4>" +
                           (folder / "p") + " 3<&-; " + command + " 2>&4");
  statuses.push_back(gone.status);
  return statuses;
}

const std::vector<int> kZeros{0, 0, 0};

}  // namespace

TEST_CASE("a run whose words cannot be written goes on to its end", "[apps][stderr]") {
  const Folder folder;
  const std::string part = "$softcnc run $programs/03_arc.nc --trace ";
  REQUIRE(shell(part + (folder / "heard.csv")).status == 0);
  for (const char* how : {" ", " --progress json ", " -v --worst 3 ", " --diagnostics text "}) {
    CAPTURE(how);
    CHECK(unheard(part + (folder / "t.csv") + how) == kZeros);
    CHECK(read(folder / "t.csv") == read(folder / "heard.csv"));
  }
}

TEST_CASE("a status is what it is, heard or not", "[apps][stderr]") {
  const Folder folder;
  write(folder / "bad.nc", "G01 X1\nM30\n");
  CHECK(unheard("$softcnc run " + (folder / "bad.nc")) == std::vector{1, 1, 1});
  CHECK(unheard("$softcnc rum") == std::vector{2, 2, 2});
  CHECK(unheard("$softcnc run --no-such-option") == std::vector{2, 2, 2});
  CHECK(unheard("$softcnc codes G999") == std::vector{2, 2, 2});
  CHECK(unheard("$softcnc record -q $programs/03_arc.nc -o " + (folder / "a.rec")) == kZeros);
  CHECK(unheard("$softcnc replay --progress json " + (folder / "a.rec")) == kZeros);
}

TEST_CASE("what is closed does not become a file that is written", "[apps][stderr]") {
  const Folder folder;
  const std::string command = "$softcnc run -v $programs/03_arc.nc --progress json --trace ";
  REQUIRE(shell(command + (folder / "a.csv")).status == 0);
  REQUIRE(shell(command + (folder / "b.csv") + " <&- >&- 2>&-").status == 0);
  CHECK(read(folder / "a.csv") == read(folder / "b.csv"));
  CHECK(shell("$softcnc run --dry-run $programs/03_arc.nc >&-").status == 5);
  CHECK(shell("$softcnc run -q - <&-").status == 5);
}

TEST_CASE("a document that cannot be written is status 5, after the motion", "[apps][stderr]") {
  const Folder folder;
  const std::vector<int> fives{5, 5, 5};
  const std::string part = folder / "p.nc";
  write(part, "G1 X1 F600\nM2\n");
  for (const std::string form : {"json", "sarif"}) {
    CAPTURE(form);
    const std::string how = " --diagnostics " + form + " ";
    CHECK(unheard("$softcnc run " + part + " --trace " + (folder / "t.csv") + how) == fives);
    CHECK(parse_trace(read(folder / "t.csv")).rows.size() > 100);
    CHECK(unheard("$softcnc run --dry-run " + part + " --trace /dev/null" + how) == fives);
    CHECK(unheard("$softcnc record " + part + " -o " + (folder / "a.rec") + how) == fives);
    CHECK(unheard("$softcnc replay " + (folder / "a.rec") + how) == fives);
    CHECK(unheard("$softcnc blocks " + part + how) == fives);
    CHECK(unheard("$softcnc machine" + how) == fives);
    CHECK(shell("$softcnc check " + part + how + ">/dev/full").status == 5);
    const Ended heard = call("run -q " + part + how);
    CHECK(heard.status == 0);
    CHECK(nlohmann::json::accept(heard.err));
  }
}

TEST_CASE("a progress display that nobody empties is not waited for", "[apps][stderr]") {
  const Folder folder;
  std::string part = "G90 F6000\n";
  for (int i = 0; i < 4000; ++i) part += "G1 X" + std::to_string(i % 2) + "\n";
  write(folder / "p.nc", part + "M2\n");
  // The pipe is full before the run begins, and nobody reads from it.
  const Ended ended = shell("mkfifo " + (folder / "p") + "; exec 3<>" + (folder / "p") +
                            "; dd if=/dev/zero bs=4096 count=16 >&3 2>/dev/null; timeout 60 "
                            "$softcnc run -q --progress json " +
                            (folder / "p.nc") + " 2>&3");
  CHECK(ended.status == 0);
}

namespace {

/// A run on a terminal of its own that is closed after a while. It runs a circle, by the clock.
int hung_up(const Folder& folder, const std::string& options) {
  std::string part = "G10 L2 P1 X1\nG90 G00 X0 Y100\nG02 F6000\n";
  for (int i = 0; i < 10; ++i) part += "I50\n";
  write(folder / "long.nc", part + "M30\n");
  const std::string command = "cd " + (folder / "") +
                              "; exec " SOFTCNC_BINARY
                              " run --realtime long.nc --trace t.csv "
                              "--report r.json --state s.toml " +
                              options;
  const auto [terminal, child] = start_on_terminal(command);
  const auto moves = [&] {
    for (const std::string& name : folder.files())
      if (name.starts_with(".t.csv.softcnc-")) return true;
    return false;
  };
  while (!moves()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ::close(terminal);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace

TEST_CASE("a terminal that goes away stops a run as SIGTERM does", "[apps][stderr][terminal]") {
  for (const char* options : {"", "-q", "--progress json", "-v"}) {
    CAPTURE(options);
    const Folder folder;
    CHECK(hung_up(folder, options) == 129);
    CHECK(folder.files() == std::vector<std::string>{"long.nc", "r.json", "s.toml", "t.csv"});
    const Trace trace = parse_trace(read(folder / "t.csv"));
    CHECK(trace.number(trace.rows.size() - 1, "v_mm_s") == 0);
    CHECK(nlohmann::json::parse(read(folder / "r.json"))["status"] == "stopped");
  }
}
