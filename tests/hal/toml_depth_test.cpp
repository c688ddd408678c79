// SPDX-License-Identifier: MIT
// TOML that is nested deeper, or longer, than any parser may be trusted with.
#include "hal/machine/toml_depth.hpp"

#include <catch2/catch.hpp>

#include "hal/machine/machine_file.hpp"
#include "hal/machine/machine_keys.hpp"
#include "hal/machine/machine_value.hpp"
#include "hal/machine/state_file.hpp"

namespace softcnc::hal {
namespace {

std::string repeated(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

bool is_flat(const std::string& text) { return check_toml_depth(text).has_value(); }

/// Machine files so many levels deep, in every way in which TOML has levels.
std::vector<std::string> nested(std::size_t depth) {
  const std::string keys = repeated(depth - 1, "a.") + "a";
  return {keys + " = 1\n",
          "[" + keys + "]\n",
          "[[" + keys + "]]\n",
          repeated(depth - 1, "a . ") + "a = 1",
          repeated(depth - 1, "\"b\".") + "'c' = 1\n",
          repeated(depth, "a = {") + repeated(depth, "}"),
          "a = " + repeated(depth, "[\n") + repeated(depth, "]"),
          "a = [ # deep [[\n" + repeated(depth, "{a.b = [") + repeated(depth, "]}") + "]"};
}

}  // namespace

TEST_CASE("TOML nested deeply is refused with its place, and no stack runs over",
          "[hal][machine][code]") {
  for (const std::size_t depth : {100UL, 2'000UL}) {
    for (const std::string& text : nested(depth)) {
      CAPTURE(depth, text.substr(0, 30));
      CHECK_FALSE(is_flat(text));
      const auto machine = parse_machine(text, "mill.toml", {});
      REQUIRE_FALSE(machine);
      CHECK(exit_status(machine.error().front()) == 2);
      CHECK(machine.error().front().pos.line > 0);
      const auto state = parse_state(text, "mill.state");
      REQUIRE_FALSE(state);
      CHECK(exit_status(state.error().front()) == 2);
    }
  }
  for (const std::string key : {"a.", "\"a\".", "a .\t"}) {
    const std::string text = "name = 'x'\n" + repeated(1'500, key) + "a = 1\n";
    const auto machine = parse_machine(text, "mill.toml", {});
    REQUIRE_FALSE(machine);
    CHECK(machine.error().front().code == Code::SC7022);
  }
  const auto machine = parse_machine(repeated(70, "a.") + "a = 1\n", "mill.toml", {});
  REQUIRE_FALSE(machine);
  CHECK(render(machine.error().front())
            .starts_with(
                "mill.toml:1:130: error: nested too deeply: more than 64 levels [SC7022]\n"));
}

TEST_CASE("what is deep, but within the limit, is TOML like any other", "[hal][machine]") {
  for (const std::string& text : nested(15)) {
    CAPTURE(text);
    CHECK(is_flat(text));
  }
}

TEST_CASE("dots and brackets of strings, comments and numbers are no levels", "[hal][machine]") {
  const std::string many = repeated(200, ".[{");
  for (const std::string& text :
       {"name = \"" + many + "\"\n", "name = '" + many + "'\n", "name = \"\\\"" + many + "\"\n",
        "name = \"\"\"\n" + many + "\n\"" + many + "\\\"\"\"" + many + "\"\"\"\"\"\n",
        "name = '''" + many + "\n\\''''\n", "# " + many + "\nname = 'a' # " + many,
        repeated(200, "a = 1.5\n"), "a = [" + repeated(200, "1.5, ") + "]\n",
        "a = [" + repeated(200, "1.5,\n") + "]\n", repeated(200, "[a.b]\nc = {d.e = 1}\n")}) {
    CAPTURE(text.substr(0, 40));
    CHECK(is_flat(text));
    CHECK_FALSE(is_flat(text + '\n' + repeated(65, "[") + '\n'));  // and it has ended
  }
}

TEST_CASE("a table's name that is left open ends with its line", "[hal][machine]") {
  CHECK(is_flat(repeated(200, "[axis.x\n")));
}

TEST_CASE("a line of TOML longer than any key is refused", "[hal][machine][code]") {
  const auto machine = parse_machine("\nname = '" + std::string(10'000, 'x') + "'\n", "m.toml", {});
  REQUIRE_FALSE(machine);
  CHECK(render(machine.error().front())
            .starts_with("m.toml:2:1: error: not TOML: a line longer than 8192 bytes [SC7002]\n"));
}

TEST_CASE("a setting whose value is nested deeply is a text", "[hal][machine]") {
  const std::string deep = repeated(2'000, "[");
  const std::vector<std::string> settings{"axis.x.blu_um=" + deep, "name=" + deep};
  const auto machine = parse_machine("", "mill.toml", settings);
  REQUIRE_FALSE(machine);
  CHECK(machine.error().size() == 1);
  CHECK(machine.error().front().code == Code::SC7004);
}

TEST_CASE("of a file that is wrong all over the first thousand errors are reported",
          "[hal][machine]") {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "k" + std::to_string(i) + " = 1\n";
  const auto machine = parse_machine(text, "mill.toml", {});
  REQUIRE_FALSE(machine);
  CHECK(machine.error().size() == kMostErrors);
  const auto state = parse_state("schema = 1\n" + text, "mill.state");
  REQUIRE_FALSE(state);
  CHECK(state.error().size() == kMostErrors);
}

TEST_CASE("a file of many tools is read and written in a time that goes by its length",
          "[hal][machine]") {
  std::string text;
  for (int i = 1; i <= 20'000; ++i) text += "tool." + std::to_string(i) + ".radius_mm = 2\n";
  const auto machine = parse_machine(text, "mill.toml", {});
  REQUIRE(machine);
  CHECK(machine->tools.size() == 20'000);
  const auto again = parse_machine(machine_toml(*machine), "again.toml", {});
  REQUIRE(again);
  CHECK(machine_toml(*again) == machine_toml(*machine));
}

TEST_CASE("every number of a machine has a floor and a ceiling that its refusal names",
          "[hal][machine]") {
  int floors = 0;
  for (const MachineKey& key : machine_keys()) {
    const auto* number = std::get_if<NumberKey>(&key.value);
    if (!number) continue;
    const KeyRef ref{&key, is_tool_key(key) ? 1 : 0};
    CAPTURE(key.name, allowed_text(key));
    Machine machine;
    for (const double beyond : {1e300, -1e300}) {
      const auto refused = assign(ref, beyond, machine);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().message.find(allowed_text(key)) != std::string::npos);
    }
    const bool takes_least = assign(ref, 1e-300, machine).has_value();
    CHECK(takes_least == (number->range.low <= 0));
    if (!takes_least) ++floors;
  }
  CHECK(floors >= 30);
  // A rate of next to nothing makes motions without an end: no such key begins at 0.
  for (const char* key :
       {"axis.x.velocity_mm_min", "axis.y.acceleration_mm_s2", "axis.z.jerk_mm_s3",
        "limits.feed_mm_min", "limits.tangential_mm_s2", "limits.normal_mm_s2",
        "control.chord_tolerance_um", "control.corner_tolerance_um", "axis.x.drive.kv_1_s"}) {
    const std::vector<std::string> settings{std::string(key) + "=1e-300"};
    CAPTURE(key);
    const auto machine = parse_machine("", "mill.toml", settings);
    REQUIRE_FALSE(machine);
    CHECK(machine.error().front().code == Code::SC7005);
  }
}

}  // namespace softcnc::hal
