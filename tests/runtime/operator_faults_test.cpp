// SPDX-License-Identifier: MIT
// What stops a machine: emergency stop, limit switch, door, reset; and what is possible afterwards.
#include <catch2/catch.hpp>
#include <set>
#include <sstream>
#include <string>

#include "support/files.hpp"
#include "support/folder.hpp"
#include "support/operated.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using namespace softcnc::test;

namespace {

constexpr std::string_view kCut = "S6000 M03 M08\nG01 X100 F3000\nM30\n";

}  // namespace

TEST_CASE("an emergency stop ends rows at once, and the position is not known",
          "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.start(kCut));
  desk.run(500);
  REQUIRE(desk.operated.moving());
  desk.operated.estop();
  CHECK(desk.operated.mode() == MachineMode::alarm);
  CHECK_FALSE(desk.operated.step());
  CHECK_FALSE(desk.operated.knows_position());
  CHECK(desk.operated.outputs() == Outputs());
  CHECK(desk.operated.state().position->in_motion);
  CHECK_FALSE(desk.operated.jog({AxisVector(1, 0, 0), 50}));
  REQUIRE(desk.operated.unlock());
  const Status refused = desk.operated.line("G01 X1 F600\n");
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == Code::SC5070);
  REQUIRE(desk.operated.jog({AxisVector(-2000, 0, 0), 100}));  // no end of travel counts
  desk.run(2000);
  CHECK(desk.operated.last().v == Approx(5));
  REQUIRE(desk.operated.cancel());
  desk.settle();
  REQUIRE(desk.operated.set_position(AxisVector(1, 2, 3)));
  CHECK(desk.operated.state().position == KeptPosition{AxisVector(1, 2, 3)});
  REQUIRE(desk.operated.line("G91 G01 X1 F600\n"));
  desk.settle();
  CHECK((desk.operated.position() - AxisVector(2, 2, 3)).norm() < 1e-9);
}

TEST_CASE("counters know the position after an emergency stop", "[runtime][operator]") {
  Desk desk(BackendKind::sim);
  REQUIRE(desk.operated.start(kCut));
  desk.run(500);
  const double commanded = desk.operated.position().x();
  desk.operated.estop();
  CHECK(desk.operated.knows_position());
  CHECK(desk.operated.position().x() < commanded);  // the servo lags
  CHECK(desk.operated.position().x() > commanded - 3);
  CHECK_FALSE(desk.operated.state().position->in_motion);
}

TEST_CASE("from a limit switch only a slow jog away from it leads", "[runtime][operator]") {
  Desk desk(BackendKind::none, 20'000);
  REQUIRE(desk.operated.start(kCut));
  desk.run(500);
  desk.operated.limit_switch(0, 1);
  CHECK(desk.operated.moving());  // it stops within the limits
  desk.run(1000);
  CHECK(desk.operated.mode() == MachineMode::alarm);
  CHECK(desk.operated.knows_position());
  CHECK_FALSE(desk.operated.unlock());
  CHECK_FALSE(desk.operated.jog({AxisVector(1, 0, 0), 50}));
  CHECK_FALSE(desk.operated.jog({AxisVector(-1, 1, 0), 50}));
  REQUIRE(desk.operated.jog({AxisVector(-2, 0, 0), 50}));
  desk.run(300);
  CHECK(desk.operated.last().v == Approx(5));
  desk.run(2000);
  CHECK(desk.operated.mode() == MachineMode::alarm);
  REQUIRE(desk.operated.unlock());
  REQUIRE(desk.operated.jog({AxisVector(1, 1, 0), 50}));
  desk.settle();
  desk.check_limits();
}

TEST_CASE("an open door stops and switches off, and resume waits for the spindle",
          "[runtime][operator]") {
  Desk desk(BackendKind::none);
  desk.machine.spindle.acceleration = 6000;
  Desk slow(desk.machine);
  REQUIRE(slow.operated.start(kCut));
  slow.run(1500);  // 1 s of them for the spindle
  CHECK(slow.operated.outputs().spindle_rpm == 6000);
  CHECK(slow.operated.outputs().flood);
  REQUIRE(slow.operated.door());
  CHECK(slow.operated.outputs() == Outputs());
  slow.run(500);
  CHECK_FALSE(slow.operated.moving());
  const double left = slow.operated.position().x();
  CHECK_FALSE(slow.operated.resume());
  slow.operated.door_closed();
  REQUIRE(slow.operated.resume());
  CHECK(slow.operated.outputs().spindle_rpm == 6000);
  slow.run(998);
  CHECK(slow.operated.position().x() == left);
  slow.run(20);
  CHECK(slow.operated.position().x() > left);
  slow.settle();
  CHECK(slow.operated.position().x() == Approx(100));
  CHECK(slow.operated.outputs() == Outputs());  // M30
  slow.check_limits();
}

TEST_CASE("a reset in motion stops within the limits and ends in Alarm", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.line("G91\nM03 S100\n"));
  desk.settle();
  CHECK(desk.operated.outputs().spindle_rpm == 100);
  REQUIRE(desk.operated.line("G01 X100 F3000\n"));
  desk.run(500);
  REQUIRE(desk.operated.reset());
  desk.run(500);
  CHECK(desk.operated.mode() == MachineMode::alarm);
  CHECK(desk.operated.knows_position());
  CHECK(desk.operated.outputs() == Outputs());
  REQUIRE(desk.operated.unlock());
  REQUIRE(desk.operated.line("G01 X5 F3000\n"));  // G90 again
  desk.settle();
  CHECK(desk.operated.position().x() == Approx(5));
  desk.check_limits();
}

TEST_CASE("lines are judged in Check, and nothing moves", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.check());
  REQUIRE(desk.operated.line("G91 G01 X600 F3000\n"));
  CHECK(desk.errors.empty());
  REQUIRE(desk.operated.line("X600\n"));  // the place of the line before counts
  CHECK(desk.errors == std::vector{Code::SC4001});
  REQUIRE(desk.operated.start("G01 X5\nM00\nG01 Q\n"));
  CHECK(desk.errors.size() > 1);
  CHECK(desk.rows() == 0);
  REQUIRE(desk.operated.check());
  CHECK(desk.operated.mode() == MachineMode::idle);
  CHECK(desk.operated.position().norm() == 0);
}

TEST_CASE("touch-off sets the active work system", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.line("G20 G55\n"));  // in inches
  desk.settle();
  REQUIRE(desk.operated.jog({AxisVector(10, 20, -5), 50}));
  desk.settle();
  REQUIRE(desk.operated.touch_off(0, 2.5));
  desk.settle();
  CHECK(desk.operated.state().work[1].origin.x() == Approx(7.5));
  CHECK(desk.operated.state().work[0].origin.x() == 0);
  CHECK_FALSE(desk.operated.touch_off(3, 1));
  REQUIRE(desk.operated.line("G21 G90 G01 X0 F600\n"));
  desk.settle();
  CHECK(desk.operated.position().x() == Approx(7.5));
}

TEST_CASE("an open door is not forgotten", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  desk.operated.estop();
  REQUIRE(desk.operated.door());
  REQUIRE(desk.operated.unlock());
  CHECK(desk.operated.mode() == MachineMode::door);
  CHECK_FALSE(desk.operated.line("G01 X1 F600\n"));
  desk.operated.door_closed();
  REQUIRE(desk.operated.resume());
  CHECK(desk.operated.mode() == MachineMode::idle);
}

TEST_CASE("nothing takes back an Alarm that is to come", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.line("G01 X100 F3000\n"));
  desk.run(500);
  desk.operated.limit_switch(0, 1);
  CHECK_FALSE(desk.operated.line("X0\n"));
  REQUIRE(desk.operated.abort());
  desk.run(1000);
  CHECK(desk.operated.mode() == MachineMode::alarm);
}

TEST_CASE("a hold of lines that are done holds nothing later", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  REQUIRE(desk.operated.line("G90\n"));
  REQUIRE(desk.operated.hold());
  desk.run(10);
  REQUIRE(desk.operated.mode() == MachineMode::hold);
  CHECK_FALSE(desk.operated.line("G01 X5 F600\n"));
  REQUIRE(desk.operated.resume());
  REQUIRE(desk.operated.line("G01 X5 F600\n"));
  desk.settle();
  CHECK(desk.operated.position().x() == Approx(5));
}

TEST_CASE("a position that is set makes no pulses", "[runtime][operator]") {
  const BackendKind kind = GENERATE(BackendKind::stepdir, BackendKind::sim);
  Desk desk(kind);
  REQUIRE(desk.operated.line("G01 X50 F3000\n"));
  desk.settle();
  REQUIRE(desk.operated.set_position(AxisVector(0, 0, 0)));
  REQUIRE(desk.operated.line("G01 X1 F600\n"));
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);  // and no alarm
  CHECK(desk.backend->settle().x() == Approx(1).margin(0.003));
}

TEST_CASE("what a request switches off is off for the backend, too", "[runtime][operator]") {
  const test::Folder folder;
  Machine machine = machine_to_operate(BackendKind::hal_stream, 0);
  machine.hal_stream.file = folder / "rows";
  machine.hal_stream.outputs = true;
  const auto request = GENERATE(0, 1, 2, 3, 4);
  CAPTURE(request);
  {
    Desk desk(machine);
    REQUIRE(desk.operated.start(kCut));
    desk.run(500);
    if (request == 0) REQUIRE(desk.operated.door());
    if (request == 1) REQUIRE(desk.operated.reset());
    if (request == 2) desk.operated.estop();
    if (request == 3) REQUIRE(desk.operated.abort());
    desk.run(500);
    if (request == 3) REQUIRE(desk.operated.sleep());
    REQUIRE(desk.backend->finish());
  }
  std::istringstream rows(bytes_of(folder / "rows"));
  std::string line, last;
  int on_behind_door = 0, number = 0;
  while (std::getline(rows, line)) {
    if (line.starts_with('#')) continue;
    last = line;
    if (request == 0 && ++number > 501 && !line.ends_with(" 0 0 0")) ++on_behind_door;
  }
  CHECK(last.ends_with(" 0 0 0"));
  CHECK(on_behind_door == 0);
}

TEST_CASE("a jog in Hold leaves the spindle at the speed that its override gives",
          "[runtime][operator]") {
  Desk desk(BackendKind::none);
  desk.operated.set_spindle_override(0.5);
  REQUIRE(desk.operated.start(kCut));
  const auto speeds = [&](int periods) {
    std::set<double> all;
    for (int i = 0; i < periods; ++i)
      if (const auto row = desk.operated.step()) all.insert(row->setpoint.outputs.spindle_rpm);
    return all;
  };
  desk.run(5);
  CHECK(speeds(500) == std::set<double>{3000});
  REQUIRE(desk.operated.hold());
  CHECK(speeds(500) == std::set<double>{3000});
  REQUIRE(desk.operated.jog({AxisVector(0, 2, 0), 50}));
  CHECK(speeds(500) == std::set<double>{3000});
  REQUIRE(desk.operated.resume());
  CHECK(speeds(600) == std::set<double>{3000});
}

TEST_CASE("coolant by hand stays until the program switches it", "[runtime][operator]") {
  Desk desk(BackendKind::none);
  desk.operated.set_coolant(false, true);
  CHECK(desk.operated.outputs().flood);
  REQUIRE(desk.operated.start("G21 G90\nG01 X10 F600\nM09\nX20\nM07\nX30\nM30\n"));
  desk.run(500);
  CHECK(desk.operated.outputs().flood);  // as it was
  desk.operated.set_coolant(true, false);
  desk.run(5);
  CHECK(desk.operated.outputs() == Outputs{0, true, false});
  CHECK(desk.operated.last().outputs.mist);
  desk.run(1500, [&] { return desk.operated.position().x() > 15; });
  CHECK(desk.operated.outputs() == Outputs{});
  desk.operated.set_coolant(true, true);
  desk.run(5);
  REQUIRE(desk.operated.hold());
  desk.run(500);
  CHECK(desk.operated.outputs() == Outputs{0, true, true});
  REQUIRE(desk.operated.door());
  desk.operated.set_coolant(true, true);  // not behind an open door
  CHECK(desk.operated.outputs() == Outputs{});
  desk.operated.door_closed();
  REQUIRE(desk.operated.resume());
  desk.run(20);
  CHECK(desk.operated.outputs() == Outputs{0, true, true});
  desk.settle();
  CHECK(desk.operated.has_completed());
}

TEST_CASE("in Hold the spindle stops by hand, and resume waits for its speed",
          "[runtime][operator]") {
  Machine machine = machine_to_operate(BackendKind::none, 0);
  machine.spindle.acceleration = 1000;
  Desk desk(machine);
  REQUIRE(desk.operated.start("G21 G90\nS1000 M03\nG01 X50 F600\nM30\n"));
  desk.run(2500);
  desk.operated.toggle_spindle();  // not in Run
  CHECK(desk.operated.outputs().spindle_rpm == 1000);
  REQUIRE(desk.operated.hold());
  desk.run(500);
  desk.operated.toggle_spindle();
  CHECK(desk.operated.outputs().spindle_rpm == 0);
  desk.operated.toggle_spindle();
  CHECK(desk.operated.outputs().spindle_rpm == 1000);
  desk.operated.toggle_spindle();
  const AxisVector held = desk.operated.position();
  REQUIRE(desk.operated.resume());
  CHECK(desk.operated.outputs().spindle_rpm == 1000);
  desk.run(900);
  CHECK(desk.operated.position() == held);  // it takes a second
  desk.run(500);
  CHECK(desk.operated.position().x() > held.x());
  desk.settle();
  CHECK(desk.operated.has_completed());
}
