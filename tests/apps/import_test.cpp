// SPDX-License-Identifier: MIT
// machine: machine files of machines, and of the settings of other controls.
#include <catch2/catch.hpp>
#include <filesystem>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

TEST_CASE("what machine prints is a machine file of the same machine", "[apps][machine]") {
  for (const char* how : {"", "--toml", "--toml -v"})
    for (const char* machine :
         {"builtin", "$programs/machines/bench_mill.toml", "$programs/machines/parport_router.toml",
          "$programs/21_paper004_surface.toml"}) {
      CAPTURE(how, machine);
      const Folder folder;
      const std::string file = folder / "m.toml", again = folder / "again.toml";
      const std::string print = std::string("$softcnc machine ") + how;
      REQUIRE(shell(print + " --machine " + machine + " > " + file).status == 0);
      REQUIRE(shell(print + " --machine " + file + " > " + again).status == 0);
      const std::string toml = "$softcnc machine --toml --machine ";
      CHECK(shell(toml + machine).out == shell(toml + file).out);
      if (*how != '\0') CHECK(read(file) == read(again));
    }
}

TEST_CASE("a machine file is written where -o says, with settings on top", "[apps][machine]") {
  const Folder folder;
  std::filesystem::create_directory(folder / "mills");
  REQUIRE(shell("cd " + folder / "" +
                "; $softcnc machine --toml -o mills/m.toml --set "
                "axis.x.blu_um=5 --set 'program.path=[\"lib\"]'")
              .status == 0);
  const std::string text = read(folder / "mills/m.toml");
  CHECK(shows(text, "blu_um = 5\n"));
  CHECK(shows(text, "path = [\"" + folder / "lib" + "\"]"));
}

TEST_CASE("settings of other controls become machines on which programs run", "[apps][import]") {
  for (const char* settings : {"mill.ini", "router.txt", "fluidnc.yaml", "mill.tbl"}) {
    CAPTURE(settings);
    const Folder folder;
    const std::string mill = folder / "m.toml";
    const std::string import =
        "cd " + folder / "" + "; $softcnc machine import $programs/settings/" + settings;
    const Ended made = shell(import + " -o m.toml");
    CAPTURE(made.err);
    CHECK(made.status == 0);
    CHECK(made.out.empty());
    CHECK(shell(import).out == read(mill));
    const Ended checked = shell("$softcnc check $programs/01_line.nc --machine " + mill);
    CAPTURE(checked.out);
    CHECK(checked.status == 0);
    CHECK(shell("$softcnc run -q $programs/01_line.nc --machine " + mill).status == 0);
    CHECK(shell("$softcnc machine --machine " + mill).status == 0);
  }
}

TEST_CASE("lengths and offsets of settings go into a new state file", "[apps][import]") {
  const Folder folder;
  const std::string import =
      "$softcnc machine import $programs/settings/mill.ini -o " + (folder / "m.toml");
  CHECK(shows(shell(import).err,
              "mill.ini: note: tool lengths and offsets belong in a state file: "
              "--state FILE.toml writes one [SC7031]"));
  const Ended made = shell(import + " --state " + (folder / "s.toml"));
  CHECK(made.status == 0);
  CHECK(!shows(made.err, "belong in a state file"));
  const std::string state = read(folder / "s.toml");
  CHECK(shows(state, "[work.\"G54\"]\nx_mm = -38.1\ny_mm = 12.7\n"));
  CHECK(shows(state, "[tool.1]\nx_mm = 0\ny_mm = 0\nz_mm = 38.1\n"));
  write(folder / "p.ngc", "G21\nT1 M6\nG43\nG0 X0 Z0\nM2\n");
  CHECK(shows(shell("$softcnc blocks " + (folder / "p.ngc") + " --machine " + (folder / "m.toml") +
                    " --state " + (folder / "s.toml"))
                  .out,
              "\"to\":[-38.1,0,38.1]"));
  const Ended again = shell(import + " --state " + (folder / "s.toml"));
  CHECK(again.status == 2);
  CHECK(shows(again.err, "s.toml: error: exists already, and is not overwritten [SC7038]"));
  CHECK(read(folder / "s.toml") == state);
}

TEST_CASE("subroutine paths count from where the machine file is written", "[apps][import]") {
  const Folder folder;
  for (const char* name : {"config", "config/subs", "mills"})
    std::filesystem::create_directory(folder / name);
  write(folder / "config/a.ini", "[RS274NGC]\nSUBROUTINE_PATH = subs\n");
  write(folder / "config/subs/hole.ngc", "o<hole> sub\nG0 X1\no<hole> endsub\n");
  write(folder / "p.ngc", "o<hole> call\nM2\n");
  const std::string in = "cd " + folder / "" + "; $softcnc ";
  REQUIRE(shell(in + "machine import config/a.ini -q -o mills/a.toml").status == 0);
  CHECK(shows(read(folder / "mills/a.toml"), "path = [\"../config/subs\"]"));
  CHECK(shell(in + "check p.ngc --machine mills/a.toml").status == 0);
  REQUIRE(shell(in + "machine import config/a.ini > a.toml").status == 0);
  CHECK(shell(in + "check p.ngc --machine a.toml").status == 0);
}

TEST_CASE("wrong settings leave no file, and wrong usage is refused", "[apps][import]") {
  const Folder folder;
  write(folder / "g.txt", "$100=80\n$110=fast\n");
  const Ended wrong = shell("cd " + folder / "" + "; $softcnc machine import g.txt -o m.toml");
  CHECK(wrong.status == 2);
  CHECK(begins_showing(wrong.err, "g.txt:2:6: error: $110 needs a number ... [SC7035]"));
  CHECK(folder.files() == std::vector<std::string>{"g.txt"});
  const auto refused = [&](const std::string& arguments) {
    const Ended ended = shell("cd " + folder / "" + "; $softcnc machine " + arguments);
    CHECK(ended.status == 2);
    return ended.err;
  };
  CHECK(shows(refused("export g.txt"), "'softcnc machine import FILE' reads settings"));
  CHECK(shows(refused("import g.txt --set axis.x.blu_um=1"), "import reads settings alone"));
  CHECK(shows(refused("--inch"), "--state, --inch and --allow-include belong to"));
  CHECK(shows(refused("-o m.toml"), "-o needs --toml or"));
  CHECK(shows(refused("import g.txt -o g.txt"), "name the same file"));
  CHECK(shows(refused("import gone.ini"), "gone.ini: error: cannot be read: ... [SC7033]"));
}

TEST_CASE("files outside the folder of the settings are read only where that is allowed",
          "[apps][import]") {
  const Folder folder;
  REQUIRE(shell("mkdir " + (folder / "a") + " " + (folder / "b")).status == 0);
  write(folder / "b/tool.tbl", "T1 P1 D6 Z20\nroot:x:0\n");
  write(folder / "secret", "root:x:0:0\n");
  REQUIRE(shell("ln -s ../secret " + (folder / "a/inside")).status == 0);
  write(folder / "a/m.ini",
        "[TRAJ]\nLINEAR_UNITS = mm\nnothing\n#INCLUDE inside\n[AXIS_X]\nMAX_VELOCITY = 1e99\n"
        "MAX_ACCELERATION = 7\n[EMCIO]\nTOOL_TABLE = ../b/tool.tbl\n");
  const auto import = [&](const std::string& options) {
    return shell("cd " + (folder / "a") + "; $softcnc machine import m.ini " + options);
  };
  const Ended confined = import("");
  CHECK(confined.status == 0);
  CHECK(shows(confined.err,
              "m.ini:3:1: warning: this is neither [SECTION] nor NAME = VALUE, and is passed over "
              "[SC7039]"));
  CHECK(shows(confined.err,
              "m.ini:4:1: warning: the file inside lies outside the folder... [SC7037]"));
  CHECK(
      shows(confined.err, "m.ini:9:14: warning: the file ../b/tool.tbl lies outside... [SC7037]"));
  CHECK_FALSE(shows(confined.out + confined.err, "root"));
  CHECK(shows(confined.out, "acceleration_mm_s2 = 7 "));
  CHECK(shows(confined.out, "MAX_VELOCITY = 1e99 (m.ini:6): no limit"));
  const Ended allowed = import("--allow-include " + (folder / "b"));
  CHECK(allowed.status == 2);
  CHECK(shows(allowed.err, "tool.tbl:2:1: error: ... [SC7034]"));
  CHECK_FALSE(shows(allowed.err, " | root"));
}

TEST_CASE("a tool table of 20,000 tools is read", "[apps][import]") {
  const Folder folder;
  std::string table;
  for (int tool = 1; tool <= 20'000; ++tool)
    table += "T" + std::to_string(tool) + " P1 D" + std::to_string(tool % 20 + 1) + "\n";
  write(folder / "big.tbl", table);
  const Ended ended = call("machine import " + (folder / "big.tbl"));
  CHECK(ended.status == 0);
  CHECK(shows(ended.out, "[tool.20000]\nradius_mm = 0.5 "));
}
