// SPDX-License-Identifier: MIT
// An operator at the machine: states and requests, moves by hand, hold and the way back.
#include "runtime/operator/operator.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "hal/backends/backend.hpp"
#include "support/files.hpp"
#include "support/operated.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using namespace softcnc::test;

namespace {

constexpr std::string_view kProgram =
    "G21 G90 G94\nS1000 M03\nG01 X20 Y10 F3000\nG02 X40 Y10 I10 J0\nG01 X60 Y0 F6000\nM30\n";

/// Leads a machine at rest into a mode.
void lead(Desk& desk, MachineMode mode) {
  switch (mode) {
    case MachineMode::idle:
      return;
    case MachineMode::run:
    case MachineMode::hold:
      REQUIRE(desk.operated.start(kProgram));
      desk.run(200);
      if (mode == MachineMode::hold) REQUIRE(desk.operated.hold());
      if (mode == MachineMode::hold) desk.run(500);
      return;
    case MachineMode::jog:
      REQUIRE(desk.operated.jog({AxisVector(50, 0, 0), 50}));
      return desk.run(100);
    case MachineMode::alarm:
      return desk.operated.estop();
    case MachineMode::check:
      REQUIRE(desk.operated.check());
      return;
    case MachineMode::door:
      REQUIRE(desk.operated.door());
      return desk.operated.door_closed();
    case MachineMode::sleep:
      REQUIRE(desk.operated.sleep());
      return;
    case MachineMode::home:
      REQUIRE(desk.operated.home());
      return desk.run(100);
  }
}

}  // namespace

TEST_CASE("each request does in each state what the table says", "[runtime][operator]") {
  for (std::size_t m = 0; m < kModeNames.size(); ++m)
    for (std::size_t r = 0; r < kRequestNames.size(); ++r) {
      CAPTURE(kModeNames[m], kRequestNames[r]);
      const auto mode = static_cast<MachineMode>(m);
      const auto request = static_cast<Request>(r);
      Desk desk(BackendKind::sim);
      lead(desk, mode);
      REQUIRE(desk.operated.mode() == mode);
      const ModeRule rule = mode_rule(mode, request);
      const bool is_program = mode == MachineMode::run && request == Request::line;
      const bool is_fault = mode == MachineMode::alarm && request == Request::jog;
      const bool refused = rule.answer == ModeRule::Answer::refused || is_program || is_fault;
      const Status status = ask(desk.operated, request, kProgram);
      CHECK(status.has_value() != refused);
      if (!status) CHECK(status.error().code == Code::SC5080);
      if (rule.answer != ModeRule::Answer::acts || refused) {
        CHECK(desk.operated.mode() == mode);
        continue;
      }
      const bool has_program = mode != MachineMode::door;
      const bool begins = rule.next == MachineMode::run || rule.next == MachineMode::jog ||
                          rule.next == MachineMode::home;
      if (!begins) desk.run(20'000, [&] { return desk.operated.mode() == rule.next; });
      CHECK(desk.operated.mode() == (begins && !has_program ? MachineMode::idle : rule.next));
    }
}

TEST_CASE("jogs follow each other, stay within the travel, and end on request",
          "[runtime][operator]") {
  Desk desk(BackendKind::none, 20'000);
  REQUIRE(desk.operated.jog({AxisVector(5, 0, 0), 50}));
  REQUIRE(desk.operated.jog({AxisVector(0, -3, 1), 50}));
  CHECK(desk.operated.mode() == MachineMode::jog);
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);
  CHECK((desk.operated.position() - AxisVector(5, -3, 1)).norm() < 1e-9);
  const Status beyond = desk.operated.jog({AxisVector(5000, 0, 0), 50});
  REQUIRE_FALSE(beyond);
  CHECK(beyond.error().code == Code::SC4001);
  CHECK(beyond.error().message == "a jog to X5005 leaves the travel X-1000 to X1000");
  const Status nowhere = desk.operated.jog({AxisVector(0, 0, 0), 50});
  REQUIRE_FALSE(nowhere);
  CHECK(shows(render(nowhere.error()), "softcnc: error: a jog needs a distance [SC5080]"));
  CHECK_FALSE(desk.operated.jog({AxisVector(1, 0, 0), 0}));
  CHECK_FALSE(desk.operated.jog({AxisVector(std::nan(""), 0, 0), 5}));
  CHECK(desk.operated.mode() == MachineMode::idle);
  REQUIRE(desk.operated.jog({AxisVector(0, 1, 0), 1e6, true}));
  desk.run(3000);
  CHECK(desk.operated.last().v == Approx(250));  // an axis is no faster
  REQUIRE(desk.operated.cancel());
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);
  REQUIRE(desk.operated.jog({AxisVector(0, 1, 0), 250, true}));
  desk.settle();
  CHECK(desk.operated.position().y() == Approx(1000));
  REQUIRE(desk.operated.line("G91 G01 X1 F600\nX1\n"));  // G91 stays in force
  desk.settle();
  REQUIRE(desk.operated.jog({AxisVector(3, 0, 0), 50}));
  desk.settle();
  REQUIRE(desk.operated.line("X1\n"));
  desk.settle();
  CHECK(desk.operated.position().x() == Approx(5 + 2 + 3 + 1));
  desk.check_limits();
}

TEST_CASE("lines that open a loop or a subprogram wait until it is closed", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  for (const char* line : {"G91 F600", "#1=0", "o1 while [#1 LT 3] (while)", "G01 X1",
                           "o2 if [#1 EQ 1]", "Y1", "o2 endif", "#1=[#1+1]"}) {
    REQUIRE(desk.operated.line(line));
    desk.settle();
  }
  CHECK(desk.operated.is_line_open());
  CHECK(desk.operated.position().norm() == 0);
  REQUIRE(desk.operated.line("o1 endwhile"));
  CHECK_FALSE(desk.operated.is_line_open());
  desk.settle();
  CHECK((desk.operated.position() - AxisVector(3, 1, 0)).norm() < 1e-9);
  REQUIRE(desk.operated.line("o3 do\n#1=[#1-1]\nX-1"));
  CHECK(desk.operated.is_line_open());
  REQUIRE(desk.operated.line("o3 while [#1 GT 0]"));
  desk.settle();
  CHECK((desk.operated.position() - AxisVector(0, 1, 0)).norm() < 1e-9);
  REQUIRE(desk.operated.line("o4 sub"));
  REQUIRE(desk.operated.reset());  // drops what is open
  CHECK_FALSE(desk.operated.is_line_open());
}

TEST_CASE("a line in error leaves the machine where it is, and the next one runs",
          "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.line("G91 G01 X2 F600\nG01 Q\n"));
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);
  CHECK(desk.errors == std::vector{Code::SC1002});
  REQUIRE(desk.operated.line("X3\n"));
  desk.settle();
  CHECK(desk.operated.position().x() == Approx(5));
  REQUIRE(desk.operated.line("X-2 Y1001\n"));  // beyond the travel
  desk.settle();
  CHECK(desk.errors.back() == Code::SC4001);
  CHECK(desk.operated.position().x() == Approx(5));
}

TEST_CASE("in Hold the operator jogs away, and resume comes back first", "[runtime][operator]") {
  Desk undisturbed(BackendKind::stepdir, 20'000), desk(BackendKind::stepdir, 20'000);
  REQUIRE(undisturbed.operated.start(kProgram));
  undisturbed.settle();
  REQUIRE(desk.operated.start(kProgram));
  desk.run(700);
  REQUIRE(desk.operated.hold());
  CHECK(desk.operated.moving());
  CHECK_FALSE(desk.operated.jog({AxisVector(0, 0, 5), 50}));
  desk.run(1000);
  const AxisVector left = desk.operated.position();
  CHECK_FALSE(desk.operated.return_point());
  REQUIRE(desk.operated.jog({AxisVector(0, 0, 5), 50}));
  REQUIRE(desk.operated.jog({AxisVector(-8, 2, 0), 50}));
  CHECK_FALSE(desk.operated.resume());  // the jog has not ended
  desk.run(2000);
  CHECK(desk.operated.mode() == MachineMode::hold);
  CHECK((desk.operated.position() - left - AxisVector(-8, 2, 5)).norm() < 1e-9);
  REQUIRE(desk.operated.return_point());
  CHECK(*desk.operated.return_point() == left);
  REQUIRE(desk.operated.resume());
  desk.run(50);
  REQUIRE(desk.operated.cancel());  // is ignored in Run
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);
  CHECK(desk.operated.position() == undisturbed.operated.position());
  CHECK(desk.backend->settle() == undisturbed.backend->settle());  // counts of pulses
  desk.check_limits();
}

TEST_CASE("abort in Hold ends the program where the machine is", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.start("G10 L2 P2 X7\nG01 X50 F3000\nG10 L2 P3 X8\nM30\n"));
  desk.run(300);
  REQUIRE(desk.operated.hold());
  desk.run(300);
  REQUIRE(desk.operated.jog({AxisVector(0, 0, 5), 50}));
  desk.run(500);
  const AxisVector there = desk.operated.position();
  REQUIRE(desk.operated.abort());
  CHECK(desk.operated.mode() == MachineMode::idle);
  CHECK(desk.operated.state().work[1].origin.x() == 7);
  CHECK(desk.operated.state().work[2].origin.x() == 0);  // that line was not reached
  REQUIRE(desk.operated.line("G91 G01 X1 F600\n"));
  desk.settle();
  CHECK((desk.operated.position() - there - AxisVector(1, 0, 0)).norm() < 1e-9);
  desk.check_limits();
}

TEST_CASE("the override of the spindle counts at once, except where a program forbids it",
          "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.line("S1000 M04\n"));
  desk.settle();
  const auto rpm = [&] { return desk.operated.outputs().spindle_rpm; };
  CHECK(rpm() == -1000);
  desk.operated.set_spindle_override(0.5);
  CHECK(rpm() == -500);
  desk.operated.set_spindle_override(3);
  CHECK(rpm() == -2000);
  REQUIRE(desk.operated.line("S20000\n"));
  desk.settle();
  CHECK(rpm() == -24'000);  // the fastest of the machine
  REQUIRE(desk.operated.line("M49 S1000 G01 X50 F1000\n"));
  desk.run(500);
  REQUIRE(desk.operated.moving());
  CHECK(rpm() == -1000);
  REQUIRE(desk.operated.line("M48 X100\n"));
  desk.settle();
  CHECK(rpm() == -2000);
  REQUIRE(desk.operated.start("G01 X5 F3000\n"));  // the override does not count twice
  desk.run(50);
  CHECK(rpm() == -2000);
}

TEST_CASE("switches of the operator count for the lines that have not been read",
          "[runtime][operator]") {
  std::string program = "G01 F1200\n";
  for (int i = 1; i <= 60; ++i)
    program += "/Y9\nX" + std::to_string(10 * i) + " Y" + std::to_string(3 * (i % 2)) + "\nM01\n";
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.start(program));
  desk.run(1000);
  desk.operated.set_block_skip(true);
  desk.run(900'000, [&] { return desk.operated.position().x() > 300; });
  double highest = 0;
  desk.run(2000, [&] {
    highest = std::max(highest, desk.operated.position().y());
    return false;
  });
  CHECK(highest < 4);
  desk.operated.set_optional_stop(true);
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::hold);
  desk.operated.set_optional_stop(false);
  desk.operated.set_single_block(true);
  const double x = desk.operated.position().x();
  int stops = 0;
  while (desk.operated.mode() == MachineMode::hold) {
    ++stops;
    REQUIRE(desk.operated.resume());
    desk.settle();
  }
  CHECK(x < 600);
  CHECK(stops > 3);
  CHECK(desk.operated.position().x() == 600);
}

TEST_CASE("docs/operating.md shows the table of states and requests", "[runtime][operator]") {
  std::string table = "| |";
  for (const auto name : kRequestNames) table += ' ' + std::string(name) + " |";
  table += "\n|";
  for (std::size_t i = 0; i <= kRequestNames.size(); ++i) table += "---|";
  for (std::size_t m = 0; m < kModeNames.size(); ++m) {
    table += "\n| " + std::string(kModeNames[m]) + " |";
    for (std::size_t r = 0; r < kRequestNames.size(); ++r) {
      const ModeRule rule = mode_rule(static_cast<MachineMode>(m), static_cast<Request>(r));
      const std::string_view next = kModeNames[static_cast<std::size_t>(rule.next)];
      table += rule.answer == ModeRule::Answer::acts      ? ' ' + std::string(next) + " |"
               : rule.answer == ModeRule::Answer::ignored ? " - |"
                                                          : " no |";
    }
  }
  CHECK(bytes_of(SOFTCNC_SOURCE_DIR "/docs/operating.md").find(table) != std::string::npos);
}

TEST_CASE("a single block that is asked for in motion pauses where the machine rests, not before",
          "[operator]") {
  const auto instant = GENERATE(20, 100, 300, 450, 700);  // periods
  Desk desk(BackendKind::none, 0);
  REQUIRE(
      desk.operated.start("G64 P0.5 F3000\nG01 X10\nX20\nY10\nX30 Y20\nX40\nX10\nX50 Y0\nX0\n"
                          "Y30\nX5\nX10\nM30\n"));
  desk.run(instant);
  desk.operated.set_single_block(true);
  int pauses = 0;
  for (; pauses < 20 && desk.operated.mode() != MachineMode::idle; ++pauses) {
    desk.run(100'000, [&] { return desk.operated.mode() != MachineMode::run; });
    if (desk.operated.mode() != MachineMode::hold) break;
    const auto rows = desk.places.size();
    REQUIRE(rows > 2);
    // From the last row the machine can brake within a period.
    const double speed = (desk.places[rows - 1] - desk.places[rows - 2]).norm() / 0.001;
    CHECK(speed <= 1000 * 2 * 0.001 * std::sqrt(2.0));
    REQUIRE(desk.operated.resume());
  }
  CHECK(pauses > 2);
  desk.check_limits();
}

TEST_CASE("what comes behind a rest that is planned changes nothing before it",
          "[runtime][operator]") {
  Machine machine = machine_to_operate(BackendKind::none, 0);
  machine.attendance.tool_change = {0, -80, 60};
  for (const double feed : {1000.0 / 60, 50.0})
    for (const AxisVector& step : {AxisVector(-1, 0, 0), AxisVector(0, 10, 0)})
      for (const int instant : {3, 20, 100}) {
        Desk desk(machine);
        CAPTURE(feed, step.transpose(), instant);
        REQUIRE(desk.operated.line("G00 X19 Y0 Z0\n"));
        desk.settle();
        REQUIRE(desk.operated.start("G21 G90 G94\nT1 M06\nM30\n"));
        desk.run(instant);
        REQUIRE(desk.operated.jog({step, feed}));
        desk.run(3000);
        CHECK((desk.operated.position() - AxisVector(0, -80, 60) - step).norm() < 1e-9);
        desk.check_limits();
      }
}
