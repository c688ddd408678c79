// SPDX-License-Identifier: MIT
// A machine file beside a program: used by every command, named, and let out of softcnc by none.
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "apps/talk.hpp"

using namespace softcnc::app::test;

namespace {

constexpr const char* kShortLine = "G21 G90\nG01 X10 F6000\nM30\n";
constexpr const char* kSlow = "name = \"slow mill\"\n[axis.x]\nvelocity_mm_min = 600\n";

/// A folder with p.nc and, beside it, p.toml.
class NeighbourPass {
 public:
  explicit NeighbourPass(const std::string& machine = kSlow) {
    write(part(), kShortLine);
    write(machine_file(), machine);
  }
  std::string part() const { return folder_ / "p.nc"; }
  std::string machine_file() const { return folder_ / "p.toml"; }
  std::string operator/(const std::string& name) const { return folder_ / name; }
  std::vector<std::string> files() const { return folder_.files(); }
  Ended in_it(const std::string& command) const {
    return shell("cd " + (folder_ / "") + "; " + command);
  }

 private:
  Folder folder_;
};

}  // namespace

TEST_CASE("a machine file beside the program is its machine, and the summary names it",
          "[apps][sidecar]") {
  const NeighbourPass beside;
  const std::string part = beside.part();
  const Ended run = call("run " + part + " --report " + (beside / "r.json"));
  CHECK(run.status == 0);
  CHECK(shows(run.err, part + " on slow mill\n"));
  CHECK(shows(run.err, "\n  machine        " + beside.machine_file() + ", beside the program\n"));
  const auto report = nlohmann::json::parse(read(beside / "r.json"));
  CHECK(report["machine_file"] == beside.machine_file());
  CHECK(report["time_s"].get<double>() > 1);

  const Ended named = call("run " + part + " --machine " + beside.machine_file());
  CHECK(shows(named.err, " on slow mill\n"));
  CHECK_FALSE(shows(named.err, "beside the program"));
  const Ended builtin = call("run " + part + " --machine builtin");
  CHECK(shows(builtin.err, " on retrofitted mill (built-in)\n"));
  CHECK_FALSE(shows(builtin.err, "beside the program"));
}

TEST_CASE("every command that takes a program takes the machine beside it", "[apps][sidecar]") {
  const NeighbourPass beside;
  const std::string part = beside.part();
  write(part, "G01 X10 Y1 F6000\nM30\n");  // which the machine beside it has no axis for
  for (const std::string command :
       {"run", "run --dry-run", "check", "blocks", "record -o x.rec", "surface -o x.npz",
        "compare --phases 1 --methods arc-length"}) {
    CAPTURE(command);
    CHECK(beside.in_it("$softcnc " + command + " -q " + part).status == 1);
    CHECK(beside.in_it("$softcnc " + command + " -q " + part + " --machine builtin").status ==
          (command.starts_with("surface") ? 1 : 0));  // nothing that cuts
  }
}

TEST_CASE("each of several programs has the machine beside it", "[apps][sidecar]") {
  const NeighbourPass beside;
  write(beside / "q.nc", "G01 Y1 F600\nM30\n");
  write(beside / "r.nc", "G01 Y1 F600\nM30\n");
  write(beside / "r.toml", "[axis.x]\n[axis.y]\nmax_mm = 0.5\n");
  const Ended ended = beside.in_it("$softcnc check p.nc q.nc r.nc");
  CHECK(ended.status == 3);
  CHECK_FALSE(shows(ended.out, "p.nc:"));
  CHECK_FALSE(shows(ended.out, "q.nc:"));
  CHECK(shows(ended.out, "r.nc:1:"));
  CHECK(beside.in_it("$softcnc check -q p.nc q.nc r.nc --machine builtin").status == 0);
}

TEST_CASE("the machine beside a program is compared in a replay, wherever that runs",
          "[apps][sidecar]") {
  const NeighbourPass beside;
  REQUIRE(call("record -q " + beside.part() + " -o " + (beside / "x.rec")).status == 0);
  std::filesystem::remove(beside.machine_file());
  CHECK(call("replay -q " + (beside / "x.rec")).status == 0);
  CHECK(call("replay -q " + (beside / "x.rec") + " --machine builtin").status == 1);
}

TEST_CASE("a broken machine file beside a program is an error with its place", "[apps][sidecar]") {
  const NeighbourPass beside("[control]\nperiod_ms = -1\n");
  write(beside / "good.nc", kShortLine);
  for (const std::string command : {"run", "run --dry-run", "check", "blocks"}) {
    const Ended ended = shell("$softcnc " + command + " -q " + beside.part() + " 2>&1");
    CAPTURE(command);
    CHECK(ended.status == 2);
    CHECK(ended.out.starts_with(beside.machine_file() + ":2:13: error"));
  }
  const Ended both = beside.in_it("$softcnc check p.nc p.nc good.nc");
  CHECK(both.status == 2);
  CHECK(both.out.find("SC7005") == both.out.rfind("SC7005"));  // reported once
  CHECK(call("check " + beside.part() + " --machine builtin").status == 0);
}

TEST_CASE("what a setting lacks is reported once for all machines", "[apps][sidecar]") {
  const NeighbourPass beside;
  write(beside / "q.nc", kShortLine);
  const Ended ended = beside.in_it("$softcnc check p.nc q.nc --set control.preiod_ms=1");
  CHECK(ended.status == 2);
  CHECK(ended.out.find("SC7001") == ended.out.rfind("SC7001"));
}

TEST_CASE("what has the name of the machine of a program and is no file is an error",
          "[apps][sidecar]") {
  const Folder folder;
  const std::string part = folder / "p.nc", machine = folder / "p.toml";
  write(part, kShortLine);
  struct Case {
    const char* make;
    const char* why;
  };
  for (const Case& tried :
       {Case{"mkdir", "it is not a regular file"}, Case{"mkfifo", "it is not a regular file"},
        Case{"ln -s /no/such/file", "it is a link to nothing"},
        Case{"ln -s /dev/null", "it is not a regular file"}}) {
    REQUIRE(shell(std::string(tried.make) + " " + machine).status == 0);
    CAPTURE(tried.make);
    for (const std::string command : {"check", "run", "run --dry-run", "blocks"}) {
      const Ended ended = shell("timeout 20 $softcnc " + command + " " + part + " 2>&1");
      CHECK(ended.status == 2);
      CHECK(ended.out ==
            machine + ": error: cannot be read: " + std::string(tried.why) + " [SC7003]\n");
    }
    CHECK(call("check " + part + " --machine builtin").status == 0);
    std::filesystem::remove(machine);
  }
  write(folder / "machine", kSlow);
  std::filesystem::create_symlink(folder / "machine", machine);
  CHECK(call("check " + part).status == 0);
  const Folder elsewhere;
  write(elsewhere / "machine", kSlow);
  std::filesystem::remove(machine);
  std::filesystem::create_symlink(elsewhere / "machine", machine);
  CHECK(shows(call("check " + part).out, "it is a link out of its folder... [SC7003]"));
}

TEST_CASE("only a file of its own is the machine of a program", "[apps][sidecar]") {
  const Folder folder;
  write(folder / "q.toml", kShortLine);
  CHECK(call("check " + (folder / "q.toml")).status == 0);  // it is the program
  write(folder / "in.toml", "none");
  CHECK(shell("cd " + (folder / "") + "; $softcnc check -", kShortLine).status == 0);
}

TEST_CASE("a state file is no machine file", "[apps][sidecar]") {
  const std::string state = "schema = 1\n[work.\"G54\"]\nx_mm = 5\n";
  const Folder folder;
  const std::string part = folder / "p.nc";
  write(part, kShortLine);
  write(folder / "p.state.toml", state);
  CHECK(call("check " + part + " --state " + (folder / "p.state.toml")).out.empty());
  write(folder / "p.state.nc", kShortLine);
  CHECK(call("check " + (folder / "p.state.nc")).out.empty());
  write(folder / "p.toml", state);
  CHECK(call("check " + part + " --state " + (folder / "p.toml")).out.empty());
  const Ended ended = call("check " + part);
  CHECK(ended.status == 2);
  CHECK(ended.out.starts_with(
      (folder / "p.toml") +
      ":1:1: error: 'schema' belongs in a state file: this is not a machine file [SC7020]\n"));
}

TEST_CASE("a machine file without a name is wrong usage", "[apps][sidecar]") {
  const NeighbourPass beside;
  CHECK(beside.in_it("$softcnc check --machine '' p.nc").status == 2);
}

TEST_CASE("a machine beside a program writes no file and opens no port", "[apps][sidecar]") {
  struct Case {
    const char* backend;
    const char* key;
    const char* says;
  };
  const Case tried = GENERATE(Case{"stepdir", "file", "no edges are written"},
                              Case{"hal-stream", "file", "no rows are sent"},
                              Case{"parport", "device", "no port is opened"});
  const std::string backend = tried.backend;
  CAPTURE(backend);
  const std::string slow = "[axis.x]\nvelocity_mm_min = 600\n[limits]\nfeed_mm_min = 600\n";
  const NeighbourPass beside;
  const std::string victim = beside / "mine.vcd";
  write(victim, "mine");
  write(beside.machine_file(), "control.backend = \"" + backend + "\"\n" + slow + "[backend." +
                                   backend + "]\n" + tried.key + " = \"" + victim + "\"\n");
  const auto before = beside.files();
  for (const std::string command : {"run", "check", "run --realtime"}) {
    const Ended ended = beside.in_it("$softcnc " + command + " -q p.nc 2>&1");
    CAPTURE(command, ended.out);
    // A busy computer may miss a period.
    CHECK((ended.status == 0 || (command == "run --realtime" && ended.status == 4)));
    CHECK(ended.out.starts_with("p.toml:7:"));
    CHECK(shows(ended.out, ": warning"));
    CHECK(shows(ended.out, "SC7021"));
    CHECK(shows(ended.out, "backend." + backend + "." + tried.key +
                               " is ignored unless --machine names the file: " + tried.says));
    CHECK(read(victim) == "mine");
    CHECK(beside.files() == before);
  }
  // The default name of a backend that only the file chooses is not written either.
  write(beside.machine_file(), "control.backend = \"" + backend + "\"\n" + slow);
  const Ended by_default = beside.in_it("$softcnc run -q p.nc 2>&1");
  CHECK(by_default.status == 0);
  CHECK(by_default.out.starts_with("p.toml:1:"));
  CHECK(shows(by_default.out, "control.backend is ignored"));
  CHECK(beside.files() == before);
}

TEST_CASE("a file that a setting names is written, whatever machine lies beside the program",
          "[apps][sidecar]") {
  const NeighbourPass beside("control.backend = \"stepdir\"\nbackend.stepdir.file = \"no.vcd\"\n");
  const Ended plain = beside.in_it("$softcnc run -q p.nc");
  CHECK(plain.err.starts_with(
      "p.toml:2:24: warning: backend.stepdir.file is ignored unless --machine names the "
      "file: no edges are written [SC7021]\n"));
  const Ended ended = beside.in_it("$softcnc run p.nc --set backend.stepdir.file=yes.vcd");
  CHECK(ended.status == 0);
  CHECK_FALSE(shows(ended.err, "SC7021"));
  CHECK(beside.files() == std::vector<std::string>{"p.nc", "p.toml", "yes.vcd"});
  const Ended named = beside.in_it("$softcnc run p.nc --machine p.toml");
  CHECK(named.status == 0);
  CHECK_FALSE(shows(named.err, "SC7021"));
  CHECK(std::filesystem::exists(beside / "no.vcd"));
}

TEST_CASE("the pulses of a machine beside a program are counted", "[apps][sidecar]") {
  const NeighbourPass beside("control.backend = \"stepdir\"\n[axis.x]\n");
  REQUIRE(beside.in_it("$softcnc run -q p.nc --trace t.csv").status == 0);
  CHECK(parse_trace(read(beside / "t.csv")).columns.back() == "x_count");
}

TEST_CASE("a report does not take the place of the machine beside the program", "[apps][sidecar]") {
  const NeighbourPass beside;
  const Ended ended = call("run -q " + beside.part() + " --report " + beside.machine_file());
  CHECK(ended.status == 2);
  CHECK(shows(ended.err, "name the same file"));
  CHECK(read(beside.machine_file()) == kSlow);
}

TEST_CASE("a check that watches sees the machine beside the program come and go",
          "[apps][sidecar]") {
  const Folder folder;
  write(folder / "p.nc", kShortLine);
  Talk talk({"check", "--watch", folder / "p.nc"});
  talk.hear("--- 0 errors");
  write(folder / "p.toml", "[axis.y]\n");
  talk.hear("--- 1 error");
  std::filesystem::remove(folder / "p.toml");
  talk.hear("--- 0 errors");
  talk.send(SIGINT);
  talk.hear_rest();
}
