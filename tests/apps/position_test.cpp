// SPDX-License-Identifier: MIT
// Where the machine stands, from one process to the next; and `softcnc state`.
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/recording_entries.hpp"
#include "apps/shell.hpp"
#include "apps/talk.hpp"
#include "hal/machine/state_file.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app::test;

namespace {

void wait_for(const std::function<bool()>& what) {
  for (int i = 0; i < 1000 && !what(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  REQUIRE(what());
}

}  // namespace

TEST_CASE("three programs with a state end where one program of their lines ends",
          "[apps][state]") {
  const Folder folder;
  const std::array<std::string, 3> parts{
      "G21 G90 G94 G54\nG01 X10 Y5 F3000\nT3 M06\nG10 L2 P1 X2.5\n",
      "G21 G91 G94 G54\nG01 X-3.125 Z-2 F3000\nG30.1\n",
      "G20 G91 G94 G54\nG02 X1 Y0 I0.5 J0 F100\nG28.1\n"};
  for (const std::string& part : parts)
    REQUIRE(call("run -q - --state " + (folder / "parts.state"), part + "M30\n").status == 0);
  REQUIRE(
      call("run -q - --state " + (folder / "one.state"), parts[0] + parts[1] + parts[2] + "M30\n")
          .status == 0);
  const auto apart = hal::load_state(folder / "parts.state");
  const auto whole = hal::load_state(folder / "one.state");
  REQUIRE(apart);
  REQUIRE(whole);
  CHECK((apart->place() - whole->place()).norm() < 1e-9);
  CHECK_FALSE(apart->position->in_motion);
  CHECK(apart->loaded_tool == 3);
  CHECK((apart->home - whole->home).norm() < 1e-9);
  CHECK((apart->second_home - AxisVector(6.875, 5, -2)).norm() < 1e-9);
  CHECK(apart->work == whole->work);
}

TEST_CASE("commands that compute a run begin where the machine stands", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "mill.state", state = " --state " + file;
  REQUIRE(call("state set position X10 Y20 Z0" + state).status == 0);
  const std::string part = "G91 G01 X1 F600\nM30\n";
  CHECK(call("blocks -" + state, part).out.find("\"from\":[10,20,0],\"to\":[11,20,0]") !=
        std::string::npos);
  const Ended beyond = call("check - --set axis.x.max_mm=10.5" + state, part);
  CHECK(beyond.status == 3);
  const Trace trace = parse_trace(call("run -q --dry-run -" + state, part).out);
  CHECK(trace.number(0, "x_mm") == 10);
  CHECK(trace.number(0, "y_mm") == 20);
  write(folder / "p.nc", part);
  REQUIRE(call("record -q " + (folder / "p.nc") + state + " -o " + (folder / "p.rec")).status == 0);
  CHECK(hal::load_state(file)->place() == AxisVector(10, 20, 0));  // it only rehearses
  const auto meta = nlohmann::json::parse(entry(folder / "p.rec", "meta.json"));
  CHECK(meta["start"]["position_mm"] == nlohmann::json({10, 20, 0}));
  REQUIRE(call("state set position X0" + state).status == 0);
  CHECK(call("replay -q " + (folder / "p.rec")).status == 0);
}

TEST_CASE("a run that is killed in motion leaves the position unknown", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "mill.state", state = " --state " + file;
  const std::string part = folder / "p.nc";
  write(part, "G10 L2 P2 X3\nG01 X100 F60\nM30\n");
  REQUIRE(call("state set position X1 Y2 Z3" + state).status == 0);
  Talk run({"run", "-q", "--realtime", part, "--state", file});
  wait_for([&] { return hal::load_state(file)->position->in_motion; });
  run.send(SIGKILL);
  CHECK(run.status() == 128 + SIGKILL);
  const Ended next = call("run -q " + part + state);
  CHECK(next.status == 4);
  CHECK(
      shows(next.err, "mill.state: error: the position of the machine is not known: ... [SC5070]"));
  CHECK(shows(next.err, "softcnc state set position"));
  CHECK(call("run -q --assume-position " + part + state).status == 4);
  const Ended checked = call("check " + part + state);
  CHECK(checked.status == 0);
  CHECK(shows(checked.out,
              "mill.state: warning: the position of the machine is not known: ... [SC5072]"));
  CHECK(call("state show" + state).out.find("not known: a run that began at X1 ") !=
        std::string::npos);
  CHECK(call("state set position X5" + state).status == 2);  // of all axes nothing is known
  REQUIRE(call("state set position X5 Y2 Z3" + state).status == 0);
  CHECK(call("run -q " + part + state).status == 0);
  CHECK(hal::load_state(file)->place() == AxisVector(100, 2, 3));
}

TEST_CASE("a run that is stopped keeps the place where it rests", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "mill.state";
  write(folder / "p.nc", "G01 X100 F600\nM30\n");
  Talk run(
      {"run", "-q", "--realtime", folder / "p.nc", "--state", file, "--trace", folder / "t.csv"});
  wait_for([&] { return std::filesystem::exists(file); });
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  run.send(SIGINT);
  CHECK(run.status() == 130);
  const auto kept = hal::load_state(file);
  REQUIRE(kept);
  CHECK_FALSE(kept->position->in_motion);
  const Trace trace = parse_trace(read(folder / "t.csv"));
  CHECK(kept->place().x() == Approx(trace.number(trace.rows.size() - 1, "x_mm")).margin(1e-6));
  CHECK(kept->place().x() > 0);
  CHECK(kept->place().x() < 100);
}

TEST_CASE("on a port somebody confirms that the machine still stands there", "[apps][state]") {
  const Folder folder;
  const std::string state = " --state " + (folder / "mill.state"), part = "G01 X1 F600\nM30\n";
  const std::string port =
      " --backend hal-stream --set backend.hal-stream.file=" + (folder / "rows");
  const Ended refused = call("run -q -" + port + state, part);
  CHECK(refused.status == 4);
  CHECK(shows(refused.err, "mill.state: error: the machine should stand at X0 Y0 Z0 ... [SC5071]"));
  CHECK(folder.files().empty());
  CHECK(call("run -q --assume-position -" + port + state, part).status == 0);
  CHECK(hal::load_state(folder / "mill.state")->place() == AxisVector(1, 0, 0));
  CHECK(call("run -q -" + port + state, part).status == 4);
  CHECK(call("check -" + state, part).status == 0);
}

TEST_CASE("state sets offsets and shows what a file holds", "[apps][state]") {
  const Folder folder;
  const std::string file = folder / "mill.state", state = " --state " + file;
  REQUIRE(call("state set G54 X-200 y-150.5" + state).status == 0);
  REQUIRE(call("state set g54.1p7 Z4" + state).status == 0);
  REQUIRE(call("state set G28 X1" + state).status == 0);
  REQUIRE(call("state set position X-190 Y-150.5 Z-1" + state).status == 0);
  const auto kept = hal::load_state(file);
  REQUIRE(kept);
  CHECK(kept->work[0].origin == AxisVector(-200, -150.5, 0));
  CHECK(kept->further_work.at(7).origin == AxisVector(0, 0, 4));
  CHECK(kept->home == AxisVector(1, 0, 0));
  const std::string shown = call("state show" + state).out;
  CHECK(shown ==
        "position        X-190        Y-150.5      Z-1\n"
        "  in G54        X10          Y0           Z-1\n"
        "work system     G54\n"
        "G54             X-200        Y-150.5      Z0\n"
        "G54.1 P7        X0           Y0           Z4\n"
        "G28             X1           Y0           Z0\n");
  const std::string before = read(file);
  for (const char* wrong : {"set", "set G53 X1", "set G54", "set G54 X1 X2", "set G54 A1",
                            "set G54 Xa", "set position X1e9", "list", "show all"}) {
    CAPTURE(wrong);
    const Ended refused = call(std::string("state ") + wrong + state);
    CHECK(refused.status == 2);
    CHECK(refused.err.find("state") != std::string::npos);
  }
  CHECK(call("state show").status == 2);
  CHECK(call("state show --state " + (folder / "none")).status == 2);
  CHECK(read(file) == before);
}
