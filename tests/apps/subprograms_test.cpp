// SPDX-License-Identifier: MIT
// Files of subprograms in other folders, and variables from outside, with every command.
#include <catch2/catch.hpp>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "apps/talk.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

/// A program that calls o<hole> with the X #<_td>, and a folder with that subprogram.
void put_program(const Folder& folder) {
  std::filesystem::create_directory(folder / "lib");
  write(folder / "p.ngc", "G21 F600\no<hole> call [#<_td>]\nM2\n");
  write(folder / "lib/hole.ngc", "o<hole> sub\nG1 X#1\no<hole> endsub\n");
}

std::string go_to(const Folder& folder) { return "cd " + folder / "" + "; "; }

}  // namespace

TEST_CASE("every command finds subprograms in other folders", "[apps][subprograms]") {
  const Folder folder;
  put_program(folder);
  const std::string how = " p.ngc --subprograms lib --define _td=3";
  const Ended blocks = shell(go_to(folder) + "$softcnc blocks" + how);
  CHECK(blocks.status == 0);
  CHECK(shows(blocks.out, "{\"line\":2,\"file\":\"lib/hole.ngc\",...\"to\":[3,0,0]"));
  for (const char* command : {"check", "run -q", "run -q --dry-run", "report -q -o p.html",
                              "record -q -o p.rec", "surface -q --set stock.grid_um=1000 -o p.npz",
                              "compare -q --phases 1 --methods taylor1"}) {
    CAPTURE(command);
    const Ended ended = shell(go_to(folder) + "$softcnc " + command + how);
    CAPTURE(ended.out, ended.err);
    CHECK(!shows(ended.out + ended.err, "[SC2301]"));
    CHECK(!shows(ended.out + ended.err, "[SC1024]"));
    if (!std::string(command).starts_with("surface")) CHECK(ended.status == 0);
  }
  CHECK(shell(go_to(folder) + "$softcnc diff" + how + " p.ngc").status == 0);
  CHECK(shows(read(folder / "p.html"), "\"name\":\"lib/hole.ngc\""));
  REQUIRE(shell(go_to(folder) + "$softcnc run -q --report r.json" + how).status == 0);
  CHECK(json::parse(read(folder / "r.json"))["called_files"] == json::array({"lib/hole.ngc"}));
  CHECK(shows(shell(go_to(folder) + "$softcnc check p.ngc --define _td=3").out,
              "p.ngc:2:1: error: no subprogram o<hole> in this program or beside it [SC2301]"));
}

TEST_CASE("the machine names folders of subprograms", "[apps][subprograms]") {
  const Folder folder;
  put_program(folder);
  std::filesystem::create_directory(folder / "mills");
  write(folder / "mills/m.toml", "[program]\npath = [\"../lib\"]\n");
  CHECK(
      shell(go_to(folder) + "$softcnc check p.ngc --define _td=3 --machine mills/m.toml").status ==
      0);
  CHECK(shell(go_to(folder) + "$softcnc check p.ngc --define _td=3 --set 'program.path=[\"lib\"]'")
            .status == 0);
  write(folder / "p.toml", "[program]\npath = [\"lib\"]\n");
  CHECK(shell(go_to(folder) + "$softcnc check p.ngc --define _td=3").status == 0);
  write(folder / "p.toml", "[program]\npath = [\"" + folder / "" + "../\", \"lib\"]\n");
  const Ended found = shell(go_to(folder) + "$softcnc check p.ngc --define _td=3");
  CHECK(found.status == 0);
  CHECK(shows(found.out, "p.toml:2:8: warning: program.path: ... [SC7021]"));
}

TEST_CASE("a recording contains the files of other folders", "[apps][subprograms]") {
  const Folder folder;
  put_program(folder);
  std::filesystem::create_directory(folder / "empty");
  REQUIRE(shell(go_to(folder) + "$softcnc record -q p.ngc --subprograms empty --subprograms lib "
                                "--define _td=3 --define 100=2.5 -o p.rec")
              .status == 0);
  const json meta = json::parse(shell(go_to(folder) + "unzip -p p.rec meta.json").out);
  REQUIRE(meta["called"].size() == 1);
  CHECK(meta["called"][0]["name"] == "2/hole.ngc");
  CHECK(meta["options"]["define"] == json::array({"_td=3", "100=2.5"}));
  std::filesystem::remove_all(folder / "lib");
  std::filesystem::remove(folder / "p.ngc");
  const Ended replayed = shell(go_to(folder) + "$softcnc replay p.rec");
  CAPTURE(replayed.err);
  CHECK(replayed.status == 0);
  CHECK(shell(go_to(folder) + "$softcnc replay --bless p.rec; $softcnc replay -q p.rec").status ==
        0);
}

TEST_CASE("files of other folders are watched, also where they are not yet",
          "[apps][subprograms]") {
  const Folder folder;
  put_program(folder);
  std::filesystem::remove(folder / "lib/hole.ngc");
  Talk talk(
      {"check", "--watch", folder / "p.ngc", "--define", "_td=3", "--subprograms", folder / "lib"});
  CHECK(shows(talk.hear("---").front(),
              "error: no subprogram o<hole> in this program, beside it or "
              "in ... [SC2301]"));
  write(folder / "lib/hole.ngc", "o<hole> sub\nG1 X#1\no<hole> endsub\n");
  CHECK(talk.hear("---").size() == 1);
  write(folder / "lib/hole.ngc", "o<hole> sub\nG1 X1.0.0\no<hole> endsub\n");
  CHECK(shows(talk.hear("---").front(), "lib/hole.ngc:2:5: error: ... [SC1004]"));
  talk.send(SIGINT);
  CHECK(talk.status() == 130);
}

TEST_CASE("wrong folders and definitions are wrong usage", "[apps][subprograms]") {
  const Folder folder;
  put_program(folder);
  const auto refused = [&](const std::string& options) {
    const Ended ended = shell(go_to(folder) + "$softcnc check p.ngc " + options);
    CHECK(ended.status == 2);
    return ended.err;
  };
  CHECK(shows(refused("--subprograms gone"), "--subprograms: ...gone"));
  CHECK(shows(refused("--define td=3"), "--define: takes NAME=VALUE, ... not 'td=3'"));
  CHECK(shows(refused("--define _td"), "not '_td'"));
  const Ended of_system = shell(go_to(folder) +
                                "$softcnc check p.ngc --subprograms lib --define _x=3 "
                                "--define _td=1");
  CHECK(of_system.status == 1);
  CHECK(shows(of_system.out, "--define: error: #<_x> cannot be defined: ... [SC2318]"));
}

TEST_CASE("named globals of the state are read, and written back", "[apps][subprograms]") {
  const Folder folder;
  put_program(folder);
  write(folder / "p.ngc", "G21\nG0 X#<_td>\n#<_td>=[#<_td> + 1]\n#<_other>=1\nM2\n");
  write(folder / "s.toml", "schema = 1\n[parameter]\n_td = 3\n");
  CHECK(shell(go_to(folder) + "$softcnc check p.ngc --state s.toml").status == 0);
  CHECK(read(folder / "s.toml") == "schema = 1\n[parameter]\n_td = 3\n");
  REQUIRE(shell(go_to(folder) + "$softcnc run -q p.ngc --state s.toml").status == 0);
  CHECK(read(folder / "s.toml").ends_with("\n[parameter]\n_td = 4\n"));
  REQUIRE(shell(go_to(folder) + "$softcnc run -q p.ngc --state s.toml --define _td=10").status ==
          0);
  CHECK(read(folder / "s.toml").ends_with("\n[parameter]\n_td = 11\n"));
}

TEST_CASE("a program may call more files than a process usually opens", "[apps][subprograms]") {
  const Folder folder;
  std::string program;
  for (int i = 0; i < 100; ++i) {
    const std::string name = "s" + std::to_string(i);
    program += "o<" + name + "> call\n";
    write(folder / (name + ".ngc"), "o<" + name + "> sub\nG0 X1\no<" + name + "> endsub\n");
  }
  write(folder / "main.nc", program + "M2\n");
  const Ended ended = shell("ulimit -Sn 64; $softcnc check " + (folder / "main.nc"));
  CHECK(ended.status == 0);
  CHECK(ended.out.empty());
}
