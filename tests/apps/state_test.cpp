// SPDX-License-Identifier: MIT
// --state: what a machine remembers from one program to the next.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "hal/machine/state_file.hpp"
#include "runtime/session/block_history.hpp"
#include "settings/machine_memory.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

MachineState at_x(double x) {
  MachineState state;
  state.work[0].origin[0] = x;
  return state;
}

/// A state file whose G54 lies at X10.
std::string shifted(const Folder& folder) {
  write(folder / "mill.state", hal::state_toml(at_x(10)));
  return " --state " + (folder / "mill.state");
}

}  // namespace

TEST_CASE("a program begins with the state of its file", "[apps][state]") {
  const Folder folder;
  const std::string state = shifted(folder), part = "G00 X1\nM30\n";
  CHECK(call("blocks -", part).out.find("\"to\":[1,0,0]") != std::string::npos);
  CHECK(call("blocks -" + state, part).out.find("\"to\":[11,0,0]") != std::string::npos);
  CHECK(call("check -" + state + " --set axis.x.max_mm=10.5", part).status == 3);
  const Trace trace = parse_trace(call("run -q --dry-run -" + state, part).out);
  CHECK(trace.number(trace.rows.size() - 1, "x_mm") == 11);
}

TEST_CASE("a run without motion that changes nothing leaves the state file alone",
          "[apps][state]") {
  const Folder folder;
  const std::string state = shifted(folder), file = folder / "mill.state";
  write(file, read(file) + "# by hand\n");
  const std::string before = read(file);
  CHECK(call("run -q -" + state, "S100 M03\nG04 P0.1\nM30\n").status == 0);
  CHECK(read(file) == before);
  CHECK(folder.files() == std::vector<std::string>{"mill.state"});
}

TEST_CASE("G10 in a subprogram is kept from run to run", "[apps][state]") {
  const Folder folder;
  const std::string state = shifted(folder), part = folder / "p.nc";
  write(part,
        "o1 call [5]\nG00 X1\nM30\n"
        "o1 sub\n  G10 L2 P1 X[#5221+#1]\n  G10 L1 P3 R2 Z9\no1 endsub\n");
  CHECK(call("run -q " + part + state).status == 0);
  CHECK(call("run -q " + part + state).status == 0);
  const auto kept = hal::load_state(folder / "mill.state");
  REQUIRE(kept);
  CHECK(kept->work[0].origin.x() == 20);
  CHECK(kept->tools.at(3).radius == 2);
  CHECK(call("blocks -" + state, "G43 H3 G00 X1 Z0\nM30\n").out.find("\"to\":[21,0,9]") !=
        std::string::npos);
}

TEST_CASE("a run that an alarm ends keeps what was done up to there", "[apps][state]") {
  const Folder folder;
  const std::string state = shifted(folder), part = folder / "p.nc";
  write(part, "G10 L2 P2 X3\n" + read(data("zigzag.nc")));
  std::string text = read(part);
  text.insert(text.rfind("M30"), "G10 L2 P3 X4\nG04 P1\n");
  write(part, text);
  CHECK(call("run -q " + part + state + " --set axis.x.drive.following_error_um=500").status == 4);
  const auto kept = hal::load_state(folder / "mill.state");
  REQUIRE(kept);
  CHECK(kept->work[1].origin.x() == 3);
  CHECK(kept->work[2].origin.x() == 0);
  CHECK(call("run -q " + part + state).status == 0);
  CHECK(hal::load_state(folder / "mill.state")->work[2].origin.x() == 4);
}

TEST_CASE("a program with an error moves nothing and keeps nothing", "[apps][state]") {
  const Folder folder;
  const std::string state = shifted(folder), file = folder / "mill.state";
  const std::string before = read(file);
  write(folder / "p.nc", "G10 L2 P1 X3\nG00 X1\nG01 X2\nM30\n");
  CHECK(call("run -q " + (folder / "p.nc") + state).status == 1);
  CHECK(read(file) == before);
}

TEST_CASE("a state file that is not there yet is noted and begins at 0", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "mill.state";
  const Ended ended = call("check $data/zigzag.nc --state " + file);
  CHECK(ended.status == 0);
  CHECK(ended.out == file +
                         ": note: does not exist yet: work offsets, tool table and parameters "
                         "begin at 0 [SC7017]\n");
  CHECK(folder.files().empty());
}

TEST_CASE("a state file named by a link that leads nowhere yet is made where it leads",
          "[apps][state]") {
  const Folder folder;
  const std::string link = folder / "link.state", target = folder / "mill.state";
  std::filesystem::create_symlink("mill.state", link);
  write(folder / "p.nc", "G10 L2 P1 X3\nM30\n");
  const std::string run = "run -q " + (folder / "p.nc") + " --state " + link;
  CHECK(call(run).status == 0);
  CHECK(std::filesystem::is_symlink(link));
  CHECK(hal::load_state(target)->work[0].origin.x() == 3);
  CHECK(call(run + " --report " + target).err.find("name the same file: ") != std::string::npos);
}

TEST_CASE("a wrong state file is reported, and nothing moves, exit status 2", "[apps][state]") {
  const Folder folder;
  write(folder / "mill.state", "schema = 1\n[work.G54]\nx = 3\nx_mm = 1e7\n");
  for (const char* command : {"run", "run --dry-run", "check", "blocks", "record -o x.rec"}) {
    CAPTURE(command);
    const Ended ended =
        call(std::string(command) + " $data/square.nc --state " + (folder / "mill.state"));
    CHECK(ended.status == 2);
    const std::string told = ended.out + ended.err;
    const std::size_t first = where_shown(told, "mill.state:3:1: error: ... [SC7015]");
    CHECK(first != std::string::npos);
    CHECK(where_shown(told, "mill.state:4:8: error: ... [SC7005]", first) != std::string::npos);
  }
  const Ended nowhere = call("run $data/square.nc --state " + (folder / "no/mill.state"));
  CHECK(nowhere.status == 5);
  CHECK(shows(nowhere.err, "error: cannot be created: ... [SC6011]"));
  CHECK(call("run " + (folder / "mill.state") + " --state " + (folder / "mill.state")).status == 2);
}

TEST_CASE("a recording holds the state that its program began with", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "run.rec";
  write(folder / "p.nc", "G00 X1\nM30\n");
  CHECK(call("record -q " + (folder / "p.nc") + shifted(folder) + " -o " + file).status == 0);
  write(folder / "mill.state", hal::state_toml({}));
  CHECK(call("replay -q " + file).status == 0);
}

TEST_CASE("only a state that has changed is written", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "mill.state";
  auto memory = MachineMemory::open(file);
  REQUIRE(memory);
  memory->read(at_x(10));
  REQUIRE(memory->keep(at_x(10)));
  CHECK(folder.files().size() == 2);  // the new file and its lock
  CHECK_FALSE(std::filesystem::exists(file));
  REQUIRE(memory->keep(at_x(11)));
  *memory = MachineMemory();
  CHECK(folder.files() == std::vector<std::string>{"mill.state"});
  CHECK(*hal::load_state(file) == at_x(11));
}

TEST_CASE("after a stop the state is that of the block where it rests", "[apps][state]") {
  runtime::BlockHistory<MachineState> states(at_x(0));
  states.add(1, at_x(0));
  states.add(2, at_x(2));
  states.add(3, at_x(2));
  states.add(5, at_x(5));
  CHECK(states.last() == at_x(5));
  CHECK(states.present() == at_x(0));
  states.pass(1);
  CHECK(states.present() == at_x(0));
  states.pass(2);
  CHECK(states.present() == at_x(2));
  states.pass(4);
  CHECK(states.present() == at_x(2));
  states.pass(9);
  CHECK(states.present() == at_x(5));
}
