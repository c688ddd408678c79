// SPDX-License-Identifier: MIT
// Machines as files for persons, keys of other controls, and folders of subprograms.
#include <catch2/catch.hpp>
#include <filesystem>

#include "hal/machine/foreign_keys.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/machine/machine_keys.hpp"
#include "motion/model/subprogram_path.hpp"
#include "support/shown.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::Folder;
using test::kSource;
using test::loaded;
using test::Names;
using test::Settings;

std::string first_error(const std::string& text, const Settings& settings = {}) {
  const auto machine = parse_machine(text, "mill.toml", settings);
  REQUIRE_FALSE(machine);
  return render(machine.error().front());
}

Names machine_files() {
  Names files{""};  // the built-in machine
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kSource + "/programs"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
  return files;
}

}  // namespace

TEST_CASE("every machine reads back from its file for persons, which is then the same text",
          "[hal][machine]") {
  CHECK(machine_files().size() > 8);
  for (const std::string& file : machine_files())
    for (const bool explained : {false, true}) {
      CAPTURE(file, explained);
      const Machine machine = loaded(file);
      const std::string text = readable_machine_toml(machine, explained);
      const auto again = parse_machine(text, "again.toml", {});
      REQUIRE(again);
      CHECK(machine_toml(*again) == machine_toml(with_whole_paths(machine)));
      CHECK(readable_machine_toml(*again, explained) == text);
    }
}

TEST_CASE("a file for persons has the meaning of its keys if asked for", "[hal][machine]") {
  CHECK(readable_machine_toml({}, true).find("\n# largest speed of the axis\nvelocity_mm_min = "
                                             "15000\n") != std::string::npos);
  CHECK(readable_machine_toml({}, false).find("largest speed") == std::string::npos);
  CHECK(readable_machine_toml({}, false).starts_with("# A machine of softcnc."));
}

TEST_CASE("folders of subprograms count from the folder of the machine file", "[hal][machine]") {
  Folder folder;
  std::filesystem::create_directory(folder / "mills");
  folder.with("mills/a.toml", "program.path = [\"lib\", \"../more\", \"/whole\"]\n");
  const Machine machine = loaded(folder / "mills/a.toml");
  CHECK(machine.program.path == Settings{"lib", "../more", "/whole"});
  CHECK(subprogram_path(machine.program) ==
        Settings{folder / "mills/lib", folder / "mills/../more", "/whole"});
  CHECK(subprogram_path(loaded(folder / "mills/a.toml", {"program.path=[\"here\"]"}).program) ==
        Settings{"here"});
  CHECK(loaded(folder / "mills/a.toml", {"program.path=[]"}).program.path.empty());
  const Machine whole = with_whole_paths(machine);
  CHECK(whole.program.path == Settings{folder / "mills/lib", folder / "more", "/whole"});
  CHECK(with_whole_paths(whole).program.path == whole.program.path);
}

TEST_CASE("what is wrong with folders of subprograms is reported with its place",
          "[hal][machine]") {
  CHECK(
      begins_showing(first_error("program.path = \"lib\"\n"),
                     "mill.toml:1:16: error: program.path takes an array of strings, not a string "
                     "[SC7004]"));
  CHECK(begins_showing(first_error("program.path = [1]\n"),
                       "mill.toml:1:16: error: program.path "
                       "takes an array of strings, not an "
                       "array [SC7004]"));
  CHECK(begins_showing(first_error("program.path = [\"a\", \"\"]\n"),
                       "mill.toml:1:16: error: program.path names a folder by an empty string "
                       "[SC7030]"));
  CHECK(begins_showing(first_error("", {"program.path=lib"}),
                       "--set:1:14: error: program.path takes an array of strings, ... [SC7004]"));
}

TEST_CASE("a machine that was only found has folders of subprograms in its own folder alone",
          "[hal][machine]") {
  Folder folder;
  std::filesystem::create_directory(folder / "part");
  std::filesystem::create_directory(folder / "part/lib");
  std::filesystem::create_directory_symlink("/", folder / "part/link");
  folder.with("part/a.toml",
              "program.path = [\"lib\", \"../other\", \"gone\", \"/etc\", \"link\", \".\"]\n");
  const auto found = find_machine({folder / "part/a.toml", true}, {});
  REQUIRE(found);
  CHECK(found->machine.program.path == Settings{"lib", "gone", "."});
  REQUIRE(found->ignored.size() == 1);
  CHECK(
      shows(render(found->ignored.front()),
            "a.toml:1:16: warning: program.path: '../other' is ignored unless --machine names the "
            "file: it is not in the folder of the file [SC7021]"));
  const auto named = find_machine({folder / "part/a.toml", false}, {});
  REQUIRE(named);
  CHECK(named->machine.program.path.size() == 6);
  CHECK(named->ignored.empty());
  const auto set = find_machine({folder / "part/a.toml", true}, Settings{"program.path=[\"/\"]"});
  REQUIRE(set);
  CHECK(set->machine.program.path == Settings{"/"});
}

TEST_CASE("keys of other controls lead to those of softcnc, with their values", "[hal][machine]") {
  CHECK(first_error("# grbl\n[axis.x]\nsteps_per_mm = 80\n") ==
        "mill.toml:3:1: error: unknown key 'axis.x.steps_per_mm': 80 steps per mm are "
        "axis.x.blu_um = 12.5 [SC7001]\n"
        "    3 | steps_per_mm = 80\n"
        "      | ^~~~~~~~~~~~\n");
  CHECK(shows(first_error("", {"axis.y.steps_per_mm=400"}),
              "--set:1:1: error: unknown key 'axis.y.steps_per_mm': 400 steps per mm are "
              "axis.y.blu_um = 2.5 [SC7001]"));
  const auto counterpart = [](std::string_view path, const FileValue& value) {
    return counterpart_of(path, value);
  };
  CHECK(counterpart("steps_per_mm", 80.0) == "80 steps per mm are axis.*.blu_um = 12.5");
  CHECK(counterpart("axes.Z.Steps-per-mm", std::int64_t{400}) ==
        "400 steps per mm are axis.z.blu_um = 2.5");
  CHECK(counterpart("axis.x.steps/mm", 0.0) ==
        "here it is axis.x.blu_um, 1000 over the steps per mm");
  CHECK(counterpart("axis.x.step_scale", std::string("80")) ==
        "here it is axis.x.blu_um, 1000 over the steps per mm");
  CHECK(counterpart("axis.x.max_rate", 3000.0) == "3000 mm/min are axis.x.velocity_mm_min = 3000");
  CHECK(counterpart("axis.x.max_velocity", 50.0) == "50 mm/s are axis.x.velocity_mm_min = 3000");
  CHECK(counterpart("axis.x.max_acceleration", 500.0) ==
        "500 mm/s2 are axis.x.acceleration_mm_s2 = 500");
  CHECK(counterpart("axis.x.max_limit", 300.0) == "300 mm are axis.x.max_mm = 300");
  CHECK(counterpart("junction_deviation", 0.01) == "0.01 mm are control.corner_tolerance_um = 10");
  CHECK(
      counterpart("axis.y.pulley", 20.0) ==
      "here it is axis.y.blu_um, teeth of the pulley times pitch of the belt in um over the steps "
      "per turn (20 teeth of 2 mm at 3200 steps: 12.5)");
  CHECK(counterpart("axis.x.steps_per_rev", 200.0).starts_with("here it is axis.x.blu_um, "));
  CHECK(
      counterpart("axis.x.max_travel", 200.0) ==
      "here it is axis.x.min_mm and axis.x.max_mm, the ends of the travel in machine coordinates");
  CHECK(counterpart("axis.x.colour", 1.0).empty());
}

TEST_CASE("every key to which keys of other controls lead is one of softcnc", "[hal][machine]") {
  for (const char* foreign :
       {"steps_per_mm", "max_rate", "max_velocity", "max_acceleration", "min_limit", "max_limit",
        "junction_deviation", "arc_tolerance", "max_spindle_speed", "min_spindle_speed"}) {
    CAPTURE(foreign);
    const std::string text = counterpart_of("axis.x." + std::string(foreign), 10.0);
    const auto begin = text.find(" are ") + 5, end = text.find(" = ");
    REQUIRE(end != text.npos);
    CHECK(find_key(text.substr(begin, end - begin)));
  }
}

}  // namespace softcnc::hal
