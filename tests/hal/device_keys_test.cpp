// SPDX-License-Identifier: MIT
// M codes, outputs and inputs of a machine file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "hal/machine/device_keys.hpp"
#include "hal/machine/machine_file.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::parsed;
using test::Settings;
using Lines = std::vector<std::string>;

const std::string kDevices = R"([mcode.31]
do = "output"
output = "conveyor"
value = 1
[mcode.33]
do = "output"
output = 3
value = 0
[mcode.40]
do = "dwell"
seconds = 1.5
[mcode.88]
do = "coolant"
coolant = "flood"
[mcode.101]
words = "pq"
[mcode.103]
do = "spindle"
direction = "ccw"
[mcode.110]
do = "stop"
[output.conveyor]
number = 3
[output.power]
number = 3
kind = "analog"
[input.door]
value = 1
lines = [4, 4, 9]
values = [0, 1, 0]
after_s = [0, 0.5, 2]
[input.level]
number = 2
kind = "analog"
value = -2.5
)";

/// The diagnostics of a machine file, as softcnc shows them without the source lines.
Lines shown(const std::string& text, const Settings& settings = {}) {
  const auto machine = parse_machine(text, "mill.toml", settings);
  Lines all;
  if (machine) return all;
  for (const Diagnostic& diagnostic : machine.error()) {
    const std::string one = render(diagnostic);
    all.push_back(one.substr(0, one.find('\n')));
  }
  return all;
}

}  // namespace

TEST_CASE("M codes, outputs and inputs reach the machine", "[hal][machine][mcode]") {
  const Machine machine = parsed(kDevices);
  REQUIRE(machine.m_codes.size() == 7);
  CHECK(machine.m_codes.at(31).act == MachineCodeAct::output);
  CHECK(machine.m_codes.at(31).output == "conveyor");
  CHECK(machine.m_codes.at(31).value == 1);
  CHECK(machine.m_codes.at(33).output == "3");
  CHECK(machine.m_codes.at(40).act == MachineCodeAct::dwell);
  CHECK(machine.m_codes.at(40).seconds == 1.5);
  CHECK(machine.m_codes.at(88).act == MachineCodeAct::coolant);
  CHECK(machine.m_codes.at(88).coolant == CoolantSwitch::flood);
  CHECK(machine.m_codes.at(101).act == MachineCodeAct::ignore);
  CHECK(machine.m_codes.at(101).words == "PQ");
  CHECK(machine.m_codes.at(103).act == MachineCodeAct::spindle);
  CHECK(machine.m_codes.at(103).direction == SpindleTurn::ccw);
  CHECK(machine.m_codes.at(110).act == MachineCodeAct::stop);
  REQUIRE(machine.outputs.size() == 2);
  CHECK(machine.outputs.at("conveyor").number == 3);
  CHECK(machine.outputs.at("conveyor").kind == SignalKind::digital);
  CHECK(machine.outputs.at("power").kind == SignalKind::analog);
  REQUIRE(machine.inputs.size() == 2);
  const InputPort& door = machine.inputs.at("door");
  CHECK(door.number == 0);
  CHECK(door.value == 1);
  CHECK(door.lines == std::vector<double>{4, 4, 9});
  CHECK(door.values == std::vector<double>{0, 1, 0});
  CHECK(door.after == std::vector<double>{0, 0.5, 2});
  CHECK(machine.inputs.at("level").value == -2.5);
  CHECK(find_output(machine.outputs, "3")->first == "conveyor");
  CHECK(find_output(machine.outputs, "power")->second.kind == SignalKind::analog);
}

TEST_CASE("a machine with devices reads back from its text", "[hal][machine][mcode]") {
  const std::string text = machine_toml(parsed(kDevices));
  CHECK(text.find("\n[mcode.40]\ndo = \"dwell\"\nseconds = 1.5\nwords = \"\"\n") !=
        std::string::npos);
  CHECK(text.find("\n[input.door]\nnumber = 0\nkind = \"digital\"\nvalue = 1\nlines = [4, 4, 9]\n"
                  "values = [0, 1, 0]\nafter_s = [0, 0.5, 2]\n") != std::string::npos);
  CHECK(machine_toml(parsed(text)) == text);
}

TEST_CASE("a machine without devices has no tables of them", "[hal][machine][mcode]") {
  const std::string text = machine_toml(Machine{});
  for (const char* table : {"[mcode", "[output", "[input"})
    CHECK(text.find(table) == std::string::npos);
}

TEST_CASE("settings define devices, too", "[hal][machine][mcode]") {
  const Machine machine = parsed("", {"mcode.31.do=stop", "output.pump.number=2",
                                      "input.door.lines=[1, 2]", "input.door.values=[1, 0]"});
  CHECK(machine.m_codes.at(31).act == MachineCodeAct::stop);
  CHECK(machine.outputs.at("pump").number == 2);
  CHECK(machine.inputs.at("door").lines == std::vector<double>{1, 2});
  CHECK(shown("", {"mcode.8.do=stop"}) ==
        Lines{"--set:1:1: error: M08 is a code of softcnc itself, which a machine cannot define "
              "[SC7023]"});
  CHECK(shown("", {"output.pump=2"}) ==
        Lines{"--set:1:1: error: unknown key 'output.pump' [SC7001]"});
  CHECK(shown("", {"input.door.valu=1"}) ==
        Lines{"--set:1:1: error: unknown key 'input.door.valu'; did you mean 'input.door.value'? "
              "[SC7001]"});
}

TEST_CASE("codes of softcnc itself cannot be defined again", "[hal][machine][mcode]") {
  CHECK(shown("[mcode.3]\ndo = \"stop\"\n[mcode.30]\n") ==
        Lines{"mill.toml:1:8: error: M03 is a code of softcnc itself, which a machine cannot "
              "define [SC7023]",
              "mill.toml:3:8: error: M30 is a code of softcnc itself, which a machine cannot "
              "define [SC7023]"});
}

TEST_CASE("keys that do not go with 'do', or are missing, are errors", "[hal][machine][mcode]") {
  CHECK(shown("[mcode.31]\ndo = \"dwell\"\n[mcode.32]\nseconds = 2\n[mcode.33]\ndo = "
              "\"spindle\"\ncoolant = \"mist\"\n") ==
        Lines{"mill.toml:2:6: error: mcode.31.do = 'dwell' needs mcode.31.seconds [SC7024]",
              "mill.toml:4:11: error: mcode.32.seconds does not go with mcode.32.do = 'ignore' "
              "[SC7024]",
              "mill.toml:6:6: error: mcode.33.do = 'spindle' needs mcode.33.direction [SC7024]",
              "mill.toml:7:11: error: mcode.33.coolant does not go with mcode.33.do = 'spindle' "
              "[SC7024]"});
}

TEST_CASE("outputs and inputs have numbers of their own", "[hal][machine][mcode]") {
  CHECK(shown("[output.a]\n[output.b]\nnumber = 0\n[input.c]\n[input.d]\n[input.e]\nkind = "
              "\"analog\"\n") ==
        Lines{"mill.toml:3:10: error: output.b has the number of output.a: digital 0 [SC7025]",
              "mill.toml:5:8: error: input.d has the number of input.c: digital 0 [SC7025]"});
}

TEST_CASE("an M code sets an output that there is, to a value it takes", "[hal][machine][mcode]") {
  CHECK(shown("[output.a]\n[mcode.31]\ndo = \"output\"\noutput = \"b\"\nvalue = 1\n[mcode.32]\n"
              "do = \"output\"\noutput = 0\nvalue = 2\n") ==
        Lines{"mill.toml:4:10: error: mcode.31.output = 'b' is no output of the machine [SC7026]",
              "mill.toml:9:9: error: mcode.32.value = 2, and output 'a' is digital: it takes 0 or "
              "1 [SC7027]"});
}

TEST_CASE("values of devices that do not fit are errors", "[hal][machine][mcode]") {
  CHECK(shown("[mcode.31]\nwords = \"PX\"\ndo = \"wait\"\n[mcode.32]\ndo = 1\n[input.a]\nnumber = "
              "1.5\nvalue = true\n[input.b]\nnumber = 1000\nlines = [0]\n") ==
        Lines{"mill.toml:2:9: error: mcode.31.words takes letters other than F G M N O S T X Y Z, "
              "not 'PX' [SC7027]",
              "mill.toml:3:6: error: mcode.31.do must be one of 'ignore', 'stop', 'dwell', "
              "'spindle', 'coolant', 'output', not 'wait' [SC7006]",
              "mill.toml:5:6: error: mcode.32.do takes one of 'ignore', 'stop', 'dwell', "
              "'spindle', 'coolant', 'output' [SC7004]",
              "mill.toml:7:10: error: input.a.number takes an integer [SC7004]",
              "mill.toml:8:9: error: input.a.value takes a number [SC7004]",
              "mill.toml:10:10: error: input.b.number must be at least 0 and at most 999, not "
              "1000 [SC7005]",
              "mill.toml:11:9: error: input.b.lines must be at least 1 and at most 1e+09, not 0 "
              "[SC7005]"});
  CHECK(shown("[input.a]\nlines = [1, 2]\nvalues = [1]\nafter_s = [0]\n[input.b]\nnumber = 1\n"
              "value = 0.5\n[input.c]\nnumber = 2\nlines = [1.5]\n") ==
        Lines{"mill.toml:3:10: error: input.a.values has 1 entries, and input.a.lines 2 [SC7027]",
              "mill.toml:4:11: error: input.a.after_s has 1 entries, and input.a.lines 2 [SC7027]",
              "mill.toml:7:9: error: input.b.value = 0.5, and input 'b' is digital: it takes 0 or "
              "1 [SC7027]",
              "mill.toml:10:9: error: input.c.lines takes the numbers of lines, which are whole "
              "[SC7027]"});
}

TEST_CASE("tables and keys of devices that are unknown are errors", "[hal][machine][mcode]") {
  CHECK(shown("[mcode.031]\ndo = \"stop\"\n[mcode.x]\n[output.\"a b\"]\n") ==
        Lines{"mill.toml:1:8: error: unknown key 'mcode.031' [SC7001]",
              "mill.toml:3:8: error: unknown key 'mcode.x' [SC7001]",
              "mill.toml:4:9: error: unknown key 'output.a b' [SC7001]"});
  CHECK(shown("mcode = 1\n") == Lines{"mill.toml:1:9: error: mcode must be a table [SC7004]"});
  CHECK(shown("[output]\na = 1\n") ==
        Lines{"mill.toml:2:5: error: output.a must be a table [SC7004]"});
  CHECK(shown("[mcode.31]\ndoes = \"stop\"\n").size() == 1);
}

TEST_CASE("the effective machine shows its devices", "[hal][machine][mcode]") {
  const auto values = effective_values("", Settings{"mcode.31.do=dwell", "mcode.31.seconds=2"});
  REQUIRE(values);
  const auto found = std::find_if(values->begin(), values->end(), [](const EffectiveValue& value) {
    return value.key == "mcode.31.seconds";
  });
  REQUIRE(found != values->end());
  CHECK(found->value == "2");
  CHECK(found->unit == "s");
  CHECK(found->origin == "--set");
}

TEST_CASE("docs/machine.md shows the table of keys of devices", "[hal][machine][mcode][docs]") {
  CHECK(test::read(std::string(SOFTCNC_SOURCE_DIR) + "/docs/machine.md").find(device_key_table()) !=
        std::string::npos);
}

}  // namespace softcnc::hal
