// SPDX-License-Identifier: MIT
// softcnc circle, on the simulated mill with and without errors of its screws; plants and
// compensation from outside.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

const std::string kBallBarProgram = "$programs/27_ball_bar.nc";

/// A machine file with an entry for its first axis.
std::string machine(const Folder& folder, const std::string& name, const std::string& axis) {
  write(folder / name, "limits.feed_mm_min = 15000\n[axis.x]\n" + axis + "[axis.y]\n");
  return folder / name;
}

/// The circles of the program on a machine.
json circles(const Folder& folder, const std::string& options) {
  const std::string trace = folder / "trace.csv.zst";
  const Ended run = call("run -q " + kBallBarProgram + " --trace " + trace + " " + options);
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const Ended ended = call("circle --format json " + trace);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  json document = json::parse(ended.out);
  REQUIRE(document["circles"].size() == 1);
  REQUIRE(document["circles"][0]["passes"].size() == 2);
  return document["circles"][0];
}

json reversal(const json& pass, const std::string& side) {
  for (const json& one : pass["reversals"])
    if (one["side"] == side) return one;
  FAIL("no reversal at " << side);
  return {};
}

}  // namespace

TEST_CASE("a circle of the simulated mill is smaller by its lag", "[apps][circle]") {
  const Folder folder;
  const json circle = circles(folder, "");
  CHECK(circle["radius_mm"].get<double>() == Approx(50).margin(1e-6));
  CHECK(circle["passes"][0]["direction"] == "anticlockwise");
  CHECK(circle["passes"][0]["line"] == 10);
  CHECK(circle["passes"][1]["direction"] == "clockwise");
  CHECK(circle["passes"][0]["feed_mm_min"].get<double>() == Approx(1000).epsilon(1e-3));
  const double v = 1000.0 / 60, kv = 30;
  CHECK(circle["both_directions"]["d_um"].get<double>() ==
        Approx(-1e3 * v * v / (2 * 50 * kv * kv)).margin(1));
  CHECK(std::abs(circle["both_directions"]["lag_difference_ms"].get<double>()) < 0.05);
}

TEST_CASE("backlash of the plant is a step of its height, and compensated it is gone",
          "[apps][circle]") {
  const Folder folder;
  const std::string plain = machine(folder, "plain.toml", ""),
                    worn = machine(folder, "worn.toml", "backlash_um = 100\n");
  const json steps = circles(folder, "--machine " + plain + " --set backend.sim.plant=" + worn);
  for (const json& pass : steps["passes"]) {
    for (const char* side : {"+X", "-X"})
      CHECK(reversal(pass, side)["step_um"].get<double>() == Approx(100).epsilon(0.05));
    for (const char* side : {"+Y", "-Y"})
      CHECK(std::abs(reversal(pass, side)["step_um"].get<double>()) < 5);
  }
  const json gone = circles(folder, "--machine " + worn);
  for (const json& pass : gone["passes"])
    for (const json& one : pass["reversals"]) {
      CHECK(std::abs(one["step_um"].get<double>()) < 5);
      CHECK(std::abs(one["spike_um"].get<double>()) < 15);
    }
}

TEST_CASE("a recording contains its plant", "[apps][circle]") {
  const Folder folder;
  const std::string plain = machine(folder, "plain.toml", "");
  machine(folder, "worn.toml", "backlash_um = 100\n");
  const std::string recording = folder / "worn.rec";
  CHECK(call("record -q " + kBallBarProgram + " --machine " + plain +
             " --set backend.sim.plant=" + (folder / "worn.toml") + " -o " + recording)
            .status == 0);
  std::filesystem::remove(folder / "worn.toml");
  const Ended replayed = call("replay " + recording);
  CAPTURE(replayed.err);
  CHECK(replayed.status == 0);
  const Ended shown = call("circle " + recording);
  CHECK(shown.status == 0);
  CHECK(shows(shown.out, "circle in XY: radius 50.0000 mm about 0.0000 0.0000 mm\n"));
  CHECK(shows(shown.out, "  both directions: G(b) "));
}

TEST_CASE("the machine shows its plant", "[apps][circle]") {
  const Folder folder;
  const std::string worn = machine(folder, "worn.toml", "backlash_um = 100\n");
  write(folder / "mill.toml", "backend.sim.plant = \"worn.toml\"\n[axis.x]\n[axis.y]\n");
  const Ended shown = call("machine --machine " + (folder / "mill.toml"));
  CHECK(shown.status == 0);
  CHECK(shows(shown.out, "plant.axis.x.backlash_um"));
  CHECK(shows(shown.out, worn + ":3"));
}

TEST_CASE("a trace has the positions sent where they are not those of the path", "[apps][circle]") {
  const Folder folder;
  const std::string worn = machine(folder, "worn.toml", "backlash_um = 100\n");
  const Ended ended = call("run -q " + kBallBarProgram + " --trace - --machine " + worn);
  REQUIRE(ended.status == 0);
  const Trace trace = parse_trace(ended.out);
  double least = 0, most = 0;
  for (std::size_t row = 0; row < trace.rows.size(); ++row) {
    const double added = trace.number(row, "x_cmd_mm") - trace.number(row, "x_mm");
    least = std::min(least, added);
    most = std::max(most, added);
    REQUIRE(trace.number(row, "y_cmd_mm") == trace.number(row, "y_mm"));
  }
  CHECK(least == Approx(-0.1).margin(1e-9));
  CHECK(most == Approx(0).margin(1e-9));
}

TEST_CASE("pictures of circles are drawn", "[apps][circle]") {
  const Folder folder;
  circles(folder, "");
  const std::string trace = folder / "trace.csv.zst";
  for (const char* name : {"circle.svg", "circle.png"}) {
    const Ended ended = call("circle -q " + trace + " -o " + (folder / name));
    CAPTURE(ended.err);
    CHECK(ended.status == 0);
    CHECK(std::filesystem::file_size(folder / name) > 10'000);
  }
  CHECK(read(folder / "circle.svg").starts_with("<?xml"));
  CHECK(shows(call("circle " + trace + " -o " + (folder / "circle.pdf")).err,
              "no form of a picture has this suffix; known are .svg, .png [SC6060]"));
}

TEST_CASE("circles of other planes are found there", "[apps][circle]") {
  const Folder folder;
  const std::string trace = folder / "zx.csv";
  write(folder / "zx.nc",
        "G18 F2000\nG00 X30\nG02 X30 Z0 I-30 K0\nG02 X30 Z0 I-30 K0\nG03 X30 Z0 I-30 K0\n"
        "G03 X30 Z0 I-30 K0\nM30\n");
  REQUIRE(call("run -q " + (folder / "zx.nc") + " --trace " + trace).status == 0);
  CHECK(call("circle " + trace).status == 5);
  const Ended found = call("circle --plane ZX " + trace);
  CHECK(found.status == 0);
  CHECK(shows(found.out, "circle in ZX: radius 30.0000 mm about 0.0000 0.0000 mm\n  clockwise"));
  const Ended off = call("circle --plane ZX --format json --center 0,1 " + trace);
  REQUIRE(off.status == 0);
  const json pass = json::parse(off.out)["circles"][0]["passes"][0];
  CHECK(pass["f_max_um"].get<double>() - pass["f_min_um"].get<double>() ==
        Approx(2000).epsilon(0.02));
  CHECK(pass["g_um"].get<double>() < 20);
}

TEST_CASE("what has no circles is refused", "[apps][circle]") {
  const Folder folder;
  const std::string trace = folder / "line.csv";
  REQUIRE(call("run -q $programs/01_line.nc --trace " + trace).status == 0);
  const Ended none = call("circle " + trace);
  CHECK(none.status == 5);
  CHECK(shows(none.err, trace + ": error: no full circle in the plane XY [SC6084]"));
  REQUIRE(call("run -q --dry-run " + kBallBarProgram + " --trace " + trace).status == 0);
  CHECK(shows(call("circle " + trace).err,
              trace + ": error: the trace has no column 'x_act_mm' [SC6085]"));
  CHECK(call("circle " + trace + " --center 1").status == 2);
  CHECK(call("circle " + trace + " --plane XZ").status == 2);
}
