// SPDX-License-Identifier: MIT
// States into text and back; what is wrong with a file; and that no crash leaves half of one.
#include "hal/machine/state_file.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <random>

#include "hal/files/output_file.hpp"
#include "motion/core/units.hpp"
#include "support/shown.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

MachineState full_state(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1000, 1000);
  const auto vector = [&] { return AxisVector(any(random), any(random), any(random)); };
  MachineState state;
  for (WorkOffset& work : state.work) work = {vector(), rad_from_deg(any(random))};
  for (int i = 0; i < 10; ++i)
    state.further_work[1 + static_cast<int>(random() % kFurtherSystems)] = {
        vector(), rad_from_deg(any(random))};
  state.further_homes[random() % 2] = vector();
  state.active = static_cast<int>(random() % (kWorkSystems + kFurtherSystems));
  state.shift = vector();
  state.shift_on = random() % 2 == 0;
  state.home = vector();
  state.second_home = vector();
  for (int i = 0; i < 20; ++i) {
    state.tools[1 + static_cast<int>(random() % 500)] = {vector(), any(random), any(random),
                                                         any(random)};
    state.parameters[31 + static_cast<int>(random() % 5000)] = any(random) * 1e-12;
  }
  return state;
}

std::string told(const StateOrErrors& state) {
  REQUIRE_FALSE(state);
  std::string text;
  for (const Diagnostic& fault : state.error()) text += render(fault);
  return text;
}

std::string refused_state(const std::string& text) {
  return told(parse_state("schema = 1\n" + text, "mill.state"));
}

}  // namespace

TEST_CASE("the start state is written out in full", "[hal][state]") {
  const std::string text = state_toml({});
  CHECK(
      text.starts_with("# What programs have left on the machine. softcnc run --state writes it.\n"
                       "schema = 1\nactive = \"G54\"\ng92_in_force = \"no\"\n\n"
                       "[g92]\nx_mm = 0\ny_mm = 0\nz_mm = 0\n\n[g28]\n"));
  CHECK(text.find("\n[work.\"G59.3\"]\nx_mm = 0\ny_mm = 0\nz_mm = 0\nrotation_deg = 0\n") !=
        std::string::npos);
  const auto state = parse_state(text, "mill.state");
  REQUIRE(state);
  CHECK(*state == MachineState());
}

TEST_CASE("every number of a state file reaches its place in internal units", "[hal][state]") {
  const auto state = parse_state(R"(schema = 1
active = "G59.1"
g92_in_force = "yes"
g92.x_mm = 1
g28 = { y_mm = 2.5 }
[g30]
z_mm = -3
[work.G55]
x_mm = 4
rotation_deg = 90
[work."G59.3"]
z_mm = 5
[tool.12]
z_mm = 61.5
radius_mm = 3
length_wear_mm = -0.1
radius_wear_mm = -0.02
[parameter]
500 = 1e-3
5399 = -7
)",
                                 "mill.state");
  REQUIRE(state);
  MachineState expected;
  expected.active = 6;
  expected.shift_on = true;
  expected.shift[0] = 1;
  expected.home[1] = 2.5;
  expected.second_home[2] = -3;
  expected.work[1] = {{4, 0, 0}, rad_from_deg(90)};
  expected.work[8].origin[2] = 5;
  expected.tools[12] = {{0, 0, 61.5}, 3, -0.1, -0.02};
  expected.parameters = {{500, 1e-3}, {5399, -7}};
  CHECK(*state == expected);
}

TEST_CASE("further work systems and reference points stand in a state file if they are used",
          "[hal][state]") {
  const auto state = parse_state(
      "schema = 1\nactive = \"G54.1 P300\"\n[g30_p3]\nz_mm = -100\n"
      "[work.\"G54.1 P2\"]\nx_mm = 7\n[work.\"G54.1 P300\"]\ny_mm = 8\n",
      "mill.state");
  REQUIRE(state);
  MachineState expected;
  expected.active = kWorkSystems + 299;
  expected.further_work[2].origin[0] = 7;
  expected.further_work[300].origin[1] = 8;
  expected.further_homes[0] = AxisVector(0, 0, -100);
  CHECK(*state == expected);
  const std::string text = state_toml(expected);
  CHECK(text.find("[g30_p3]\nx_mm = 0\ny_mm = 0\nz_mm = -100\n") != std::string::npos);
  CHECK(text.find("g30_p4") == std::string::npos);
  CHECK(text.find("[work.\"G54.1 P2\"]\nx_mm = 7\n") != std::string::npos);
  MachineState zero;
  zero.further_work[5] = {};
  CHECK(state_toml(zero) == state_toml({}));
}

TEST_CASE("names of further work systems that are none are refused", "[hal][state]") {
  for (const char* name : {"G54.1 P0", "G54.1 P301", "G54.1", "G54.1 P", "G54.1 P03"})
    CHECK(refused_state("[work.\"" + std::string(name) + "\"]\n")
              .starts_with("mill.state:2:7: error: unknown key"));
  CHECK(
      shows(refused_state("active = \"G54.1 P301\"\n"), "or 'G54.1 P1' to 'G54.1 P300' [SC7006]"));
}

TEST_CASE("any state reads back bit for bit, and is the same text again", "[hal][state]") {
  std::mt19937 random(20260101);
  for (int i = 0; i < 200; ++i) {
    const MachineState state = full_state(random);
    const std::string text = state_toml(state);
    const auto back = parse_state(text, "mill.state");
    REQUIRE(back);
    CHECK(*back == state);
    CHECK(state_toml(*back) == text);
  }
}

TEST_CASE("parameters that are 0 need not be stated", "[hal][state]") {
  MachineState state;
  state.parameters[100] = 0;
  CHECK(state_toml(state) == state_toml({}));
}

TEST_CASE("named globals are numbers of the state", "[hal][state]") {
  MachineState state;
  state.globals = {{"_td", 3}, {"_zero", 0}, {"_a.b \\\"ü", -1e-3}};
  const std::string text = state_toml(state);
  CHECK(text.ends_with("\n[parameter]\n\"_a.b \\\\\\\"ü\" = -0.001\n_td = 3\n_zero = 0\n"));
  MachineState plain = state;
  plain.globals.erase("_a.b \\\"ü");
  plain.globals["_a.b\\\"ü"] = -1e-3;  // without blanks, as programs read names
  const auto back = parse_state(text, "mill.state");
  REQUIRE(back);
  CHECK(*back == plain);
  const auto capitals = parse_state("schema = 1\n[parameter]\n_TD = 3.5\n500 = 1\n", "a");
  REQUIRE(capitals);
  CHECK(capitals->globals == std::map<std::string, double>{{"_td", 3.5}});
  CHECK(capitals->parameters == std::map<int, double>{{500, 1.0}});
}

TEST_CASE("a name that is no global is refused with its place", "[hal][state]") {
  CHECK(begins_showing(refused_state("[parameter]\ntd = 3\n"),
                       "mill.state:3:1: error: unknown key 'parameter.td': ... [SC7015]"));
  CHECK(
      begins_showing(refused_state("[parameter]\n_ = 3\n"), "mill.state:3:1: error: ... [SC7015]"));
  CHECK(begins_showing(refused_state("[parameter]\n\"_a>\" = 3\n"),
                       "mill.state:3:1: error: ... [SC7015]"));
  CHECK(begins_showing(refused_state("[parameter]\n_td = \"a\"\n"),
                       "mill.state:3:7: error: parameter._td takes a number [SC7004]"));
  CHECK(begins_showing(refused_state("[parameter]\n_td = inf\n"),
                       "mill.state:3:7: error: ... [SC7005]"));
  CHECK(begins_showing(refused_state("[parameter]\n_td = 1\n_TD = 2\n"),
                       "mill.state:4:1: error: '_td' is given twice [SC7012]"));
}

TEST_CASE("what is wrong with a state file is reported with its place", "[hal][state]") {
  CHECK(refused_state("[work.G54]\nx = 3\n") ==
        "mill.state:3:1: error: unknown key 'work.G54.x' [SC7015]\n"
        "    3 | x = 3\n      | ^\n");
  CHECK(refused_state("[parameter]\n30 = 3\n")
            .starts_with("mill.state:3:1: error: unknown key 'parameter.30': a parameter is a "
                         "number from 31 to 10999, or the name of a global variable, which begins "
                         "with '_' [SC7015]\n"));
  CHECK(refused_state("[work.G60]\n")
            .starts_with("mill.state:2:7: error: unknown key 'work.G60' [SC7015]\n"));
  CHECK(refused_state("[g28]\nx_mm = \"a\"\n")
            .starts_with("mill.state:3:8: error: g28.x_mm takes a number [SC7004]\n"));
  CHECK(refused_state("tool = 3\n")
            .starts_with("mill.state:2:8: error: tool must be a table [SC7004]\n"));
  CHECK(refused_state("[g28]\nx_mm = 1e7\n")
            .starts_with("mill.state:3:8: error: g28.x_mm must be from -1e+06 to 1e+06, not 1e+07 "
                         "[SC7005]\n"));
  CHECK(begins_showing(refused_state("[parameter]\n31 = nan\n"),
                       "mill.state:3:6: error: ... [SC7005]"));
  CHECK(begins_showing(refused_state("active = \"G60\"\n"),
                       "mill.state:2:10: error: active takes one of 'G54', 'G55', ... [SC7006]"));
  CHECK(
      refused_state("g92_in_force = 1\n")
          .starts_with("mill.state:2:16: error: g92_in_force takes one of 'no', 'yes' [SC7004]\n"));
  CHECK(begins_showing(
      refused_state("[g28\n"),
      "mill.state:2:5: error: not TOML: table header: expected ']', saw ... [SC7013]"));
  CHECK(shows(refused_state("[g28]\nx_mm = 1\nx_mm = 2\n"), "error: ... [SC7012]"));
  CHECK(told(parse_state("", "mill.state")) ==
        "mill.state: error: is not a state file of softcnc: it names no schema [SC7016]\n");
  CHECK(told(parse_state("schema = 2\n", "mill.state"))
            .starts_with("mill.state:1:10: error: is a state of schema 2; this version "
                         "reads schema 1 [SC7016]\n"));
  CHECK(told(load_state("no/such.state")) ==
        "no/such.state: error: cannot be read: No such file or directory [SC7014]\n");
}

TEST_CASE("all errors of a state file are reported, by their lines", "[hal][state]") {
  CHECK(refused_state("[work.G54]\ny = 3\nx_mm = 1\nz_mm = 1e7\n[g28]\nx_mm = \"a\"\n") ==
        "mill.state:3:1: error: unknown key 'work.G54.y' [SC7015]\n"
        "    3 | y = 3\n      | ^\n"
        "mill.state:5:8: error: work.G54.z_mm must be from -1e+06 to 1e+06, not 1e+07 [SC7005]\n"
        "    5 | z_mm = 1e7\n      |        ^~~\n"
        "mill.state:7:8: error: g28.x_mm takes a number [SC7004]\n"
        "    7 | x_mm = \"a\"\n      |        ^~~\n");
}

TEST_CASE("what stands in a table that is refused is not reported as well", "[hal][state]") {
  CHECK(refused_state("[work.G60]\nx_mm = 3\ny = 4\n[work.G600]\n[g92]\nq = 1\n") ==
        "mill.state:2:7: error: unknown key 'work.G60' [SC7015]\n"
        "    2 | [work.G60]\n      |       ^~~\n"
        "mill.state:5:7: error: unknown key 'work.G600' [SC7015]\n"
        "    5 | [work.G600]\n      |       ^~~~\n"
        "mill.state:7:1: error: unknown key 'g92.q' [SC7015]\n"
        "    7 | q = 1\n      | ^\n");
}

TEST_CASE("of a file of another schema nothing else is reported", "[hal][state]") {
  CHECK(told(parse_state("axis = 3\nperiod = \"a\"\n", "mill.state")) ==
        "mill.state: error: is not a state file of softcnc: it names no schema [SC7016]\n");
  CHECK(told(parse_state("schema = 2\nnew = 3\n", "mill.state")).find("SC7015") ==
        std::string::npos);
}

TEST_CASE("a crash in the middle of writing leaves a whole state", "[hal][state]") {
  const test::Folder folder;
  const std::string file = folder / "mill.state";
  std::mt19937 random(7);
  const MachineState one = full_state(random), other = full_state(random);
  const std::string texts[] = {state_toml(one), state_toml(other)};
  REQUIRE(write_file(file, texts[0]));
  for (int round = 0; round < 40; ++round) {
    const pid_t writer = ::fork();
    REQUIRE(writer >= 0);
    if (writer == 0)
      for (std::size_t i = 0;; ++i) static_cast<void>(write_file(file, texts[i % 2]));
    ::usleep(static_cast<useconds_t>(random() % 5000));
    ::kill(writer, SIGKILL);
    ::waitpid(writer, nullptr, 0);
    const auto left = load_state(file);
    REQUIRE(left);
    CHECK((*left == one || *left == other));
  }
}

TEST_CASE("a full disk leaves the old state", "[hal][state]") {
  const test::Folder folder;
  const std::string file = folder / "mill.state";
  std::mt19937 random(8);
  const std::string old = state_toml({}), fresh = state_toml(full_state(random));
  REQUIRE(write_file(file, old));
  for (const rlim_t room : {rlim_t{0}, rlim_t{1}, static_cast<rlim_t>(fresh.size() - 1)}) {
    const pid_t writer = ::fork();
    REQUIRE(writer >= 0);
    if (writer == 0) {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{room, room};
      ::setrlimit(RLIMIT_FSIZE, &limit);
      const auto written = write_file(file, fresh);
      ::_exit(written ? 0 : written.error().code == Code::SC6012 ? 5 : 1);
    }
    int status = 0;
    ::waitpid(writer, &status, 0);
    CHECK(WEXITSTATUS(status) == 5);
    CHECK(test::read(file) == old);
  }
}

}  // namespace softcnc::hal
