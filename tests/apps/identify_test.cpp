// SPDX-License-Identifier: MIT
// softcnc identify: the figures of drives that only a trace knows.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "apps/shell.hpp"
#include "support/shown.hpp"

using namespace softcnc::app::test;
using nlohmann::json;

namespace {

constexpr const char* kIdentifyProgram = SOFTCNC_SOURCE_DIR "/programs/26_identify.nc";

/// A trace of programs/26_identify.nc on the built-in mill with some values changed.
void run_on_mill(const Folder& at, const std::string& settings, const std::string& trace) {
  const Ended ended = call("run -q --machine builtin " + std::string(kIdentifyProgram) + " " +
                           settings + " --trace " + (at / trace));
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
}

json identified(const std::string& arguments) {
  const Ended ended = call("identify --format json " + arguments);
  CAPTURE(ended.err);
  REQUIRE(ended.status == 0);
  return json::parse(ended.out);
}

/// Whether a figure is within `part` of the truth, and the truth within its uncertainty.
void check_figure(const json& axis, const char* name, double truth, double part) {
  CAPTURE(axis.dump(), name, truth);
  const double value = axis[name]["value"], uncertainty = axis[name]["uncertainty"];
  CHECK(value == Approx(truth).epsilon(part));
  CHECK(std::abs(value - truth) <= uncertainty);
  CHECK(uncertainty < 0.1 * truth);
}

}  // namespace

TEST_CASE("drives are identified from the trace of a run", "[apps][identify]") {
  const Folder at;
  run_on_mill(at,
              "--set axis.x.drive.kv_1_s=29.1 --set axis.y.motor.inertia_kg_m2=7.3e-4 "
              "--set axis.z.motor.coulomb_friction_nm=0.25 --set axis.z.drive.kv_1_s=31",
              "t.npz");
  const json axes = identified((at / "t.npz") + " --machine builtin -o " + (at / "m.toml"))["axes"];
  check_figure(axes["x"], "kv_1_s", 29.1, 0.003);
  check_figure(axes["y"], "kv_1_s", 30, 0.003);
  check_figure(axes["z"], "kv_1_s", 31, 0.003);
  // J R / (Kt (Ke + Kp)), Kt / (R J) and Tc / J times 5 mm a turn, by hand
  check_figure(axes["y"], "velocity_lag_ms", 7.3e-4 * 1500 / (0.158 * 2.1576), 0.05);
  const double mm_per_rad = 5 / (2 * std::acos(-1.0));
  check_figure(axes["y"], "torque_over_inertia_mm_s2_v", mm_per_rad * 0.158 / (1.5 * 7.3e-4), 0.15);
  check_figure(axes["y"], "friction_over_inertia_mm_s2", mm_per_rad * 0.18 / 7.3e-4, 0.15);
  check_figure(axes["z"], "friction_over_inertia_mm_s2", mm_per_rad * 0.25 / 6.1e-4, 0.15);
  for (const char* axis : {"x", "y", "z"}) {
    CHECK(double(axes[axis]["backlash_um"]["value"]) < 2.5);
    CHECK(double(axes[axis]["residual_um_rms"]) < 1);
  }
  // The measured machine goes as the trace does.
  const json again = identified((at / "t.npz") + " --machine " + (at / "m.toml"))["axes"];
  for (const char* axis : {"x", "y", "z"})
    CHECK(double(again[axis]["residual_of_machine_file_um_rms"]) < 1);
}

TEST_CASE("a plant is identified with its backlash, and then followed", "[apps][identify]") {
  const Folder at;
  write(at / "plant.toml",
        "[axis.x]\nbacklash_um = 60\ndrive.kv_1_s = 28.8\n[axis.y]\nmotor.inertia_kg_m2 = 5e-4\n"
        "[axis.z]\nmotor.coulomb_friction_nm = 0.1\n");
  const std::string plant = "--set backend.sim.plant=" + (at / "plant.toml");
  run_on_mill(at, plant, "t.npz");
  const json axes = identified((at / "t.npz") + " --machine builtin -o " + (at / "m.toml"))["axes"];
  check_figure(axes["x"], "kv_1_s", 28.8, 0.003);
  CHECK(double(axes["x"]["backlash_um"]["value"]) == Approx(60).margin(2.5));
  CHECK(double(axes["y"]["backlash_um"]["value"]) < 2.5);
  const std::string circle = "G21 G17 G90 G1 X50 F1000\nG3 X50 I-50\nG2 X50 I-50\nG1 X0\nM30\n";
  const auto contour = [&](const std::string& machine, bool warns) {
    const Ended ended = call("run - --machine " + machine + " --set control.follow=model " + plant +
                                 " --report " + (at / "r.json"),
                             circle);
    REQUIRE(ended.status == 0);
    CHECK(shows(ended.err, "<stdin>: warning: X lags... [SC5060]") == warns);
    return double(json::parse(read(at / "r.json"))["contour_error_um_max"]);
  };
  CHECK(contour("builtin", true) > 40);
  CHECK(contour(at / "m.toml", false) < 10);
}

TEST_CASE("a trace that is late has the same gain, and a delay", "[apps][identify]") {
  const Folder at;
  run_on_mill(at, "", "t.csv");
  std::istringstream rows(read(at / "t.csv"));
  std::string late, row, before;
  std::ptrdiff_t place = -1;  // of the column
  while (std::getline(rows, row)) {
    if (row.starts_with('#')) continue;
    if (place < 0) {
      const auto name = static_cast<std::ptrdiff_t>(row.find("x_act_mm"));
      place = std::count(row.begin(), row.begin() + name, ',');
      late = row + '\n';
      continue;
    }
    std::size_t first = 0;
    for (auto column = place; column > 0; --column) first = row.find(',', first) + 1;
    const std::size_t size = row.find(',', first) - first;
    const std::string position = row.substr(first, size);
    late += row.replace(first, size, before.empty() ? position : before) + '\n';
    before = position;
  }
  write(at / "late.csv", late);
  const json axis = identified((at / "late.csv") + " --machine builtin")["axes"]["x"];
  check_figure(axis, "kv_1_s", 30, 0.001);
  check_figure(axis, "delay_ms", 1, 0.01);
  check_figure(axis, "friction_over_inertia_mm_s2", 234.8, 0.03);
  CHECK(axis["loop_period_ms"] == 0.25);
  CHECK(double(axis["residual_um_rms"]) < 0.1);
  const Ended text = call("identify --machine builtin " + (at / "late.csv"));
  CHECK(shows(text.out, "  delay of the record, ms "));
}

TEST_CASE("a drive that reads its counter less often is found", "[apps][identify]") {
  const Folder at;
  run_on_mill(at, "--set control.servo_period_ms=1", "t.npz");
  const json axis = identified((at / "t.npz") + " --machine builtin")["axes"]["x"];
  check_figure(axis, "kv_1_s", 30, 0.001);
  CHECK(axis["loop_period_ms"] == 1);
  CHECK(double(axis["delay_ms"]["value"]) == Approx(0).margin(0.01));
  const Ended text = call("identify --machine builtin " + (at / "t.npz"));
  CHECK(shows(text.out,
              "  the drive reads its counter every 1 ms, where the machine file has 0.25 ms"));
}

TEST_CASE("unequal gains are reported with the contour error that they make", "[apps][identify]") {
  const Folder at;
  write(at / "plant.toml",
        "[axis.x]\ndrive.kv_1_s = 31.5\n[axis.y]\ndrive.kv_1_s = 28.5\n[axis.z]\n");
  const std::string settings =
      " --set backend.sim.plant=" + (at / "plant.toml") + " --report " + (at / "r.json");
  for (const std::string follow : {"off", "lead", "model"}) {
    const Ended ended = call("run - --machine builtin --set control.follow=" + follow + settings,
                             "G21 G90 G1 X100 Y100 F3000\nM30\n");
    REQUIRE(ended.status == 0);
    CAPTURE(follow, ended.err);
    const std::string stated = " at F3000 lines between X and Y are up to ";
    const std::size_t place = ended.err.find(stated);
    REQUIRE(place != std::string::npos);
    // v/2 (1/28.5 - 1/31.5), and what the run has
    const double error = std::stod(ended.err.substr(place + stated.size()));
    CHECK(error == Approx(1000 * 25 * (1 / 28.5 - 1 / 31.5)).epsilon(0.02));
    CHECK(error ==
          Approx(double(json::parse(read(at / "r.json"))["contour_error_um_max"])).epsilon(0.04));
  }
  // One axis alone makes none.
  const Ended alone = call("run - --machine builtin --set control.follow=model" + settings,
                           "G21 G90 G1 X100 F3000\nM30\n");
  CHECK(shows(alone.err, "<stdin>: warning: X lags... [SC5060]"));
  CHECK_FALSE(shows(alone.err, "lines between"));
}

TEST_CASE("what a motion does not tell is unknown", "[apps][identify]") {
  const Folder at;
  write(at / "one_way.nc", "G21 G90 G1 X50 F3000\nM30\n");
  const Ended ran =
      call("run -q --machine builtin " + (at / "one_way.nc") + " --trace " + (at / "t.csv"));
  REQUIRE(ran.status == 0);
  const json axes = identified((at / "t.csv") + " --machine builtin")["axes"];
  CHECK(axes["x"]["kv_1_s"]["value"] == Approx(30).epsilon(0.003));
  CHECK(axes["x"]["backlash_um"].is_null());
  CHECK(axes["y"] == json{{"moved", false}});
  const Ended text = call("identify --machine builtin " + (at / "t.csv"));
  CHECK(shows(text.out, "Y does not move: nothing is known of it"));
  CHECK(shows(text.out, "  backlash, um "));
  CHECK(shows(text.out, " unknown "));
}

TEST_CASE("a trace without actual positions is refused", "[apps][identify]") {
  const Folder at;
  const Ended ran = call("run -q --backend none $data/square.nc --trace " + (at / "t.csv"));
  REQUIRE(ran.status == 0);
  const Ended ended = call("identify " + (at / "t.csv") + " -o " + (at / "m.toml"));
  CHECK(ended.status == 5);
  CHECK(ended.out.empty());
  CHECK(shows(
      ended.err,
      (at / "t.csv") + ": error: has no actual positions (columns such as x_act_mm) [SC6100]"));
  CHECK(at.files() == std::vector<std::string>{"t.csv"});
  CHECK(call("identify " + (at / "none.csv")).status == 5);
}
