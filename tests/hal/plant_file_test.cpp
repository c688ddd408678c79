// SPDX-License-Identifier: MIT
// The plant of a machine file: where it is read from, what is wrong with it, and the way back to
// text; and the keys of screws.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

#include "hal/machine/machine_file.hpp"
#include "hal/support_hal.hpp"
#include "support/shown.hpp"

namespace softcnc::hal {
namespace {

using softcnc::shows;
using test::all_of;
using test::Folder;
using test::loaded;
using test::Settings;

std::string refused_file(const std::string& file, const Settings& settings = {}) {
  const auto machine = load_machine(file, settings);
  REQUIRE_FALSE(machine);
  return all_of(machine.error());
}

std::string refused_text(const std::string& text) {
  const auto machine = parse_machine(text, "mill.toml", {});
  REQUIRE_FALSE(machine);
  return all_of(machine.error());
}

/// A folder with a machine of two axes and a plant for it.
struct Shop {
  Shop() {
    test::write(mill, "[backend.sim]\nplant = \"worn.toml\"\n[axis.x]\n[axis.y]\n");
    test::write(worn,
                "[axis.x]\nbacklash_um = 100\npitch_table = [[0, 0], [100, -12.5]]\n"
                "[axis.x.motor]\ninertia_kg_m2 = 7e-4\n[axis.y]\ndrive.kv_1_s = 29\n");
  }
  Folder folder;
  std::string mill = folder / "mill.toml", worn = folder / "worn.toml";
};

}  // namespace

TEST_CASE("keys of screws reach their places", "[hal][machine][screw]") {
  const auto machine = parse_machine(
      "axis.x.backlash_um = 40\naxis.x.pitch_table = [[-5, 1], [5.5, -0.25]]\n", "mill.toml", {});
  REQUIRE(machine);
  CHECK(machine->screws[0].backlash == 0.04);
  REQUIRE(machine->screws[0].pitch_table.size() == 2);
  CHECK(machine->screws[0].pitch_table[1].position == 5.5);
  CHECK(machine->screws[0].pitch_table[1].error == -0.25e-3);
  CHECK_FALSE(machine->plant.given);
  CHECK(machine_toml(*machine).find("\npitch_table = [[-5, 1], [5.5, -0.25]]\n") !=
        std::string::npos);
  CHECK(machine_toml(Machine{}).find("\nbacklash_um = 0\npitch_table = []\n") != std::string::npos);
}

TEST_CASE("pitch tables that no screw has are refused at their place", "[hal][machine][screw]") {
  CHECK(shows(refused_text("axis.x.pitch_table = [[0, 0], [0, 1]]"),
              "mill.toml:1:22: error: axis.x.pitch_table does not ascend at 0 mm [SC7052]"));
  CHECK(shows(refused_text("axis.x.pitch_table = [[0, 0], [0.1, 11]]"),
              "mill.toml:1:22: error: axis.x.pitch_table changes by more than 100 um in a mm at "
              "0.1 mm [SC7052]"));
  std::string many = "axis.x.pitch_table = [";
  for (int i = 0; i <= 100; ++i) many += (i > 0 ? ", [" : "[") + std::to_string(i) + ", 0]";
  CHECK(shows(refused_text(many + "]"),
              "mill.toml:1:22: error: axis.x.pitch_table has 101 pairs, more than 100 [SC7052]"));
  CHECK(shows(refused_text("axis.x.pitch_table = [[0, 0, 1]]"),
              "mill.toml:1:22: error: axis.x.pitch_table takes an array of pairs of numbers, not "
              "an array of arrays [SC7004]"));
  CHECK(shows(refused_text("axis.x.pitch_table = [0, 0]"), "not an array [SC7004]"));
  CHECK(
      shows(refused_text("axis.x.pitch_table = [[0, 2e4]]"),
            "mill.toml:1:22: error: axis.x.pitch_table must be at least -10000 and at most 10000, "
            "not 20000 [SC7005]"));
  CHECK(shows(refused_text("axis.x.backlash_um = -1"),
              "mill.toml:1:22: error: axis.x.backlash_um must be at least 0 "));
}

TEST_CASE("methods by pulses do not compensate", "[hal][machine][screw]") {
  const std::string text = "control.interpolation = 'm-dsm'\naxis.y.backlash_um = 10\n";
  CHECK(shows(refused_text(text),
              "mill.toml:2:22: error: axis.y.backlash_um cannot be compensated by "
              "control.interpolation = m-dsm [SC7053]"));
  CHECK(
      parse_machine("control.interpolation = 'm-dsm'\naxis.y.backlash_um = 0\n", "mill.toml", {}));
}

TEST_CASE("the plant of a machine is read from its folder", "[hal][machine][plant]") {
  const Shop shop;
  const Machine machine = loaded(shop.mill);
  REQUIRE(machine.plant.given);
  CHECK(machine.plant.file == "worn.toml");
  CHECK(machine.plant.axes[0].motor.inertia == 7e-4);
  CHECK(machine.plant.axes[1].drive.kv == 29);
  CHECK_FALSE(machine.plant.axes[2].present);
  CHECK(machine.plant.screws[0].backlash == 0.1);
  CHECK(machine.plant.screws[0].pitch_table[1].error == -0.0125);
  CHECK(machine.screws[0].backlash == 0);  // softcnc plans and commands with its own
  CHECK(machine.axes[0].motor.inertia == 6.1e-4);
}

TEST_CASE("settings choose a plant, change it, and remove it", "[hal][machine][plant]") {
  const Shop shop;
  CHECK_FALSE(loaded(shop.mill, {"backend.sim.plant="}).plant.given);
  CHECK(loaded(shop.mill, {"plant.axis.x.motor.inertia_kg_m2=8e-4"}).plant.axes[0].motor.inertia ==
        8e-4);
  test::write(shop.worn, "spindle.max_rpm = 1\n");  // it names no axis, so it has all of them
  CHECK(loaded("", {"backend.sim.plant=" + shop.worn, "plant.axis.z.backlash_um=3"})
            .plant.screws[2]
            .backlash == 0.003);
  CHECK(loaded("", {"backend.sim.plant=" + shop.worn}).plant.given);
  CHECK(shows(refused_file("", {"plant.axis.x.blu_um=1"}),
              "--set:1:1: error: the plant has no axis x [SC7007]"));
}

TEST_CASE("a machine with its plant reads back from its text", "[hal][machine][plant]") {
  const Shop shop;
  const std::string text = machine_toml(loaded(shop.mill));
  CHECK(text.find("\n[plant.axis.x.motor]\n") != std::string::npos);
  const auto again = parse_machine(text, "elsewhere.toml", {});
  INFO((again ? std::string() : all_of(again.error())));
  REQUIRE(again);
  CHECK(again->plant.given);
  CHECK(again->plant.axes[0].motor.inertia == 7e-4);
  CHECK_FALSE(again->plant.axes[2].present);
  CHECK(machine_toml(*again) == text);
}

TEST_CASE("values of the plant are shown with their origin", "[hal][machine][plant]") {
  const Shop shop;
  const auto values = effective_values(shop.mill, {});
  REQUIRE(values);
  const auto found = std::find_if(values->begin(), values->end(), [](const EffectiveValue& value) {
    return value.key == "plant.axis.x.backlash_um";
  });
  REQUIRE(found != values->end());
  CHECK(found->value == "100");
  CHECK(found->origin == shop.worn + ":2");
}

TEST_CASE("what is wrong with a plant has its place in its own file", "[hal][machine][plant]") {
  const Shop shop;
  SECTION("a key") {
    test::write(shop.worn, "[axis.x]\nbaclash_um = 1\n[axis.y]\n");
    CHECK(
        shows(refused_file(shop.mill), shop.worn + ":2:1: error: unknown key 'axis.x.baclash_um'"));
  }
  SECTION("an axis that is missing") {
    test::write(shop.worn, "[axis.x]\n");
    CHECK(shows(refused_file(shop.mill),
                shop.mill + ":2:9: error: the plant has no axis y [SC7051]"));
  }
  SECTION("another BLU") {
    test::write(shop.worn, "[axis.x]\n[axis.y]\nblu_um = 1\n");
    CHECK(shows(refused_file(shop.mill), shop.worn + ":3:10: error: plant.axis.y.blu_um = 1 is not "
                                                     "axis.y.blu_um = 2.5 [SC7051]"));
  }
  SECTION("a plant of its own") {
    test::write(shop.worn, "backend.sim.plant = \"third.toml\"\n[axis.x]\n[axis.y]\n");
    CHECK(shows(refused_file(shop.mill),
                shop.worn + ":1:21: error: backend.sim.plant = 'third.toml' in a plant [SC7054]"));
  }
  SECTION("that there is none") {
    std::filesystem::remove(shop.worn);
    CHECK(shows(refused_file(shop.mill), shop.worn + ": error: cannot be read: "));
  }
  SECTION("after what is wrong with the machine") {
    test::write(shop.worn, "[axis.x]\nblu_um = 0\n");
    test::write(shop.mill,
                "[axis.x]\n[axis.y]\n[backend.sim]\nplant = \"worn.toml\"\n"
                "[spindle]\nmin_rpm = -1\n");
    const std::string all = refused_file(shop.mill);
    CHECK(all.starts_with(shop.mill + ":6:11: "));
    CHECK(shows(all, shop.worn + ":2:10: error: "));
  }
}

TEST_CASE("a machine in memory has its plant in it", "[hal][machine][plant]") {
  CHECK(shows(refused_text("backend.sim.plant = \"worn.toml\""),
              "mill.toml:1:21: error: 'worn.toml' is not read for a machine that is no file: "
              "[plant.axis.*] must stand in it [SC7003]"));
}

TEST_CASE("a machine beside a program has its plant in the same folder", "[hal][machine][plant]") {
  const Shop shop;
  const auto near = find_machine({shop.mill, true}, {});
  REQUIRE(near);
  CHECK(near->machine.plant.given);
  CHECK(near->ignored.empty());
  test::write(shop.mill, "[backend.sim]\nplant = \"../" +
                             std::filesystem::path(shop.worn).filename().string() +
                             "\"\n[axis.x]\n[axis.y]\n");
  const auto far = find_machine({shop.mill, true}, {});
  REQUIRE(far);
  CHECK_FALSE(far->machine.plant.given);
  REQUIRE(far->ignored.size() == 1);
  CHECK(shows(render(far->ignored[0]),
              shop.mill + ":2:9: warning: backend.sim.plant is ignored unless --machine names the "
                          "file: it is no file in the same folder [SC7021]"));
}

}  // namespace softcnc::hal
