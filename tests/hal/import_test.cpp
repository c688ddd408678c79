// SPDX-License-Identifier: MIT
// Settings of LinuxCNC, grbl and FluidNC as machine files.
#include "hal/import/import_machine.hpp"

#include <catch2/catch.hpp>
#include <random>

#include "hal/machine/machine_file.hpp"
#include "hal/machine/state_file.hpp"
#include "motion/core/units.hpp"
#include "support/shown.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::all_of;
using test::Folder;

/// What is made of a file that must be good, and the machine that it reads back to.
struct Made : ImportedMachine {
  Machine read;
};

Made made(const std::string& file, const ImportOptions& options = {}) {
  auto imported = import_machine(file, options);
  if (!imported) FAIL(all_of(imported.error()));
  auto machine = parse_machine(imported->machine, "made.toml", {});
  if (!machine) FAIL(all_of(machine.error()));
  return {std::move(*imported), std::move(*machine)};
}

Made made_of(const std::string& name, const std::string& text, const ImportOptions& options = {}) {
  Folder folder;
  folder.with(name, text);
  return made(folder / name, options);
}

std::string refused_import(const std::string& name, const std::string& text) {
  Folder folder;
  folder.with(name, text);
  const auto imported = import_machine(folder / name, {});
  REQUIRE_FALSE(imported);
  std::string shown;
  for (const Diagnostic& error : imported.error()) {
    CHECK(exit_status(error) == 2);
    CHECK(!error.source_line.empty() == (error.pos.line > 0));
    const std::string whole = render(error);
    const auto begin = whole.starts_with(folder / "") ? (folder / "").size() : 0;
    shown += whole.substr(begin, whole.find('\n') + 1 - begin);
  }
  return shown;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// What grbl 1.1 answers to $$ (its page "Settings", with the defaults for a generic machine).
const std::string kGrbl =
    "Grbl 1.1h ['$' for help]\n$0=10\n$1=25\n$2=0\n$3=0\n$4=0\n$5=0\n$6=0\n$10=1\n$11=0.010\n"
    "$12=0.002\n$13=0\n$20=0\n$21=0\n$22=0\n$23=0\n$24=25.000\n$25=500.000\n$26=250\n$27=1.000\n"
    "$30=1000\n$31=0\n$32=0\n$100=250.000\n$101=250.000\n$102=250.000\n$110=500.000\n"
    "$111=500.000\n$112=500.000\n$120=10.000\n$121=10.000\n$122=10.000\n$130=200.000\n"
    "$131=200.000\n$132=200.000\nok\n";

/// The axes of LinuxCNC's sample axis_mm.ini, shortened.
const std::string kConfiguration =
    "# a simulated machine\n[EMC]\nVERSION = 1.1\nMACHINE = Bench \"mill\"\n"
    "[DISPLAY]\nDISPLAY = axis\nPROGRAM_PREFIX = nc\n"
    "[RS274NGC]\nSUBROUTINE_PATH = macros:/opt/subs:~/home\n"
    "[EMCMOT]\nBASE_PERIOD = 50000\nSERVO_PERIOD = 2000000\n"
    "[TRAJ]\nCOORDINATES = X Y Z\nLINEAR_UNITS = mm\nMAX_LINEAR_VELOCITY = 53.5\n"
    "MAX_LINEAR_ACCELERATION = 508\n[KINS]\nKINEMATICS = trivkins\nJOINTS = 3\n"
    "[AXIS_X]\nMAX_VELOCITY = 30\nMAX_ACCELERATION = 500\nMIN_LIMIT = -254\nMAX_LIMIT = 254\n"
    "[JOINT_0]\nTYPE = LINEAR\nMAX_VELOCITY = 40\nMAX_ACCELERATION = 400\nBACKLASH = 0.01\n"
    "SCALE = -160 # steps per mm\nMIN_LIMIT = -300\nMAX_LIMIT = 250\nFERROR = 1.27\n"
    "STEPLEN = 5000\nDIRHOLD = 20000\n"
    "[AXIS_Y]\nMAX_VELOCITY = 30\nMAX_ACCELERATION = 500\nMIN_LIMIT = -1e99\nMAX_LIMIT = 254\n"
    "[JOINT_1]\nSTEP_SCALE = 80\nINPUT_SCALE = 10\nSTEPLEN = 7000\nSTEPSPACE = 0\n"
    "[AXIS_Z]\nMAX_VELOCITY = 20\nMAX_ACCELERATION = 300\nMIN_LIMIT = -50\nMAX_LIMIT = 0.001\n"
    "[JOINT_2]\nINPUT_SCALE = 400\n"
    "[SPINDLE_0]\nMAX_FORWARD_VELOCITY = 8000\nMIN_FORWARD_VELOCITY = 200\n";

}  // namespace

TEST_CASE("grbl's settings become axes", "[hal][import]") {
  const Made mill = made_of("settings.txt", kGrbl);
  for (const Axis& axis : mill.read.axes) {
    CHECK(axis.present);
    CHECK(axis.blu == Approx(0.004));  // 1 mm / 250
    CHECK(axis.velocity == Approx(500.0 / 60));
    CHECK(axis.acceleration == 10);
    CHECK(axis.jerk == 0);
    CHECK(axis.min == -200);
    CHECK(axis.max == 200);
  }
  CHECK(mill.read.control.backend == BackendKind::none);
  CHECK(mill.read.control.corner_tolerance == Approx(0.01));
  CHECK(mill.read.control.chord_tolerance == Approx(0.002));
  CHECK(mill.read.spindle.max_rpm == 1000);
  CHECK(mill.read.spindle.min_rpm == 0);
  CHECK(mill.read.step_port.step_length == Approx(10e-6));
  CHECK(mill.read.limits.feed == 0);
  CHECK(has(mill.machine, "blu_um = 4  # $100=250.000 ("));
  CHECK(has(mill.machine, "settings.txt:24)\n"));
  CHECK(has(mill.machine, "#   $27=1.000 ("));
  REQUIRE(mill.notes.size() == 1);
  CHECK(shows(render(mill.notes.front()),
              "settings.txt: note: 16 settings have no key in a machine "
              "file; the end of the file lists them [SC7031]"));
  CHECK(mill.state == MachineState());
}

TEST_CASE("with soft limits the travel lies below grbl's machine zero", "[hal][import]") {
  const Made mill = made_of("g", "$20=1\n$130=200\n$100=80\n");
  CHECK(mill.read.axes[0].min == -200);
  CHECK(mill.read.axes[0].max == 0);
  CHECK_FALSE(mill.read.axes[1].present);
}

TEST_CASE("settings with descriptions, of axes that softcnc has not, and of FluidNC",
          "[hal][import]") {
  const Made mill =
      made_of("g",
              "[MSG:ready]\n<Idle|MPos:0,0,0>\n  $100 = 80.000 (x, step/mm)\r\n"
              "$110=3000 ; mm/min\n$103=10\n$N0=G21\n$/axes/y/steps_per_mm=160\n"
              "$/axes/y/max_rate_mm_per_min=1200.5\n$/axes/y/acceleration_mm_per_sec2=250\n"
              "$/axes/y/max_travel_mm=150\n$/axes/a/steps_per_mm=3\n$$\n");
  CHECK(mill.read.axes[0].blu == Approx(0.0125));
  CHECK(mill.read.axes[0].velocity == Approx(50));
  CHECK(mill.read.axes[1].blu == Approx(0.00625));
  CHECK(mill.read.axes[1].velocity == Approx(1200.5 / 60));
  CHECK(mill.read.axes[1].acceleration == 250);
  CHECK(mill.read.axes[1].min == -150);
  CHECK(has(mill.machine, "acceleration_mm_s2 = 1000  # no setting gives it: the default\n"));
  for (const char* left : {"#   $103=10 (", "#   $N0=G21 (", "#   $/axes/a/steps_per_mm=3 ("})
    CHECK(has(mill.machine, left));
}

TEST_CASE("what is wrong with grbl's settings is reported at its place", "[hal][import]") {
  CHECK(refused_import("g", "$100=80\n$110=fast\nX1 Y1\n$101=0\n$11=-1\n") ==
        "g:2:6: error: $110 needs a number above 0, not 'fast' [SC7035]\n"
        "g:4:6: error: $101 needs a number above 0, not '0' [SC7035]\n"
        "g:5:5: error: $11 needs a number from 0 on, not '-1' [SC7035]\n");
  CHECK(shows(refused_import("g", "$100=1e9\n"),
              "g:1:6: error: axis.x.blu_um must be at least 0.001 and at most 10000, not 1e-06 "
              "[SC7005]\n"));
  const Made twice = made_of("g", "$100=80\n$100=100\n");
  CHECK(twice.read.axes[0].blu == Approx(0.01));
  CHECK(shows(all_of(twice.notes),
              "g:2:6: warning: $100 is given twice; the last line counts "
              "[SC7036]"));
}

TEST_CASE("a configuration of FluidNC becomes a machine", "[hal][import]") {
  const std::string axes =
      "axes:\n  x:\n    steps_per_mm: 80\n    max_rate_mm_per_min: 3000.5\n"
      "    acceleration_mm_per_sec2: 250\n    max_travel_mm: 300\n    homing:\n"
      "      positive_direction: false\n      mpos_mm: -5\n    motor0:\n      null_motor:\n"
      "  y:\n    max_travel_mm: 200\n    homing:\n      mpos_mm: 3\n"
      "  z:\n    max_travel_mm: 100\n  a:\n    steps_per_mm: 3\n";
  const Made mill =
      made_of("router.yaml", "name: \"Router: 1\"\n" + axes +
                                 "junction_deviation_mm: 0.02\narc_tolerance_mm: 0.003\n"
                                 "stepping:\n  pulse_us: 4\n  dir_delay_us: 0\n"
                                 "kinematics:\n  Cartesian:\nPWM:\n  speed_map: 0=0% 24000=100%\n");
  const Machine& m = mill.read;
  CHECK(m.name == "Router: 1");
  CHECK(m.axes[0].blu == Approx(0.0125));
  CHECK(m.axes[0].velocity == Approx(3000.5 / 60));
  CHECK(m.axes[0].acceleration == 250);
  CHECK(m.axes[0].min == -5);  // it homes downward, to -5
  CHECK(m.axes[0].max == 295);
  CHECK(m.axes[1].min == -197);  // upward, to 3
  CHECK(m.axes[1].max == 3);
  CHECK(m.axes[2].min == -100);  // it does not home: zero is where it was switched on
  CHECK(m.axes[2].max == 100);
  CHECK(m.control.corner_tolerance == Approx(0.02));
  CHECK(m.control.chord_tolerance == Approx(0.003));
  CHECK(m.control.backend == BackendKind::none);
  CHECK(m.spindle.max_rpm == 24000);
  CHECK(m.step_port.step_length == Approx(4e-6));
  CHECK(has(mill.machine, "blu_um = 12.5  # steps_per_mm: 80 ("));
  CHECK(has(mill.machine, "#   steps_per_mm: 3 ("));
  CHECK(made_of("config.txt", axes).read.axes[0].max == 295);  // known by its axes
}

TEST_CASE("FluidNC's defaults and spellings are known", "[hal][import]") {
  const auto x_of = [](const std::string& of_axis) {
    return made_of("f.yaml", "Axes:\naxes:\n  X:\n    Max_Travel_mm: 300\n" + of_axis).read.axes[0];
  };
  CHECK(x_of("    homing:\n      cycle: 1\n").max == 0);
  CHECK(x_of("    homing:\n").max == 0);
  CHECK(x_of("    homing:\n      positive_direction: no\n").max == 300);
  CHECK(x_of("    homing:\n      positive_direction: False\n").min == 0);
  CHECK(x_of("    soft_limits: True\n").max == 0);
  CHECK(x_of("    soft_limits: false\n").max == 300);
  CHECK(made_of("f.yaml",
                "axes:\nLaser:\n  speed_map: 0=0% 1000=100%\nPWM:\n"
                "  speed_map: 0=0% 24000=100%\n")
            .read.spindle.max_rpm == 24000);
  for (const char* form : {"Kinematics:\n  CoreXY:\n", "kinematics: {CoreXY: {}}\n"})
    CHECK(shows(refused_import("f.yaml", std::string("axes:\n") + form), "kinematics/corexy"));
}

TEST_CASE("what is wrong with a configuration of FluidNC is reported at its place",
          "[hal][import]") {
  CHECK(refused_import("f.yaml",
                       "axes:\n  x:\n    steps_per_mm: 0\n    max_travel_mm: long\n"
                       "    max_rate_mm_per_min: -1\n") ==
        "f.yaml:3:19: error: axes/x/steps_per_mm needs a number above 0, not '0' [SC7035]\n"
        "f.yaml:4:20: error: axes/x/max_travel_mm needs a number, not 'long' [SC7035]\n"
        "f.yaml:5:26: error: axes/x/max_rate_mm_per_min needs a number above 0, not '-1' "
        "[SC7035]\n");
  CHECK(shows(refused_import("f.yaml", "axes:\n  x: {steps_per_mm: 80\n"),
              "f.yaml:2:1: error: this is no YAML: ... [SC7034]\n"));
  CHECK(shows(refused_import("f.yaml", "kinematics:\n  CoreXY:\naxes:\n"),
              "error: ... (kinematics/corexy); softcnc moves Cartesian machines [SC7034]\n"));
  const Made twice = made_of("f.yaml", "axes:\n  x:\n    max_travel_mm: 1\n    max_travel_mm: 2\n");
  CHECK(twice.read.axes[0].max == 2);
  CHECK(shows(all_of(twice.notes), "f.yaml:4:20: warning: axes/x/max_travel_mm is given twice"));
}

TEST_CASE("nothing of a hostile configuration is expanded", "[hal][import]") {
  std::string aliases = "a0: &a0 [x, x]\n";
  for (int i = 1; i < 60; ++i)
    aliases += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" +
               std::to_string(i - 1) + ", *a" + std::to_string(i - 1) + "]\n";
  CHECK(made_of("f.yaml", aliases + "axes:\n  x:\n    max_travel_mm: 2\n").read.axes[0].max == 2);
  CHECK(shows(refused_import("f.yaml", "axes:\n" + std::string(1'000'000, '[')),
              "this is no YAML: "));
  CHECK(shows(refused_import("f.yaml", "axes: *nowhere\n"), "this is no YAML: "));
}

TEST_CASE("a configuration of LinuxCNC becomes a machine", "[hal][import]") {
  const Made mill = made_of("mill.ini", kConfiguration);
  const Machine& m = mill.read;
  CHECK(m.name == "Bench \"mill\"");
  CHECK(m.axes[0].velocity == 30);  // the lower one of axis and joint, as of all limits
  CHECK(m.axes[0].acceleration == 400);
  CHECK(m.axes[0].min == -254);
  CHECK(m.axes[0].max == 250);
  CHECK(m.axes[0].blu == Approx(0.00625));
  CHECK(m.axes[1].blu == Approx(0.0125));
  CHECK(m.axes[1].min == -1e5);  // none
  CHECK(m.axes[2].blu == Approx(0.0025));
  CHECK(m.axes[2].velocity == 20);
  CHECK(m.axes[2].max == 0.001);
  CHECK(m.limits.feed == 53.5);
  CHECK(m.limits.tangential == 508);
  CHECK(m.control.period == Approx(0.002));
  CHECK(m.parallel_port.base_period == Approx(50e-6));
  CHECK(m.control.backend == BackendKind::none);
  CHECK(m.spindle.max_rpm == 8000);
  CHECK(m.spindle.min_rpm == 200);
  CHECK(m.screws[0].backlash == Approx(0.01));
  CHECK(m.screws[1].backlash == 0);
  CHECK(m.step_port.step_length == Approx(7e-6));
  CHECK(m.step_port.direction_hold == Approx(20e-6));
  CHECK(m.step_port.step_space == StepPort().step_space);
  REQUIRE(m.program.path.size() == 3);
  CHECK(m.program.path[0].ends_with("nc"));
  CHECK(m.program.path[2] == "/opt/subs");
  CHECK(has(mill.machine, "# MAX_VELOCITY = 30 ("));
  for (const char* left :
       {"#   FERROR = 1.27 (", "#   INPUT_SCALE = 10 (", "#   the variables of [DISPLAY]\n"})
    CHECK(has(mill.machine, left));
}

TEST_CASE("inches of a configuration become mm", "[hal][import]") {
  for (const char* unit : {"inch", "in", "Imperial", "0.03937007874015748"}) {
    CAPTURE(unit);
    const Made mill = made_of(
        "mill.ini", std::string("[TRAJ]\nLINEAR_UNITS = ") + unit +
                        "\nMAX_LINEAR_VELOCITY = 2\n[AXIS_X]\nMAX_VELOCITY = 1.5\n"
                        "MAX_ACCELERATION = 20\nMIN_LIMIT = -10\nMAX_LIMIT = 10\n[JOINT_0]\n"
                        "SCALE = 16000\n");
    CHECK(mill.read.axes[0].velocity == Approx(38.1));
    CHECK(mill.read.axes[0].acceleration == Approx(508));
    CHECK(mill.read.axes[0].min == Approx(-254));
    CHECK(mill.read.axes[0].blu == Approx(25.4 / 16000));
    CHECK(mill.read.limits.feed == Approx(50.8));
    CHECK_FALSE(mill.read.axes[1].present);
  }
}

TEST_CASE("joints belong to the coordinates in their order", "[hal][import]") {
  const std::string joints =
      "[JOINT_0]\nSCALE = 100\n[JOINT_1]\nSCALE = 200\nMAX_VELOCITY = 9\n"
      "[JOINT_2]\nSCALE = 200\nMAX_VELOCITY = 8\n[JOINT_3]\nSCALE = 400\n";
  const Made gantry = made_of("a.ini",
                              "[KINS]\nKINEMATICS = trivkins coordinates=XYYZ kinstype=B\n"
                              "[TRAJ]\nCOORDINATES = X Y Z\n" +
                                  joints);
  CHECK(gantry.read.axes[1].blu == Approx(0.005));
  CHECK(gantry.read.axes[1].velocity == 8);
  CHECK(gantry.read.axes[2].blu == Approx(0.0025));
  const Made lathe = made_of("a.ini", "[TRAJ]\nCOORDINATES = X Z\n" + joints);
  CHECK_FALSE(lathe.read.axes[1].present);
  CHECK(lathe.read.axes[2].blu == Approx(0.005));
  const Made old = made_of("a.ini",
                           "[TRAJ]\nLINEAR_UNITS = mm\nMAX_VELOCITY = 40\n[AXIS_0]\n"
                           "SCALE = 100\nMAX_VELOCITY = 30\n[AXIS_2]\nSCALE = 50\n");
  CHECK(old.read.axes[0].velocity == 30);
  CHECK(old.read.axes[2].blu == Approx(0.02));
  CHECK(old.read.limits.feed == 40);
}

TEST_CASE("a configuration brings its tools, its offsets and its included files", "[hal][import]") {
  Folder folder;
  folder.with("x.inc", "[AXIS_X]\nMAX_VELOCITY = 2\n")
      .with("tool.tbl", "T1 P1 D0.5 Z-1 ;half an inch\n")
      .with("mill.var",
            "5161\t1\n5182\t2\n5210\t1\n5211\t3\n5220\t2\n5221\t0.5\n5230\t30\n"
            "5242\t4\n5390 0\n31\t7\n32\t0\n5399\t9\n")
      .with("mill.ini",
            "#INCLUDE x.inc\n#INCLUDE gone.inc\n[TRAJ]\nLINEAR_UNITS = inch\n[EMCIO]\n"
            "TOOL_TABLE = tool.tbl\n[RS274NGC]\nPARAMETER_FILE = mill.var\n");
  const Made mill = made(folder / "mill.ini");
  CHECK(mill.read.axes[0].velocity == Approx(50.8));
  CHECK(mill.read.tools.at(1).radius == Approx(6.35));
  CHECK(mill.state.tools.at(1).length == AxisVector(0, 0, -25.4));
  CHECK(mill.state.home[0] == Approx(25.4));
  CHECK(mill.state.second_home[1] == Approx(50.8));
  CHECK(mill.state.shift_on);
  CHECK(mill.state.shift[0] == Approx(76.2));
  CHECK(mill.state.active == 1);
  CHECK(mill.state.work[0].origin[0] == Approx(12.7));
  CHECK(mill.state.work[0].rotation == Approx(rad_from_deg(30)));
  CHECK(mill.state.work[1].origin[1] == Approx(101.6));
  CHECK(mill.state.parameters == std::map<int, double>{{31, 7.0}});
  CHECK(shows(all_of(mill.notes),
              "mill.ini:2:1: warning: the file ... cannot be read: ... [SC7037]"));
}

TEST_CASE("what is wrong with a configuration is reported at its place", "[hal][import]") {
  CHECK(refused_import("a.ini",
                       "x = 1\n[TRAJ\n[TRAJ]\nnothing\nLINEAR_UNITS = yard\n[AXIS_X]\n"
                       "MAX_VELOCITY = fast\n[JOINT_0]\nSCALE = 0\n") ==
        "a.ini:1:1: error: a variable before any [SECTION] [SC7034]\n"
        "a.ini:2:1: error: a section needs its ']' [SC7034]\n"
        "a.ini:5:16: error: LINEAR_UNITS is mm or inch, or a number of units per mm, not 'yard' "
        "[SC7035]\n"
        "a.ini:7:16: error: [AXIS_X]MAX_VELOCITY needs a number, not 'fast' [SC7035]\n"
        "a.ini:9:9: error: SCALE cannot be 0 [SC7035]\n");
  CHECK(shows(refused_import("a.ini", "[AXIS_X]\nMIN_LIMIT = 5\nMAX_LIMIT = -5\n"),
              "a.ini:3:13: error: axis.x.min_mm = 5 is not below axis.x.max_mm = -5 [SC7008]"));
  CHECK(shows(refused_import("a.ini", "[AXIS_X]\nMAX_VELOCITY = 0\n"),
              "a.ini:2:16: error: axis.x.velocity_mm_min must be ... [SC7005]"));
  const Made twice = made_of("a.ini",
                             "[AXIS_X]\nMAX_VELOCITY = 5\nMAX_VELOCITY = 6\n"
                             "[EMCIO]\nTOOL_TABLE = gone.tbl\n");
  CHECK(twice.read.axes[0].velocity == 5);
  CHECK(shows(all_of(twice.notes),
              "a.ini:3:16: warning: [AXIS_X]MAX_VELOCITY is given twice; the "
              "first line counts [SC7036]"));
  CHECK(
      shows(all_of(twice.notes), "a.ini:5:14: warning: the file ... cannot be read: ... [SC7037]"));
  Folder folder;
  folder.with("a.ini", "[RS274NGC]\nPARAMETER_FILE = a.var\n")
      .with("a.var", "5221 1\nX 2\n5220 12\n5221 1e9\n");
  const auto imported = import_machine(folder / "a.ini", {});
  REQUIRE_FALSE(imported);
  const std::string shown = all_of(imported.error());
  CHECK(shows(shown, "a.var:2:1: error: ... [SC7034]"));
  CHECK(shows(shown, "a.var:3:6: error: #5220 cannot be 12 [SC7035]"));
  CHECK(shows(shown, "a.var:4:6: error: #5221 cannot be 1e9 [SC7035]"));
}

TEST_CASE("a tool table becomes tools and their lengths", "[hal][import]") {
  const Made tools = made_of("tool.tbl",
                             "T1 P1 D6 Z+0.511 ;a \"mill\"\n; nothing\n\n"
                             "t2 p2 d-3.0625 x1 y2 z3 i95 q1;back\nT99999 P123     Z+0.1 ;big\n"
                             "T0 P0 ;no tool\nT4 P4 D0.\n");
  CHECK(tools.read.tools.size() == 4);
  CHECK(tools.read.tools.at(1).radius == 3);
  CHECK(tools.read.tools.at(2).radius == 1.53125);
  CHECK(tools.read.tools.at(99999).radius == 0);
  CHECK(tools.read.tools.at(4).radius == 0);
  CHECK(tools.state.tools.at(1).length == AxisVector(0, 0, 0.511));
  CHECK(tools.state.tools.at(2).length == AxisVector(1, 2, 3));
  CHECK_FALSE(tools.state.tools.contains(4));
  CHECK(has(tools.machine, "radius_mm = 3  # T1 P1 D6 Z+0.511 ;a \"mill\" ("));
  CHECK(has(tools.machine, "): I, Q\n"));
  CHECK(tools.read.axes[2].present);  // the rest is that of the built-in machine
  const Made inches = made_of("tool.tbl", "T1 D0.25 Z2\n", {.inches = true});
  CHECK(inches.read.tools.at(1).radius == Approx(3.175));
  CHECK(inches.state.tools.at(1).length[2] == Approx(50.8));
}

TEST_CASE("what is wrong with a tool table is reported at its place", "[hal][import]") {
  CHECK(refused_import("tool.tbl", "T1 P1 D\nP2 D3 ;no number\nT1.5\nT3 K4\nT5 T6\nT-1\n") ==
        "tool.tbl:1:7: error: 'D' has no number after its letter [SC7035]\n"
        "tool.tbl:2:1: error: a tool without its number T [SC7034]\n"
        "tool.tbl:3:1: error: 'T1.5' is no number of a tool [SC7035]\n"
        "tool.tbl:4:4: error: 'K4' is no entry of a tool table of LinuxCNC [SC7034]\n"
        "tool.tbl:5:4: error: T is given twice for one tool [SC7034]\n"
        "tool.tbl:6:1: error: 'T-1' is no number of a tool [SC7035]\n");
  CHECK(refused_import("tool.tbl", " TOOLNO POCKET LENGTH\n\n 1 1 0.5\n 2 2 0.5\n") ==
        "tool.tbl:1:2: error: a table with columns is one of LinuxCNC before 2.4; here each entry "
        "has "
        "its letter: T1 P1 D6 Z20 [SC7034]\n");
  CHECK(refused_import("tool.tbl", "T1 Z1e7\n") ==
        "tool.tbl:1:1: error: a tool longer than 1000 m [SC7035]\n");
  const Made twice = made_of("tool.tbl", "T1 D6\nT1 D8\n");
  CHECK(twice.read.tools.at(1).radius == 3);
  CHECK(shows(all_of(twice.notes),
              "tool.tbl:2:1: warning: T1 is given twice; the first line counts "
              "[SC7036]"));
}

TEST_CASE("a file without a known suffix is known by its first lines", "[hal][import]") {
  CHECK(made_of("a", "T1 P1 D6\n").read.tools.size() == 1);
  CHECK(made_of("a", "# mill\n[AXIS_X]\nMAX_VELOCITY = 5\n").read.axes[0].velocity == 5);
  CHECK(shows(refused_import("a.yaml", "name: mill\n"), "a.yaml: error: is neither ... [SC7032]"));
  CHECK(shows(refused_import("a", ""), "[SC7032]"));
  const auto missing = import_machine("/no/such/file.ini", {});
  REQUIRE_FALSE(missing);
  CHECK(shows(all_of(missing.error()), "/no/such/file.ini: error: cannot be read: ... [SC7033]"));
}

TEST_CASE("texts of settings cannot break the file that is made", "[hal][import]") {
  const Made mill = made_of("a.ini",
                            "[EMC]\nMACHINE = a\x01\xFF\\ \"b\n[AXIS_X]\n"
                            "MAX_VELOCITY = 5 # \x02\xFE\nODD\x01 = 1\n");
  CHECK(mill.read.axes[0].velocity == 5);
  CHECK(mill.read.name.starts_with("a\x01"));
}

TEST_CASE("damaged settings are refused, or make a machine that loads", "[hal][import][property]") {
  std::mt19937 random(20261126);
  const std::string pieces = "=$[]#;.-+eE\"\\\n\r\x01\x7F\xFF 9T";
  const std::string table = "T1 P1 D0.5 X1 Z-1 ;half\nT2 D1 I5\n";
  const std::pair<const char*, std::string> sources[] = {
      {"a", kGrbl}, {"a.ini", kConfiguration}, {"a.tbl", table}};
  int good = 0, bad = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto& [name, whole] = sources[static_cast<std::size_t>(i) % 3];
    std::string text = whole;
    for (unsigned damage = 1 + random() % 4; damage > 0; --damage)
      text[random() % text.size()] = pieces[random() % pieces.size()];
    const auto imported = import_text(text, name, {});
    if (!imported) {
      ++bad;
      CHECK_FALSE(imported.error().empty());
      for (const Diagnostic& error : imported.error()) CHECK(exit_status(error) == 2);
      continue;
    }
    ++good;
    CAPTURE(text, imported->machine);
    CHECK(parse_machine(imported->machine, "made.toml", {}));
    CHECK(parse_state(state_toml(imported->state), "made.state.toml"));
  }
  CHECK(good > 100);
  CHECK(bad > 100);
}

}  // namespace softcnc::hal
