// SPDX-License-Identifier: MIT
// Files that a run leaves: the summary names each, and none that nobody has named is written over.
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;

namespace {

constexpr const char* kOneMove = "G21 G90\nG1 X1 F600\nM2\n";

/// Runs a command in a folder with p.nc.
Ended run_beside_part(const Folder& folder, const std::string& command) {
  write(folder / "p.nc", kOneMove);
  return shell("cd " + (folder / "") + "; " + command);
}

}  // namespace

TEST_CASE("the summary names each file that a run has written", "[apps][written]") {
  const Folder folder;
  write(folder / "p.nc", "G10 L2 P1 X1\nG1 X1 F600\nM2\n");
  const Ended ended = shell("cd " + (folder / "") +
                            "; $softcnc run p.nc --trace t.csv --report r.json --state s.toml "
                            "--backend stepdir --set backend.stepdir.file=e.edges");
  CHECK(ended.status == 0);
  for (const std::string line : {"trace written to t.csv", "report written to r.json",
                                 "edges written to e.edges", "state written to s.toml"})
    CHECK(shows(ended.err, "\n  " + line + "\n"));
  const auto written = nlohmann::json::parse(read(folder / "r.json"))["written"];
  CHECK(written.size() == 3);
  CHECK(written[0] == nlohmann::json{{"what", "edges"}, {"file", "e.edges"}});
  CHECK(folder.files() == std::vector<std::string>{"e.edges", "p.nc", "r.json", "s.toml", "t.csv"});

  const Ended again = shell("cd " + (folder / "") + "; $softcnc run p.nc --state s.toml");
  CHECK(again.status == 0);
  CHECK_FALSE(shows(again.err, "written to"));  // the state is what it was
}

TEST_CASE("record and surface name what they have written", "[apps][written]") {
  const Folder folder;
  const Ended recorded = run_beside_part(folder, "$softcnc record p.nc -o p.rec --report r.json");
  CHECK(recorded.status == 0);
  CHECK(shows(recorded.err, "\n  recording written to p.rec\n"));
  CHECK(shows(recorded.err, "\n  report written to r.json\n"));
  CHECK_FALSE(shows(recorded.err, "trace written"));  // it is in the recording
  write(folder / "cut.nc", "T1 M6\nS3000 M3\nG1 Z-0.5 F600\nG1 X2\nM2\n");
  const Ended cut = shell("cd " + (folder / "") +
                          "; $softcnc surface cut.nc --set tool.1.radius_mm=1 --set tool.1.teeth=2 "
                          "--set stock.grid_um=50 -o c.png --report c.json");
  CAPTURE(cut.err);
  CHECK(cut.status == 0);
  CHECK(shows(cut.err, "\n  surface written to c.png\n"));
  CHECK(shows(cut.err, "report written to c.json\n"));
}

TEST_CASE("nothing is named that is not there", "[apps][written]") {
  const Folder folder;
  CHECK_FALSE(shows(run_beside_part(folder, "$softcnc run p.nc").err, "written to"));
  CHECK_FALSE(shows(run_beside_part(folder, "$softcnc run p.nc --dry-run").err, "written to"));
  CHECK_FALSE(shows(run_beside_part(folder, "$softcnc run p.nc --trace /dev/full").err,
                    "trace written to"));
  CHECK_FALSE(shows(run_beside_part(folder, "$softcnc run p.nc --report /dev/full").err,
                    "report written to"));
}

TEST_CASE("a default name is used where nothing has it, and is named", "[apps][written]") {
  const auto [backend, file, what] = GENERATE(table<std::string, std::string, std::string>(
      {{"stepdir", "steps.vcd", "edges"}, {"hal-stream", "setpoints.txt", "rows"}}));
  CAPTURE(backend);
  const Folder folder;
  const Ended first = run_beside_part(folder, "$softcnc run p.nc --backend " + backend);
  CHECK(first.status == 0);
  CHECK(shows(first.err, "\n  " + what + " written to " + file + "\n"));
  for (const std::string text : {"mine", ""}) {
    write(folder / file, text);
    for (const std::string command : {"run", "record -o p.rec"}) {
      const Ended second =
          run_beside_part(folder, "$softcnc " + command + " p.nc --backend " + backend);
      CAPTURE(second.err);
      CHECK(second.status == 5);
      CHECK(second.err.starts_with(file + ": error"));
      CHECK(shows(second.err, "SC6015"));
      CHECK(shows(second.err, "--set backend." + backend + ".file=FILE; the file " + file +
                                  " is left unchanged"));
      CHECK(read(folder / file) == text);
    }
  }
  CHECK(run_beside_part(folder, "$softcnc run -q --dry-run p.nc --backend " + backend).status == 0);
  CHECK(run_beside_part(folder, "$softcnc check p.nc").status == 0);
  const Ended named = run_beside_part(folder, "$softcnc run p.nc --backend " + backend +
                                                  " --set backend." + backend + ".file=" + file);
  CHECK(named.status == 0);
  CHECK(read(folder / file).size() > 100);
  if (backend == "stepdir")
    CHECK(run_beside_part(folder, "$softcnc run p.nc --backend stepdir").err ==
          "steps.vcd: error: exists already, and you have not named it: name a file with --set "
          "backend.stepdir.file=FILE; the file steps.vcd is left unchanged [SC6015]\n");
  // A link is in the way, too, wherever it leads.
  std::filesystem::remove(folder / file);
  std::filesystem::create_symlink("nowhere", folder / file);
  CHECK(run_beside_part(folder, "$softcnc run -q p.nc --backend " + backend).status == 5);
  CHECK_FALSE(std::filesystem::exists(folder / "nowhere"));
}

TEST_CASE("rows for a FIFO that is not there are noted, and named", "[apps][written]") {
  const Folder folder;
  const std::string run = "$softcnc run p.nc --machine $programs/hal/mill.toml";
  const Ended ended = run_beside_part(folder, run);
  CHECK(ended.status == 0);
  CHECK(ended.err.starts_with(
      "rows: note: does not exist: the rows go to a new file, and no program reads them "
      "[SC6076]\n"));
  CHECK(shows(ended.err, "\n  rows written to rows\n"));
  CHECK_FALSE(shows(run_beside_part(folder, run).err, "SC6076"));  // now it is there
  std::filesystem::remove(folder / "rows");
  CHECK_FALSE(shows(run_beside_part(folder, run + " --dry-run -q").err, "SC6076"));
  const Ended read_along =
      run_beside_part(folder, "mkfifo rows; cat rows >read & sleep 0.3; " + run + "; wait");
  CHECK(read_along.status == 0);
  CHECK_FALSE(shows(read_along.err, "SC6076"));
  CHECK(shows(read_along.err, "\n  rows written to rows\n"));
}
