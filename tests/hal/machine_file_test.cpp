// SPDX-License-Identifier: MIT
// Machine files that load, machine files that are refused with their place, and the way back to
// text.
#include "hal/machine/machine_file.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "hal/machine/machine_keys.hpp"
#include "support/property.hpp"
#include "support/shown.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::all_of;
using test::kSource;
using test::parsed;
using test::Settings;

/// All that is reported.
std::string refused_machine(const std::string& text, const Settings& settings = {}) {
  const auto machine = parse_machine(text, "mill.toml", settings);
  REQUIRE_FALSE(machine);
  for (const Diagnostic& fault : machine.error()) CHECK(exit_status(fault) == 2);
  return all_of(machine.error());
}

/// The place and the code of each.
std::vector<std::string> faults_of(const std::string& text, const Settings& settings = {}) {
  const auto machine = parse_machine(text, "mill.toml", settings);
  REQUIRE_FALSE(machine);
  std::vector<std::string> faults;
  for (const Diagnostic& fault : machine.error()) {
    const std::string shown = render(fault);
    faults.push_back(shown.substr(0, shown.find("error: ")) + code_name(fault.code));
  }
  return faults;
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Every number of the machine, by way of the table of keys.
bool identical(Machine a, Machine b) {
  if (a.tools.size() != b.tools.size()) return false;
  for (std::size_t axis = 0; axis < a.axes.size(); ++axis)
    if (a.axes[axis].present != b.axes[axis].present) return false;
  const auto same = [&](const MachineKey& key, int index) {
    if (const auto* number = std::get_if<NumberKey>(&key.value))
      return same_bits(number->place(a, index), number->place(b, index));
    if (const auto* whole = std::get_if<WholeKey>(&key.value))
      return whole->place(a, index) == whole->place(b, index);
    if (const auto* choice = std::get_if<ChoiceKey>(&key.value))
      return choice->get(a) == choice->get(b);
    if (const auto* point = std::get_if<PointKey>(&key.value))
      return point->place(a, index) == point->place(b, index);
    if (const auto* list = std::get_if<ListKey>(&key.value))
      return list->place(a, index) == list->place(b, index);
    if (const auto* pairs = std::get_if<PairsKey>(&key.value))
      return std::ranges::equal(pairs->place(a, index), pairs->place(b, index),
                                [](const PitchPoint& one, const PitchPoint& other) {
                                  return same_bits(one.position, other.position) &&
                                         same_bits(one.error, other.error);
                                });
    return std::get<TextKey>(key.value).place(a, index) ==
           std::get<TextKey>(key.value).place(b, index);
  };
  for (const MachineKey& key : machine_keys()) {
    if (is_axis_key(key)) {
      for (int axis = 0; axis < kAxes; ++axis)
        if (a.axes[static_cast<std::size_t>(axis)].present && !same(key, axis)) return false;
    } else if (is_tool_key(key)) {
      for (const auto& [number, tool] : Machine(a).tools)
        if (!b.tools.contains(number) || !same(key, number)) return false;
    } else if (!same(key, 0)) {
      return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("without a file the machine is the built-in one", "[hal][machine]") {
  const auto machine = load_machine("", {});
  REQUIRE(machine);
  CHECK(identical(*machine, Machine{}));
}

TEST_CASE("an empty file is the built-in machine under the file's name", "[hal][machine]") {
  Machine expected;
  expected.name = "mill";
  CHECK(identical(parsed(""), expected));
}

TEST_CASE("every key reaches its place in internal units", "[hal][machine]") {
  const Machine m = parsed(R"(
name = "bench mill"
[control]
period_ms = 8
servo_period_ms = 0.5
chord_tolerance_um = 0.05
interpolation = "curvature3p"
corner_tolerance_um = 5.0
pulse_clock = "paper"
acc_dec_ms = 60
rough_period_ms = 16
constant_feed = "off"
backend = "none"
[limits]
feed_mm_min = 2000
[axis.y]
velocity_mm_min = 6000.0
acceleration_mm_s2 = 500
min_mm = -20
max_mm = 30.5
blu_um = 1.25
screw_lead_mm = 2.5
counts_per_rev = 2_000
[axis.y.motor]
resistance_ohm = 2
inductance_mh = 1.5
torque_constant_nm_a = 0.2
emf_constant_v_s_rad = 0.21
inertia_kg_m2 = 1e-3
viscous_friction_nm_s_rad = 1e-5
coulomb_friction_nm = 0.25
[axis.y.drive]
kv_1_s = 40
counter_bits = 16
fv_time_constant_ms = 2
velocity_gain_v_s_rad = 3
velocity_reset_1_s = 70
supply_v = 60
current_limit_a = 12
following_error_um = 7500
lost_pulse = 1000
[spindle]
min_rpm = 100
max_rpm = 12500
[program]
block_limit = 250
motion_limit_h = 0.5
[surface]
phase = "time"
[stock]
x_mm = 20
y_mm = 30
z_mm = 4.5
origin_mm = [-10, 0.5, -4.5]
grid_um = 5
[tool.7]
radius_mm = 2.5
teeth = 4
)");
  CHECK(m.name == "bench mill");
  CHECK(m.control.period == 0.008);
  CHECK(m.control.servo_period == 0.0005);
  CHECK(m.control.chord_tolerance == 0.05e-3);
  CHECK(m.control.interpolation == Method::curvature3p);
  CHECK(m.control.corner_tolerance == 0.005);
  CHECK(m.control.pulse_clock == PulseClock::paper);
  CHECK(m.control.acc_dec == 0.06);
  CHECK(m.control.rough_period == 0.016);
  CHECK(m.control.constant_feed == ConstantFeed::off);
  CHECK(m.control.backend == BackendKind::none);
  CHECK(m.limits.feed == 2000.0 / 60.0);
  CHECK_FALSE(m.axes[0].present);
  CHECK_FALSE(m.axes[2].present);
  const Axis& y = m.axes[1];
  REQUIRE(y.present);
  CHECK(y.velocity == 100.0);
  CHECK(y.acceleration == 500.0);
  CHECK(y.jerk == 0.0);
  CHECK(y.min == -20.0);
  CHECK(y.max == 30.5);
  CHECK(y.blu == 0.00125);
  CHECK(y.screw_lead == 2.5);
  CHECK(y.counts_per_rev == 2000);
  CHECK(y.motor.resistance == 2.0);
  CHECK(y.motor.inductance == 0.0015);
  CHECK(y.motor.torque_constant == 0.2);
  CHECK(y.motor.emf_constant == 0.21);
  CHECK(y.motor.inertia == 0.001);
  CHECK(y.motor.viscous_friction == 1e-5);
  CHECK(y.motor.coulomb_friction == 0.25);
  CHECK(y.drive.kv == 40.0);
  CHECK(y.drive.counter_bits == 16);
  CHECK(y.drive.fv_time_constant == 0.002);
  CHECK(y.drive.velocity_gain == 3.0);
  CHECK(y.drive.velocity_reset == 70.0);
  CHECK(y.drive.supply_voltage == 60.0);
  CHECK(y.drive.current_limit == 12.0);
  CHECK(y.drive.following_error == 7.5);
  CHECK(y.drive.lost_pulse == 1000);
  CHECK(m.spindle.min_rpm == 100);
  CHECK(m.spindle.max_rpm == 12500);
  CHECK(m.program.block_limit == 250);
  CHECK(m.program.motion_limit == 1800);
  CHECK(m.surfacing.phase == SpindlePhase::time);
  CHECK(m.stock.size == AxisVector(20, 30, 4.5));
  CHECK(m.stock.origin == std::vector<double>{-10, 0.5, -4.5});
  CHECK(m.stock.grid == 0.005);
  REQUIRE(m.tools.size() == 1);
  CHECK(m.tools.at(7).radius == 2.5);
  CHECK(m.tools.at(7).teeth == 4);
}

TEST_CASE("every word of a choice is known", "[hal][machine]") {
  for (std::size_t i = 0; i < kMethodNames.size(); ++i) {
    const std::string word(kMethodNames[i]);
    CHECK(static_cast<std::size_t>(
              parsed("", {"control.interpolation=" + word}).control.interpolation) == i);
  }
  CHECK(parsed("", {"control.backend=none"}).control.backend == BackendKind::none);
  CHECK(parsed("", {"control.backend=\"sim\""}).control.backend == BackendKind::sim);
}

TEST_CASE("a file that names an axis has exactly the axes it names", "[hal][machine]") {
  const auto axes = [](const std::string& text) {
    std::string letters;
    const Machine machine = parsed(text);
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
      if (machine.axes[i].present) letters += kAxisLetters[i];
    return letters;
  };
  CHECK(axes("[control]\nperiod_ms = 2") == "XYZ");
  CHECK(axes("[axis.x]\n[axis.y]") == "XY");
  CHECK(axes("[axis.z.motor]\nresistance_ohm = 2") == "Z");
  CHECK(axes("axis.y.blu_um = 1.0") == "Y");
}

TEST_CASE("axes of one's own come without a limit along the path", "[hal][machine]") {
  CHECK(parsed("").limits.feed == 250);
  CHECK(parsed("[control]\nperiod_ms = 2").limits.feed == 250);
  CHECK(parsed("[axis.x]").limits.feed == 0);
  CHECK(parsed("[axis.x]\n[limits]\nfeed_mm_min = 60").limits.feed == 1);
  CHECK(parsed("[axis.x]", {"limits.feed_mm_min=120"}).limits.feed == 2);
}

TEST_CASE("settings stand above the file", "[hal][machine]") {
  const Machine m = parsed("[axis.x]\nacceleration_mm_s2 = 300\nvelocity_mm_min = 60",
                           {"axis.x.acceleration_mm_s2=500", " control.period_ms = 2.0 ",
                            "name=a=b", "tool.3.teeth=2", "axis.x.min_mm=-0.0"});
  CHECK(m.axes[0].acceleration == 500);
  CHECK(m.axes[0].velocity == 1);
  CHECK(m.control.period == 0.002);
  CHECK(m.name == "a=b");
  CHECK(m.tools.at(3).teeth == 2);
  CHECK_FALSE(std::signbit(m.axes[0].min));
}

TEST_CASE("fine interpolation and the simulated loop follow the period unless they are given",
          "[hal][machine]") {
  struct Expected {
    const char *period, *servo;
    double fine, loop;  // ms
  };
  const auto [period, servo, fine, loop] =
      GENERATE(Expected{"1", "0", 1, 0.25}, Expected{"8", "0", 1, 0.25},
               Expected{"0.25", "0", 0.25, 0.25}, Expected{"0.1", "0", 0.1, 0.1},
               Expected{"0.7", "0", 0.7, 0.7 / 3}, Expected{"1.5", "0", 0.75, 0.25},
               Expected{"8", "8", 8, 8}, Expected{"8", "0.25", 0.25, 0.25});
  INFO(period << " ms, " << servo << " ms");
  const Control control = parsed("", {std::string("control.period_ms=") + period,
                                      std::string("control.servo_period_ms=") + servo})
                              .control;
  CHECK(fine_period(control) == Approx(fine / 1000));
  CHECK(loop_period(control) == Approx(loop / 1000));
  CHECK(parts_of_period(control, loop_period(control)) * loop == Approx(std::stod(period)));
}

TEST_CASE("a servo period that is 0 is one that is not given", "[hal][machine]") {
  CHECK(parsed("").control.servo_period == 0);
  CHECK(machine_toml(parsed("")).find("\nservo_period_ms = 0\n") != std::string::npos);
  CHECK(refused_machine("", {"control.servo_period_ms=0.0001"})
            .find("must be 0, or at least 0.001") != std::string::npos);
}

TEST_CASE("a wrong machine file is refused with its place", "[hal][machine]") {
  SECTION("an unknown key") {
    CHECK(refused_machine("[control]\ncicle_ms = 1.0\n") ==
          "mill.toml:2:1: error: unknown key 'control.cicle_ms'; did you mean "
          "'control.period_ms'? [SC7001]\n"
          "    2 | cicle_ms = 1.0\n"
          "      | ^~~~~~~~\n");
    CHECK(refused_machine("period_ms = 1.0") ==
          "mill.toml:1:1: error: unknown key 'period_ms'; did you mean "
          "'control.period_ms'? [SC7001]\n"
          "    1 | period_ms = 1.0\n"
          "      | ^~~~~~~~~\n");
    CHECK(refused_machine("[axis.y.driv]\nkv_1_s = 3")
              .starts_with("mill.toml:1:9: error: unknown key 'axis.y.driv'; did you mean "
                           "'axis.y.drive'? [SC7001]\n"));
    CHECK(begins_showing(refused_machine("[axis.a]\nblu_um = 3"),
                         "mill.toml:1:7: error: unknown key 'axis.a'... [SC7001]"));
    CHECK(begins_showing(refused_machine("[tool.01]\nteeth = 3"),
                         "mill.toml:1:7: error: unknown key 'tool.01'... [SC7001]"));
  }
  SECTION("no TOML") {
    CHECK(refused_machine("[control]\nperiod_ms = = 1\n") ==
          "mill.toml:2:13: error: not TOML: value: could not determine value type [SC7002]\n"
          "    2 | period_ms = = 1\n"
          "      |             ^\n");
  }
  SECTION("a missing file") {
    const auto machine = load_machine("no/such/mill.toml", {});
    REQUIRE_FALSE(machine);
    CHECK(all_of(machine.error()) ==
          "no/such/mill.toml: error: cannot be read: No such file or directory [SC7003]\n");
    const auto folder = load_machine(kSource, {});
    REQUIRE_FALSE(folder);
    CHECK(folder.error().front().code == Code::SC7003);
  }
  SECTION("a wrong type") {
    CHECK(refused_machine("[axis.x]\nblu_um = \"fine\"") ==
          "mill.toml:2:10: error: axis.x.blu_um takes a number, not a string [SC7004]\n"
          "    2 | blu_um = \"fine\"\n"
          "      |          ^~~~~~\n");
    CHECK(refused_machine("control = 3")
              .starts_with("mill.toml:1:11: error: control must be a table [SC7004]\n"));
    CHECK(refused_machine("axis.x.counts_per_rev = 2000.5")
              .starts_with("mill.toml:1:25: error: axis.x.counts_per_rev takes an "
                           "integer, not a number [SC7004]\n"));
    CHECK(refused_machine("control.backend = true")
              .starts_with(
                  "mill.toml:1:19: error: control.backend takes one of 'none', "
                  "'sim', 'stepdir', 'parport', 'hal-stream', not true or false [SC7004]\n"));
    CHECK(
        refused_machine("[control.period_ms]\nx = 1")
            .starts_with(
                "mill.toml:1:1: error: control.period_ms takes a number, not a table [SC7004]\n"));
    CHECK(refused_machine("name = 1979-05-27")
              .starts_with(
                  "mill.toml:1:8: error: name takes a string, not a date or time [SC7004]\n"));
    CHECK(refused_machine("name = [1]")
              .starts_with("mill.toml:1:8: error: name takes a string, not an array [SC7004]\n"));
  }
  SECTION("no point") {
    CHECK(refused_machine("[stock]\norigin_mm = [1, 2]")
              .starts_with("mill.toml:2:13: error: stock.origin_mm takes an array of three "
                           "numbers, or of none, not an array [SC7004]\n"));
    CHECK(refused_machine("stock.origin_mm = [1, \"2\", 3]")
              .starts_with("mill.toml:1:19: error: stock.origin_mm takes an array of three "
                           "numbers, or of none, not an array [SC7004]\n"));
    CHECK(refused_machine("stock.origin_mm = 1").find("not a number") != std::string::npos);
    CHECK(refused_machine("stock.origin_mm = [1, 2e6, 3]")
              .starts_with("mill.toml:1:19: error: stock.origin_mm must be at least -1e+05 "
                           "and at most 1e+05, not 2e+06 [SC7005]\n"));
    CHECK(refused_machine("stock.x_mm = [1, 2, 3]").find("takes a number, not an array") !=
          std::string::npos);
  }
  SECTION("out of range") {
    CHECK(refused_machine("[control]\n\n   period_ms = -1.5 # no\n") ==
          "mill.toml:3:16: error: control.period_ms must be at least 0.001 and at most "
          "1000, not -1.5 [SC7005]\n"
          "    3 |    period_ms = -1.5 # no\n"
          "      |                ^~~~\n");
    for (const char* value : {"0", "nan", "inf", "-inf", "1e9"})
      CHECK(begins_showing(refused_machine(std::string("axis.x.velocity_mm_min = ") + value),
                           "mill.toml:1:26: error: axis.x.velocity_mm_min must be... [SC7005]"));
    for (const char* key : {"acceleration_mm_s2", "blu_um"})
      CHECK(shows(refused_machine(std::string("[axis.z]\n") + key + " = 0"),
                  "error: axis.z." + std::string(key) + "... [SC7005]"));
    CHECK(refused_machine("axis.x.drive.counter_bits = 99")
              .starts_with("mill.toml:1:29: error: axis.x.drive.counter_bits must be at "
                           "least 2 and at most "
                           "32, not 99 [SC7005]\n"));
  }
  SECTION("an unknown word") {
    CHECK(refused_machine("control.interpolation = 'spline'")
              .starts_with("mill.toml:1:25: error: control.interpolation must be one "
                           "of "
                           "'arc-length', 'taylor1', 'taylor2', 'curvature3p', 'rk4', "
                           "'yeh-hsu-1999', 'yeh-hsu-2002', 'chords', 'acc-dec-linear', "
                           "'acc-dec-bell', 'two-step', 'sam', 'm-sam', 'dsm', 'm-dsm', 'dda', "
                           "not 'spline' [SC7006]\n"));
  }
  SECTION("travel the wrong way round") {
    CHECK(refused_machine("[axis.x]\nmin_mm = 10\nmax_mm = 10") ==
          "mill.toml:3:10: error: axis.x.min_mm = 10 is not below axis.x.max_mm = 10 [SC7008]\n"
          "    3 | max_mm = 10\n"
          "      |          ^~\n");
    CHECK(refused_machine("[axis.z]\nmin_mm = 2000")
              .starts_with("mill.toml:2:10: error: axis.z.min_mm = 2000 is not below "
                           "axis.z.max_mm = 1000 [SC7008]\n"));
  }
  SECTION("a home switch at the end of travel") {
    CHECK(refused_machine("[axis.x]\nmin_mm = -100\n[axis.x.home]\nsearch_mm_min = -600\n"
                          "switch_mm = -103") ==
          "mill.toml:5:13: error: axis.x rests at -101 after homing, beyond its travel from -100 "
          "to 1000 [SC7028]\n"
          "    5 | switch_mm = -103\n"
          "      |             ^~~~\n");
    CHECK(refused_machine("[axis.z.home]\nsearch_mm_min = 600\nback_off_mm = 1000\n"
                          "switch_mm = -1")
              .starts_with("mill.toml:4:13: error: axis.z rests at -1001 after homing"));
    CHECK(refused_machine("[axis.x.home]\nsearch_mm_min = -6000\nback_off_mm = 0.3")
              .starts_with("mill.toml:3:15: error: axis.x.home.back_off_mm = 0.3 is less than the "
                           "search covers in four periods, 0.4 mm [SC7028]\n"));
  }
  SECTION("a place for tool changes beyond the travel") {
    CHECK(
        refused_machine("[axis.z]\nmax_mm = 40\n[tool_change]\nat = [0, 0, 50]") ==
        "mill.toml:4:6: error: tool_change.at: 50 is beyond the travel of axis.z from -1000 to 40 "
        "[SC7029]\n"
        "    4 | at = [0, 0, 50]\n"
        "      |      ^~~~~~~~~~\n");
  }
  SECTION("periods that do not divide") {
    CHECK(refused_machine("[control]\nperiod_ms = 1.5\nservo_period_ms = 1.0") ==
          "mill.toml:2:13: error: control.period_ms = 1.5 is not a multiple of "
          "control.servo_period_ms = 1 [SC7010]\n"
          "    2 | period_ms = 1.5\n"
          "      |             ^~~\n");
    CHECK(begins_showing(refused_machine("[control]\nservo_period_ms = 2.0"),
                         "mill.toml:2:19: error: ... [SC7010]"));
  }
  SECTION("a method without limits on a real machine") {
    CHECK(refused_machine("[control]\ninterpolation = 'chords'\nbackend = 'hal-stream'") ==
          "mill.toml:2:17: error: chords keeps no limit of the axes, so it runs with "
          "control.backend = none or sim alone, not with hal-stream [SC7081]\n"
          "    2 | interpolation = 'chords'\n"
          "      |                 ^~~~~~~~\n");
    for (const char* backend : {"stepdir", "parport", "hal-stream"})
      for (const char* method : {"chords", "acc-dec-linear", "acc-dec-bell", "two-step"})
        CHECK(refused_machine("", {std::string("control.interpolation=") + method,
                                   std::string("control.backend=") + backend})
                  .find("[SC7081]") != std::string::npos);
    for (const char* method : {"rk4", "yeh-hsu-1999", "yeh-hsu-2002"}) {
      const std::vector<std::string> given{std::string("control.interpolation=") + method,
                                           "control.backend=hal-stream"};
      CHECK(load_machine("", given).has_value());
    }
  }
  SECTION("a rough period that is not a multiple of the period") {
    const std::string two_step = "[control]\ninterpolation = 'two-step'\n";
    CHECK(refused_machine(two_step + "rough_period_ms = 8\nperiod_ms = 3") ==
          "mill.toml:3:19: error: control.rough_period_ms = 8 is not a multiple of "
          "control.period_ms = 3 [SC7082]\n"
          "    3 | rough_period_ms = 8\n"
          "      |                   ^\n");
    CHECK(begins_showing(refused_machine(two_step + "period_ms = 16"),
                         "mill.toml:3:13: error: ... [SC7082]"));
    CHECK(parsed(two_step + "period_ms = 0.5").control.rough_period == 0.008);
    CHECK(parsed("[control]\nperiod_ms = 3").control.period == 0.003);
  }
  SECTION("acceleration after interpolation over too many periods") {
    CHECK(refused_machine("[control]\ninterpolation = 'acc-dec-bell'\nperiod_ms = 0.01\n"
                          "servo_period_ms = 0.01\nacc_dec_ms = 5000") ==
          "mill.toml:5:14: error: acceleration over 5000 ms is more than 100000 periods of 0.01 "
          "ms [SC7083]\n"
          "    5 | acc_dec_ms = 5000\n"
          "      |              ^~~~\n");
    CHECK(begins_showing(refused_machine("[control]\ninterpolation = 'acc-dec-linear'\n[axis.x]\n"
                                         "acceleration_mm_s2 = 0.001"),
                         "mill.toml:4:22: error: ... [SC7083]"));
  }
  SECTION("axes faster than their pulses") {
    const std::string port = "control.backend = 'stepdir'\nbackend.stepdir.";
    CHECK(refused_machine(port + "max_rate_hz = 50000") ==
          "mill.toml:2:31: error: axis.x.velocity_mm_min = 15000 is more than axis.x.blu_um "
          "= 2.5 times backend.stepdir.max_rate_hz = 50000, which is 7500 mm/min [SC7018]\n"
          "    2 | backend.stepdir.max_rate_hz = 50000\n"
          "      |                               ^~~~~\n");
    CHECK(refused_machine(port + "file = ''\naxis.y.velocity_mm_min = 15001")
              .starts_with("mill.toml:3:26: error: axis.y.velocity_mm_min = 15001 is more "
                           "than axis.y.blu_um = 2.5 times backend.stepdir.max_rate_hz = 100000, "
                           "which is 15000 mm/min [SC7018]\n"));
    CHECK(begins_showing(refused_machine("", {"control.backend=stepdir", "axis.z.blu_um=1"}),
                         "--set:1:15: error: axis.z.velocity_mm_min = 15000 is more... [SC7018]"));
    CHECK(
        refused_machine(port + "step_length_ns = 8000")
            .starts_with("mill.toml:2:34: error: backend.stepdir.max_rate_hz = 100000 is "
                         "more than step_length_ns and step_space_ns leave: 95238 Hz [SC7019]\n"));
    CHECK(refused_machine("control.interpolation = 'm-dsm'\naxis.y.blu_um = 1")
              .starts_with("mill.toml:2:17: error: axis.y.velocity_mm_min = 15000 is more "
                           "than axis.y.blu_um = 1 times backend.stepdir.max_rate_hz = 100000, "
                           "which is 6000 mm/min [SC7018]\n"));
    // Wherever softcnc makes the pulses of the drives itself, and nowhere else.
    const std::vector<std::string> methods(kMethodNames.begin(), kMethodNames.end());
    for (std::size_t method = 0; method < methods.size(); ++method)
      for (const BackendKind kind : {BackendKind::none, BackendKind::sim, BackendKind::stepdir,
                                     BackendKind::parport, BackendKind::hal_stream}) {
        const std::vector<std::string> given{"control.interpolation=" + methods[method],
                                             "control.backend=" + std::string(name(kind)),
                                             "axis.y.velocity_mm_min=15001",
                                             "backend.parport.base_period_us=1"};
        const bool simulated = kind == BackendKind::none || kind == BackendKind::sim;
        if (ignores_plan(static_cast<Method>(method)) && !simulated) continue;
        const bool makes = kind == BackendKind::stepdir || kind == BackendKind::parport ||
                           is_by_pulses(static_cast<Method>(method));
        const auto loaded = load_machine("", given);
        CAPTURE(methods[method], name(kind));
        REQUIRE(loaded.has_value() != makes);
        if (makes) {
          CHECK(loaded.error().front().code == Code::SC7018);
          CHECK(exit_status(loaded.error().front()) == 2);
        }
      }
    // Steps come in whole ns: what those leave of the rate is what an axis can have.
    const std::string odd = port + "max_rate_hz = 300000\nbackend.stepdir.step_length_ns = 500\n" +
                            "backend.stepdir.step_space_ns = 500\naxis.x.velocity_mm_min = ";
    CHECK(
        refused_machine(odd + "45000")
            .starts_with("mill.toml:5:26: error: axis.x.velocity_mm_min = 45000 is more "
                         "than axis.x.blu_um = 2.5 times backend.stepdir.max_rate_hz = 300000, "
                         "in whole ns a step every 3334 ns, which is 44991.001 mm/min [SC7018]\n"));
    CHECK(parsed(odd + "44991.001").axes[0].velocity == 44991.001 / 60);
    // No port, no pulses.
    CHECK(parsed("backend.stepdir.max_rate_hz = 50000").step_port.max_rate == 50000);
    CHECK(parsed(port + "step_length_ns = 7500").step_port.step_length == 7.5e-6);
  }
  SECTION("a feed that no axis could have") {
    const std::string port = "control.backend = 'stepdir'\nlimits.feed_mm_min = ";
    CHECK(refused_machine(port + "15000.001") ==
          "mill.toml:2:22: error: limits.feed_mm_min = 15000.001 is more than axis.x.blu_um "
          "= 2.5 times backend.stepdir.max_rate_hz = 100000, which is 15000 mm/min [SC7090]\n"
          "    2 | limits.feed_mm_min = 15000.001\n"
          "      |                      ^~~~~~~~~\n");
    CHECK(parsed(port + "15000").limits.feed == 250);
    CHECK(parsed(port + "0").limits.feed == 0);
    // The axis with the largest steps counts, of those the machine has.
    CHECK(parsed(port + "30000\naxis.y.blu_um = 5").limits.feed == 500);
    CHECK(refused_machine(port + "60000\n[axis.x]\n[axis.y]\nblu_um = 5")
              .starts_with("mill.toml:2:22: error: limits.feed_mm_min = 60000 is more than "
                           "axis.y.blu_um = 5 times backend.stepdir.max_rate_hz = 100000, which is "
                           "30000 mm/min [SC7090]\n"));
    CHECK(begins_showing(
        refused_machine("", {"control.interpolation=dsm", "limits.feed_mm_min=20000"}),
        "--set:1:20: error: limits.feed_mm_min = 20000 is more than ... [SC7090]"));
    CHECK(parsed("limits.feed_mm_min = 20000").limits.feed == 20000 / 60.0);  // no pulses
    const std::string slow =
        "axis.x.velocity_mm_min = 1500\naxis.y.velocity_mm_min = 1500\n"
        "axis.z.velocity_mm_min = 1500\ncontrol.backend = 'parport'\n";
    CHECK(refused_machine(slow + "limits.feed_mm_min = 1501")
              .starts_with("mill.toml:5:22: error: limits.feed_mm_min = 1501 is more than "
                           "axis.x.blu_um = 2.5 every 100 us, the shortest time between steps at "
                           "backend.parport.base_period_us = 50, which is 1500 mm/min [SC7090]\n"));
    // Nobody has asked for the default, so it gives way; and the machine reads back as it is.
    const Machine machine =
        parsed("", {"control.backend=parport", "axis.x.velocity_mm_min=1500",
                    "axis.y.velocity_mm_min=1500", "axis.z.velocity_mm_min=1500"});
    CHECK(machine.limits.feed == Approx(25));
    CHECK(parsed(machine_toml(machine)).limits.feed == machine.limits.feed);
  }
  SECTION("axes faster than a parallel port") {
    // A step of two base periods high and one low takes three, whatever the rate.
    CHECK(shows(
        refused_machine("control.backend = 'parport'\nbackend.stepdir.step_length_ns = 60000\n"
                        "backend.stepdir.max_rate_hz = 14000\naxis.x.velocity_mm_min = 1500\n"
                        "axis.y.velocity_mm_min = 1000\naxis.z.velocity_mm_min = 1000"),
        "error: axis.x.velocity_mm_min = 1500 is more than axis.x.blu_um = 2.5 "
        "every 150 us, ... [SC7070]"));
    const std::string port = "control.backend = 'parport'\nbackend.parport.base_period_us = ";
    CHECK(refused_machine(port + "50") ==
          "mill.toml:2:34: error: axis.x.velocity_mm_min = 15000 is more than axis.x.blu_um "
          "= 2.5 every 100 us, the shortest time between steps at backend.parport.base_period_us = "
          "50, which is 1500 mm/min [SC7070]\n"
          "    2 | backend.parport.base_period_us = 50\n"
          "      |                                  ^~\n");
    CHECK(parsed(port + "5").parallel_port.base_period == 5e-6);
    CHECK(refused_machine(port + "5.1").find("every 10.2 us") != std::string::npos);
    CHECK(shows(refused_machine("control.backend = 'parport'\nbackend.stepdir.max_rate_hz = 50000"),
                "error: ... [SC7018]"));
  }
  SECTION("pins of a parallel port that cannot do what they should") {
    const std::string port =
        "control.backend = 'parport'\nbackend.parport.base_period_us = 5\nbackend.parport.";
    CHECK(refused_machine(port + "x_step_pin = 14")
              .starts_with("mill.toml:3:30: error: backend.parport.x_step_pin = 14 is not a "
                           "data pin: 2 to 9 [SC7071]\n"));
    CHECK(refused_machine(port + "enable_pin = -11")
              .starts_with("mill.toml:3:30: error: backend.parport.enable_pin = -11 is not an "
                           "output: 1 to 9, 14, 16, 17 [SC7071]\n"));
    CHECK(refused_machine(port + "limit_pin = 9")
              .starts_with("mill.toml:3:29: error: backend.parport.limit_pin = 9 is not an "
                           "input: 10, 11, 12, 13, 15 [SC7071]\n"));
    CHECK(refused_machine(port + "y_direction_pin = -2")
              .starts_with("mill.toml:3:35: error: backend.parport.y_direction_pin = -2 is "
                           "the pin of backend.parport.x_step_pin [SC7071]\n"));
    CHECK(refused_machine(port + "y_home_pin = 12\nbackend.parport.z_home_pin = 12")
              .find("backend.parport.z_home_pin = 12 is the pin of backend.parport.y_home_pin") !=
          std::string::npos);
    const std::string shared =
        "x_home_pin = 12\nbackend.parport.y_home_pin = 12\nbackend.parport.z_home_pin = 12\n"
        "axis.x.home.order = 1\naxis.y.home.order = 2\naxis.z.home.order = ";
    CHECK(refused_machine(port + shared + "2\n").find("z_home_pin = 12 is the pin of") !=
          std::string::npos);
    const std::string other = refused_machine(port + shared + "3\nbackend.parport.door_pin = 1\n");
    CHECK(other.find("home_pin") == std::string::npos);
    CHECK(refused_machine(port + "probe_pin = 10\n")
              .find("backend.parport.probe_pin = 10 is the pin of backend.parport.estop_pin") !=
          std::string::npos);
    CHECK(refused_machine(port + "fault_pin = 10")
              .starts_with("mill.toml:3:29: error: backend.parport.fault_pin = 10 is the "
                           "pin of backend.parport.estop_pin [SC7071]\n"));
    CHECK(refused_machine(port + "flood_pin = -8")
              .starts_with("mill.toml:3:29: error: backend.parport.flood_pin = -8 is the pin of "
                           "backend.parport.enable_pin [SC7071]\n"));
    CHECK(refused_machine(port + "spindle_pin = 17\n[output.clamp]\nnumber = 0\npin = -17")
              .starts_with("mill.toml:6:7: error: output.clamp.pin = -17 is the pin of "
                           "backend.parport.spindle_pin [SC7071]\n"));
    CHECK(refused_machine("[output.lamp]\nnumber = 0\nkind = 'analog'\npin = 1")
              .starts_with("mill.toml:4:7: error: output.lamp.pin: only a digital output "
                           "with a number up to 63 has a pin [SC7027]\n"));
    CHECK(refused_machine(port + "spindle_pwm_pin = 17\n[spindle]\nmax_rpm = 0")
              .starts_with("mill.toml:3:35: error: backend.parport.spindle_pwm_pin needs a "
                           "spindle.max_rpm, of which speeds are parts [SC7071]\n"));
    CHECK(parsed(port + "spindle_pwm_pin = -14").parallel_port.spindle_pwm_pin == -14);
    CHECK(parsed(port + "x_step_pin = 0").parallel_port.step_pin[0] == 0);
    CHECK(parsed("backend.parport.x_step_pin = 14").parallel_port.step_pin[0] == 14);
  }
  SECTION("a key given twice") {
    CHECK(refused_machine("[control]\nperiod_ms = 1\nperiod_ms = 2")
              .starts_with("mill.toml:3:13: error: 'period_ms' is given twice [SC7012]\n"));
    CHECK(refused_machine("control.period_ms = 1\ncontrol.period_ms.x = 2")
              .starts_with("mill.toml:2:9: error: 'period_ms' is given twice [SC7012]\n"));
  }
}

TEST_CASE("a wrong setting is refused with its place", "[hal][machine]") {
  CHECK(refused_machine("", {"control.period_ms=0"}) ==
        "--set:1:19: error: control.period_ms must be at least 0.001 and at most 1000, not "
        "0 [SC7005]\n"
        "    1 | control.period_ms=0\n"
        "      |                   ^\n");
  CHECK(refused_machine("", {"control.perid_ms=1"})
            .starts_with("--set:1:1: error: unknown key 'control.perid_ms'; did you mean "
                         "'control.period_ms'? [SC7001]\n"));
  CHECK(refused_machine("[axis.x]", {"axis.z.blu_um=1"})
            .starts_with("--set:1:1: error: the machine has no axis z [SC7007]\n"));
  CHECK(refused_machine("", {"control.period_ms"})
            .starts_with("--set:1:18: error: a setting reads KEY=VALUE [SC7011]\n"));
  CHECK(begins_showing(refused_machine("", {"control.period_ms="}),
                       "--set:1:19: error: ... [SC7011]"));
  CHECK(
      begins_showing(refused_machine("", {"control.backend="}), "--set:1:17: error: ... [SC7011]"));
  CHECK(begins_showing(refused_machine("", {"backend.parport.device"}),
                       "--set:1:23: error: ... [SC7011]"));
  CHECK(parsed("", {"backend.parport.device="}).parallel_port.device.empty());  // a text may be
  CHECK(parsed("", {"backend.stepdir.file = "}).step_port.file.empty());
  CHECK(begins_showing(refused_machine("", {"=3"}), "--set:1:2: error: ... [SC7011]"));
  CHECK(refused_machine("", {"name=mill\x80"})
            .starts_with("--set:1:6: error: not TOML: a value that is not UTF-8 [SC7002]\n"));
  CHECK(
      refused_machine("", {"axis.x.blu_um=2.5\naxis.y.blu_um=1"})
          .starts_with("--set:1:15: error: axis.x.blu_um takes a number, not a string [SC7004]\n"));
  CHECK(begins_showing(refused_machine("", {"control.period_ms=3", "control.servo_period_ms=2"}),
                       "--set:1:19: error: ... [SC7010]"));
}

TEST_CASE("all errors of a file and of settings are reported at once, by their places",
          "[hal][machine]") {
  CHECK(refused_machine("[spindle]\nmax_rpm = -1\n[control]\nperiod_ms = \"a\"\nbackend = 'no'\n"
                        "[axis.x]\nmin_mm = 20\nmax_mm = 10\n",
                        {"limits.feed_mm_min=x", "spindle.min_rpm=-1"}) ==
        "mill.toml:2:11: error: spindle.max_rpm must be 0, or at least 0.001 and at most "
        "1e+06, not -1 [SC7005]\n"
        "    2 | max_rpm = -1\n"
        "      |           ^~\n"
        "mill.toml:4:13: error: control.period_ms takes a number, not a string [SC7004]\n"
        "    4 | period_ms = \"a\"\n"
        "      |             ^~~\n"
        "mill.toml:5:11: error: control.backend must be one of 'none', 'sim', "
        "'stepdir', 'parport', 'hal-stream', not 'no'; did you mean 'none'? [SC7006]\n"
        "    5 | backend = 'no'\n"
        "      |           ^~~~\n"
        "mill.toml:8:10: error: axis.x.min_mm = 20 is not below axis.x.max_mm = 10 [SC7008]\n"
        "    8 | max_mm = 10\n"
        "      |          ^~\n"
        "--set:1:20: error: limits.feed_mm_min takes a number, not a string [SC7004]\n"
        "    1 | limits.feed_mm_min=x\n"
        "      |                    ^\n"
        "--set:1:17: error: spindle.min_rpm must be 0, or at least 0.001 and at most 1e+06, not "
        "-1 [SC7005]\n"
        "    1 | spindle.min_rpm=-1\n"
        "      |                 ^~\n");
  using Faults = std::vector<std::string>;
  CHECK(faults_of("[axis.x]\nblu = 1\n[axis.y]\nblu = 1\n") ==
        Faults{"mill.toml:2:1: SC7001", "mill.toml:4:1: SC7001"});
}

TEST_CASE("what follows from an error of a machine file is not reported", "[hal][machine]") {
  using Faults = std::vector<std::string>;
  SECTION("what stands in a table that is not known") {
    CHECK(faults_of("[axes.x]\nblu_um = 1\n[axes.x.motor]\ncolour = 2\n[spindel]\nx = 1\n") ==
          Faults{"mill.toml:1:2: SC7001", "mill.toml:5:2: SC7001"});
    CHECK(faults_of("[control.period_ms]\nx = 1") == Faults{"mill.toml:1:1: SC7004"});
  }
  SECTION("that a refused value does not go with another") {
    CHECK(faults_of("[axis.x]\nmin_mm = 2000\nmax_mm = 'far'\n") ==
          Faults{"mill.toml:3:10: SC7004"});
    CHECK(faults_of("[control]\nperiod_ms = -1\nservo_period_ms = 2\n") ==
          Faults{"mill.toml:2:13: SC7005"});
  }
  SECTION("that a value does not go with one whose key is misspelt") {
    CHECK(faults_of("[axis.x]\nmin_mm = 2000\nmaximum_mm = 3000\n") ==
          Faults{"mill.toml:3:1: SC7001"});
    CHECK(faults_of("[axis.x]\n[axis.u]\n", {"axis.y.blu_um=1"}) ==
          Faults{"mill.toml:2:7: SC7001"});
  }
  SECTION("all that one line is too fast for") {
    CHECK(faults_of("control.backend = 'stepdir'\nbackend.stepdir.max_rate_hz = 50000\n") ==
          Faults{"mill.toml:2:31: SC7018"});
  }
  SECTION("whatever stands in a file that is no TOML") {
    CHECK(faults_of("[axis.x\n", {"axis.y.blu_um=1", "spindle.max_rpm=-1"}) ==
          Faults{"mill.toml:1:8: SC7002", "--set:1:17: SC7005"});
  }
  SECTION("that another thing needs a pin which a refused one has") {
    CHECK(faults_of("control.backend = 'parport'\n[backend.parport]\nx_step_pin = 10\n"
                    "estop_pin = 10\n") ==
          Faults{"mill.toml:1:19: SC7070", "mill.toml:3:14: SC7071"});
  }
}

TEST_CASE("columns count bytes inside and characters outside", "[hal][machine]") {
  const auto machine = parse_machine("name = \"Fräse\"; x", "mill.toml", {});
  REQUIRE_FALSE(machine);
  CHECK(machine.error().front().code == Code::SC7002);
  CHECK(machine.error().front().pos.column == 16);
  CHECK(begins_showing(all_of(machine.error()), "mill.toml:1:15: error: ... [SC7002]"));
}

TEST_CASE("the nearest key is spelled for the same axis", "[hal][machine]") {
  CHECK(nearest_key("axis.y.acceleration_mm_s") == "axis.y.acceleration_mm_s2");
  CHECK(nearest_key("axis.z.drive.kv") == "axis.z.drive.kv_1_s");
  CHECK(nearest_key("tool.12.tooth") == "tool.12.teeth");
  CHECK(nearest_key("feed_mm_min") == "limits.feed_mm_min");
  CHECK(nearest_key("axis.z.accel") == "axis.z.acceleration_mm_s2");
  CHECK(nearest_key("xyzzy").empty());
}

TEST_CASE("the built-in machine reads back from its text bit for bit", "[hal][machine]") {
  CHECK(identical(parsed(machine_toml(Machine{})), Machine{}));
}

TEST_CASE("a machine reads back from its text bit for bit", "[hal][machine][property]") {
  softcnc::test::holds([] {
    const auto pick = [](const MachineKey& key) -> std::string {
      if (const auto* number = std::get_if<NumberKey>(&key.value)) {
        if (number->range.high == 0) return "0";
        const double part = *rc::gen::inRange(1, 1'000'000'000) / 1e9;
        std::ostringstream text;
        text.precision(17);
        text << number->range.low +
                    part * (std::min(number->range.high, 900.0) - number->range.low);
        return text.str();
      }
      if (const auto* whole = std::get_if<WholeKey>(&key.value))
        return std::to_string(
            *rc::gen::inRange(static_cast<int>(whole->range.low),
                              static_cast<int>(std::min(whole->range.high, 1e6))));
      if (const auto* choice = std::get_if<ChoiceKey>(&key.value)) {
        std::vector<std::string_view> words(choice->words.begin(), choice->words.end());
        std::erase_if(words, [](auto word) {  // some methods ask values to fit one another
          const auto found = std::find(kMethodNames.begin(), kMethodNames.end(), word);
          const auto method = static_cast<Method>(found - kMethodNames.begin());
          return found != kMethodNames.end() && (is_by_pulses(method) || ignores_plan(method));
        });
        return std::string(*rc::gen::elementOf(words));
      }
      if (std::holds_alternative<PointKey>(key.value))
        return *rc::gen::element<std::string>("[]", "[1, -2.5, 1e-3]");
      if (std::holds_alternative<ListKey>(key.value))
        return *rc::gen::element<std::string>("[]", R"(["a b", "/c\"d\\", "ü"])");
      if (std::holds_alternative<PairsKey>(key.value))
        return *rc::gen::element<std::string>("[]", "[[-1.5, 0.1], [3, 7e-3], [1e3, 0]]");
      return "\"a \\\" \\\\ \\u0007 ü\"";
    };
    std::string text = *rc::gen::element<std::string>("", "[axis.x]\n", "[axis.x]\n[axis.z]\n");
    const bool has_z = text.empty() || text.ends_with("z]\n");
    Settings settings;
    for (const MachineKey& key : machine_keys()) {
      const int index = is_axis_key(key) ? (has_z ? 2 : 0) : 4711;
      if ((key.name.ends_with("_mm") && !key.name.starts_with("stock.")) ||
          key.name.ends_with("home.search_mm_min") || key.name == "control.servo_period_ms" ||
          key.name == "backend.sim.plant" ||  // which asks for a file
          key.name == "control.backend" ||    // which asks some values to fit one another
          *rc::gen::arbitrary<bool>())
        continue;
      settings.push_back(path_of({&key, index}) + "=" + pick(key));
    }
    const auto machine = parse_machine(text, "mill.toml", settings);
    RC_ASSERT(machine.has_value());
    const auto again = parse_machine(machine_toml(*machine), "mill.toml", {});
    RC_ASSERT(again.has_value());
    RC_ASSERT(identical(*again, *machine));
    RC_ASSERT(machine_toml(*again) == machine_toml(*machine));
  });
}

TEST_CASE("numbers are written as a person would", "[hal][machine]") {
  const std::string text = machine_toml(parsed("limits.feed_mm_min = 1000\naxis.x.blu_um = 0.1"));
  CHECK(text.find("\nfeed_mm_min = 1000\n") != std::string::npos);
  CHECK(text.find("\nblu_um = 0.1\n") != std::string::npos);
  CHECK(text.starts_with("name = \"mill\"\n\n[control]\nperiod_ms = 1\n"));
}

TEST_CASE("the effective machine names the origin of each value", "[hal][machine]") {
  const test::Folder folder;
  const std::string file = folder / "mill.toml";
  std::ofstream(file) << "[control]\n\nperiod_ms = 8\n[axis.x]\nblu_um = 1.0\n";
  const auto values = effective_values(file, Settings{"control.chord_tolerance_um=0.05"});
  REQUIRE(values);
  const auto find = [&](std::string_view key) {
    const auto found = std::find_if(values->begin(), values->end(),
                                    [&](const EffectiveValue& v) { return v.key == key; });
    REQUIRE(found != values->end());
    return *found;
  };
  CHECK(find("control.period_ms").value == "8");
  CHECK(find("control.period_ms").unit == "ms");
  CHECK(find("control.period_ms").origin == file + ":3");
  CHECK(find("control.period_ms").meaning == "interpolation period: one setpoint each");
  CHECK(find("axis.x.blu_um").origin == file + ":5");
  CHECK(find("control.chord_tolerance_um").origin == "--set");
  CHECK(find("control.chord_tolerance_um").value == "0.05");
  CHECK(find("axis.x.velocity_mm_min").origin == "default");
  CHECK(find("control.backend").value == "\"sim\"");
  CHECK(std::none_of(values->begin(), values->end(),
                     [](const EffectiveValue& v) { return v.key.starts_with("axis.y"); }));
  CHECK_FALSE(effective_values("no/such.toml", {}));
}

TEST_CASE("names of keys are distinct and found again", "[hal][machine]") {
  std::set<std::string_view> seen;
  for (const MachineKey& key : machine_keys()) {
    CHECK(seen.insert(key.name).second);
    const KeyRef ref{&key, is_tool_key(key) ? 42 : is_axis_key(key) ? 1 : 0};
    const auto found = find_key(path_of(ref));
    REQUIRE(found);
    CHECK(found->key == &key);
    CHECK(found->index == ref.index);
    CHECK_FALSE(key.meaning.empty());
  }
}

TEST_CASE("docs/machine.md shows the table of keys", "[hal][machine][docs]") {
  CHECK(test::read(kSource + "/docs/machine.md").find(key_table()) != std::string::npos);
}

TEST_CASE("the machines by name load", "[hal][machine]") {
  for (const char* name : {"retrofit", "paper_000", "paper_004", "bench_mill", "parport_router"}) {
    const auto machine = load_machine(kSource + "/programs/machines/" + name + ".toml", {});
    INFO(name << (machine ? "" : all_of(machine.error())));
    REQUIRE(machine);
    CHECK(identical(parsed(machine_toml(*machine)), *machine));
  }
}

TEST_CASE("the paper's mill is that of its Table 1", "[hal][machine][paper003]") {
  const auto machine = load_machine(kSource + "/programs/machines/retrofit.toml", {});
  REQUIRE(machine);
  CHECK_FALSE(machine->axes[2].present);
  for (int i = 0; i < 2; ++i) {
    const Axis& axis = machine->axes[static_cast<std::size_t>(i)];
    REQUIRE(axis.present);
    CHECK(axis.counts_per_rev == 2000);
    CHECK(axis.blu == 0.0025);
    CHECK(axis.screw_lead / axis.counts_per_rev == Approx(axis.blu).epsilon(1e-15));
    CHECK(axis.velocity == 250.0);                            // 15 m/min
    CHECK(axis.velocity / axis.screw_lead * 60.0 == 3000.0);  // rpm
  }
}

}  // namespace softcnc::hal

TEST_CASE("a machine named by its file is written out in UTF-8", "[hal][machine]") {
  const auto machine = softcnc::hal::parse_machine("", "shop/m\xFChle.toml", {});
  REQUIRE(machine);
  CHECK(machine->name == "m\xEF\xBF\xBDhle");
  CHECK(softcnc::hal::parse_machine(softcnc::hal::machine_toml(*machine), "again.toml", {}));
}
