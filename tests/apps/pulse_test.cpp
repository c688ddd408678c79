// SPDX-License-Identifier: MIT
// Interpolation by reference pulses from outside: every command, every backend.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"
#include "hal/backends/stepdir.hpp"
#include "hal/signals/edge_reader.hpp"
#include "hal/signals/pulse_rules.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app::test;
using nlohmann::json;

namespace {

constexpr const char* kPulsedPart =
    "G21 G90 G17 F3000\n"
    "G01 X12.5 Y7.0125\n"
    "G03 X2.5 Y17.0125 I-10 J0\n"
    "G04 P0.02\n"
    "G18 G02 X2.5 Z-5 I0 K-2.5\n"
    "G00 X-1.0024 Y0 Z0\n"
    "M30\n";

}  // namespace

TEST_CASE("every method by pulses reaches the drives pulse by pulse", "[apps][pulse]") {
  const std::string method = GENERATE("sam", "m-sam", "dsm", "m-dsm", "dda");
  const std::string clock = GENERATE("profile", "paper");
  const std::string constant = GENERATE("on", "off");
  const Folder folder;
  write(folder / "p.nc", kPulsedPart);
  const Ended ended =
      call("run " + (folder / "p.nc") + " --set control.interpolation=" + method +
           " --set control.pulse_clock=" + clock + " --set control.constant_feed=" + constant +
           " --backend stepdir" + " --set backend.stepdir.file=" + (folder / "p.edges") +
           " --trace " + (folder / "t.csv") + " --report " + (folder / "r.json"));
  INFO(ended.err);
  REQUIRE(ended.status == 0);
  const json report = json::parse(read(folder / "r.json"));
  CHECK(report["counts"] == json{{"x", -401}, {"y", 0}, {"z", 0}});
  const Trace trace = parse_trace(read(folder / "t.csv"));
  CHECK(trace.number(trace.rows.size() - 1, "x_mm") == -1.0025);
  for (std::size_t row = 0; row < trace.rows.size(); ++row)
    for (const char* axis : {"x", "y", "z"})
      REQUIRE(trace.number(row, std::string(axis) + "_mm") ==
              Approx(trace.number(row, std::string(axis) + "_count") * 0.0025).margin(1e-12));
  const auto edges = hal::read_edges(read(folder / "p.edges"));
  REQUIRE(edges);
  hal::PulseRules rules(hal::step_timing(Machine{}.step_port));
  rules.read(*edges);
  CHECK(rules.broken().value_or("none") == "none");
  CHECK(rules.counts() == GridPoint{-401, 0, 0});
  CHECK(rules.steps() > 30000);
}

TEST_CASE("preview, mill and replay make the same pulses", "[apps][pulse]") {
  const std::string method = GENERATE("sam", "m-dsm", "dda");
  const Folder folder;
  write(folder / "p.nc", kPulsedPart);
  const std::string options = (folder / "p.nc") + " --set control.interpolation=" + method;
  const Trace preview = parse_trace(call("run --dry-run " + options).out);
  REQUIRE(call("record " + options + " -o " + (folder / "p.rec")).status == 0);
  CHECK(call("replay " + (folder / "p.rec")).status == 0);
  const Ended run = call("run " + options + " --trace " + (folder / "t.csv") + " --report " +
                         (folder / "r.json"));
  CHECK(run.status == 0);
  const Trace milled = parse_trace(read(folder / "t.csv"));
  REQUIRE(milled.rows.size() == preview.rows.size());
  for (std::size_t row = 0; row < milled.rows.size(); ++row)
    for (const char* column : {"s_mm", "v_mm_s", "limit", "x_mm", "y_mm", "z_mm"})
      REQUIRE(milled.word(row, column) == preview.word(row, column));
  const json report = json::parse(read(folder / "r.json"));
  CHECK(report["settled_counts"] == report["counts"]);
  CHECK(call("check " + options).out.find("SC4") == std::string::npos);
}

TEST_CASE("a move that the paper's clock cannot make is reported with its place", "[apps][pulse]") {
  const Folder folder;
  write(folder / "p.nc", "G90 F600\nG01 X5\n  G01 X6 Y7\nM30\n");
  const Ended ended = call("check " + (folder / "p.nc") +
                           " --set control.interpolation=sam --set control.pulse_clock=paper"
                           " --set axis.y.blu_um=5");
  CHECK(ended.status == 2);
  CHECK(ended.out.find("p.nc:3:3: error: one reference clock cannot serve a BLU of 2.5 um "
                       "of X and one of 5 um of Y [SC7080]\n") != std::string::npos);
}

TEST_CASE("a lost pulse stops the run with 4, whoever makes the pulses", "[apps][pulse]") {
  const std::string method = GENERATE("arc-length", "m-dsm");
  const Folder folder;
  write(folder / "p.nc", kPulsedPart);
  const std::string run = "run " + (folder / "p.nc") + " --set control.interpolation=" + method +
                          " --report " + (folder / "r.json") + " --set axis.y.drive.lost_pulse=";
  CHECK(call(run + "100000").status == 0);
  const Ended ended = call(run + "3000");
  CHECK(ended.status == 4);
  CHECK(shows(ended.err,
              "p.nc:3:1: error: lost pulses of Y: its counter has missed one on "
              "the way to ... [SC5020]"));
  const json report = json::parse(read(folder / "r.json"));
  CHECK(report["status"] == "alarm");
  CHECK(report["counts"]["y"].get<int>() >= 3000);
}

TEST_CASE("pulses too fast for one step of the counter overflow it", "[apps][pulse]") {
  const Folder folder;
  write(folder / "p.nc", kPulsedPart);
  const Ended ended = call("run " + (folder / "p.nc") +
                           " --set control.interpolation=dsm --set axis.x.drive.counter_bits=8"
                           " --set axis.x.drive.following_error_um=50000");
  CHECK(ended.status == 4);
  CHECK(shows(ended.err, "error: counter overflow of X: it is ... [SC5002]"));
}
