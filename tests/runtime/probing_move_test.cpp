// SPDX-License-Identifier: MIT
// Probing on a machine that reads its probe: the place of the contact, the stop behind it, and what
// programs make of either.
#include "runtime/operator/probing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>

#include "support/operated.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using namespace softcnc::test;

namespace {

constexpr double kRadius = 1.5;  // mm: of the ball

/// A plane whose upper face is at `top`, mm.
Machine with_plane(double top, double jerk = 0) {
  Machine machine = machine_to_operate(BackendKind::sim, jerk);
  machine.probe.radius = kRadius;
  machine.contacts["plane"] = {AxisVector(-1e4, -1e4, -1e4), AxisVector(1e4, 1e4, top)};
  return machine;
}

double variable(const Desk& desk, int number) {
  return desk.operated.memory().parameters.read(number).value_or(NAN);
}

/// Variables and modes of lines count once these have been run.
void run_lines(Desk& desk, const std::string& lines) {
  REQUIRE(desk.operated.line(lines));
  desk.settle();
}

}  // namespace

TEST_CASE("a contact is found to one BLU and what is moved in a servo period, from any direction",
          "[runtime][probing][property]") {
  std::mt19937 engine(49);
  std::uniform_real_distribution<double> part(0, 1);
  for (int i = 0; i < std::max(programs_asked(20) / kPart, 2); ++i) {
    const double top = -5 - 20 * part(engine), feed = 60 + 1500 * part(engine);
    Desk desk(with_plane(top, i % 2 == 0 ? 20'000 : 0));
    const double x = 4 * part(engine) - 2, y = 4 * part(engine) - 2, down = -40;
    CAPTURE(i, top, feed, x, y);
    run_lines(desk, "G91 G38.2 X" + std::to_string(x) + " Y" + std::to_string(y) + " Z" +
                        std::to_string(down) + " F" + std::to_string(feed) + "\n");
    CHECK(desk.errors.empty());
    REQUIRE(variable(desk, 5070) == 1);
    const double mm_s = feed / 60;
    const double near = desk.machine.axes[2].blu + mm_s * loop_period(desk.machine.control);
    CHECK(std::abs(variable(desk, 5063) - top) <= near);
    const double along = top / down;  // the part of the way
    CHECK(std::abs(variable(desk, 5061) - along * x) <= near);
    CHECK(std::abs(variable(desk, 5062) - along * y) <= near);
    const double lag = mm_s / desk.machine.axes[2].drive.kv;
    const double ramp = mm_s * mm_s / 2 / desk.machine.axes[2].acceleration;
    CHECK(desk.operated.position()[2] < top);
    CHECK(desk.operated.position()[2] > top - 2 * (lag + ramp) - 0.1);
    desk.check_limits();
  }
}

TEST_CASE("nothing behind a probing move is read before its contact", "[runtime][probing]") {
  Desk desk(with_plane(-12.345));
  REQUIRE(
      desk.operated.start("G21 G90 G94\nG38.2 Z-20 F300\n#1 = [#5063 + 2]\nG01 Z#1 F1000\n"
                          "X#5070\nM30\n"));
  desk.settle();
  CHECK(desk.errors.empty());
  CHECK(desk.operated.has_completed());
  CHECK(desk.operated.position()[2] == Approx(-10.345).margin(0.01));
  CHECK(desk.operated.position()[0] == Approx(1));
  desk.check_limits();
}

TEST_CASE("probing in a loop finds each contact", "[runtime][probing]") {
  Desk desk(with_plane(-3));
  REQUIRE(
      desk.operated.start("G21 G90 G94\n#2 = 0\no1 repeat [5]\nG00 Z0\nG00 X[#2 * 4]\n"
                          "G38.2 Z-20 F600\n#2 = [#2 + #5070]\no1 endrepeat\nG00 Z[#2]\nM30\n"));
  desk.settle();
  CHECK(desk.errors.empty());
  CHECK(desk.operated.position()[0] == Approx(16));
  CHECK(desk.operated.position()[2] == Approx(5));
  desk.check_limits();
}

TEST_CASE("a probe is left where it touches no more", "[runtime][probing]") {
  Desk desk(with_plane(-3));
  run_lines(desk, "G38.2 Z-20 F300\n");
  run_lines(desk, "G38.4 Z0 F30\n");
  CHECK(desk.errors.empty());
  CHECK(variable(desk, 5070) == 1);
  CHECK(variable(desk, 5063) == Approx(-3).margin(0.01));
  CHECK(desk.operated.position()[2] > -3);
}

TEST_CASE("what a probing move does not find is an error of its line, once it has been looked for",
          "[runtime][probing][code]") {
  Desk desk(with_plane(-30));
  const auto found = [&](const std::string& lines) {
    desk.errors.clear();
    desk.messages.clear();
    run_lines(desk, lines);
    return desk.errors;
  };
  CHECK(found("G91 G38.2 Z-10 F600\nG0 X50\n") == std::vector{Code::SC2394});
  CHECK(desk.messages.front().find("G91 G38.2 Z-10 F600\n") != std::string::npos);
  CHECK(desk.operated.position()[2] == Approx(-10));  // it has looked,
  CHECK(desk.operated.position()[0] == 0);            // and nothing follows
  CHECK(found("G91 G38.3 Z-10 F600\nG0 X2\n").empty());
  CHECK(variable(desk, 5070) == 0);
  CHECK(desk.operated.position()[0] == Approx(2));
  CHECK(found("G90 G38.3 Z-20 F600\n").empty());  // nowhere, and nothing
  CHECK(variable(desk, 5070) == 0);
  CHECK(found("G90 G38.5 Z-10 F600\n").empty());  // nothing touches, at once
  CHECK(variable(desk, 5070) == 1);
  CHECK(desk.operated.position()[2] == Approx(-20));
  CHECK(found("G90 G38.4 Z-25 F600\n") == std::vector{Code::SC2393});  // nothing touches
  CHECK(desk.operated.position()[2] == Approx(-20));
  CHECK(found("G90 G38.2 Z-40 F600\n").empty());
  const double rest = desk.operated.position()[2];
  CHECK(found("G90 G38.2 Z-45 F600\n") == std::vector{Code::SC2393});  // it touches
  CHECK(desk.operated.position()[2] == rest);
  CHECK(found("G90 G00 Z0\n").empty());
  desk.check_limits();
}

TEST_CASE("a probing move that is held goes on to its contact", "[runtime][probing]") {
  for (const bool jogs : {false, true}) {
    Desk desk(with_plane(-10));
    REQUIRE(desk.operated.line("G38.2 Z-20 F120\nG91 G01 Z1 F600\n"));
    desk.run(1500);
    REQUIRE(desk.operated.hold());
    desk.run(500);
    REQUIRE(desk.operated.mode() == MachineMode::hold);
    REQUIRE_FALSE(desk.operated.moving());
    const AxisVector held = desk.operated.position();
    CHECK(held[2] < -1);
    CHECK(held[2] > -9);
    if (jogs) {
      REQUIRE(desk.operated.jog({AxisVector(5, 0, 3), 20}));
      desk.run(2000);
    }
    REQUIRE(desk.operated.resume());
    desk.settle();
    CHECK(desk.errors.empty());
    CHECK(variable(desk, 5063) == Approx(-10).margin(0.005));
    CHECK(desk.operated.position()[2] == Approx(-9).margin(0.2));
    CHECK(desk.operated.position()[0] == Approx(0).margin(1e-9));
    desk.check_limits();
  }
}

TEST_CASE("a probing move that is aborted ends the program where the machine rests",
          "[runtime][probing]") {
  Desk desk(with_plane(-10));
  REQUIRE(desk.operated.start("G21 G90\nG38.2 Z-20 F120\nG00 X50\nM30\n"));
  desk.run(1500);
  REQUIRE(desk.operated.abort());
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);
  CHECK(desk.operated.position()[0] == 0);
  CHECK(desk.operated.position()[2] < -1);
  run_lines(desk, "G00 Z0\n");
  CHECK(desk.errors.empty());
  desk.check_limits();
}

TEST_CASE("wherever a probing move is held, it goes on to its contact or its end",
          "[runtime][probing]") {
  for (const double top : {-3.0, -30.0})
    for (int instant = 205; instant < 900; instant += 23) {
      CAPTURE(top, instant);
      Desk desk(with_plane(top));
      REQUIRE(desk.operated.start("G21 G90\nG38.3 Z-5 F1200\nG91 G00 X[3 + #5070] Y#5063\nM30\n"));
      desk.run(instant);
      if (desk.operated.mode() != MachineMode::run || desk.operated.position()[0] != 0) break;
      REQUIRE(desk.operated.hold());
      desk.run(400);
      REQUIRE(desk.operated.mode() == MachineMode::hold);
      REQUIRE(desk.operated.resume());
      desk.settle();
      CHECK(desk.errors.empty());
      CHECK(desk.operated.has_completed());
      CHECK(desk.operated.position()[0] == Approx(top == -3 ? 4 : 3));
      if (top == -3) CHECK(desk.operated.position()[1] == Approx(-3).margin(0.01));
      desk.check_limits();
    }
}

TEST_CASE("what a jog in Hold touches is no contact of the probing move", "[runtime][probing]") {
  Desk desk(with_plane(-10));
  REQUIRE(desk.operated.start("G21 G90\nG00 Z-8\nG38.2 X20 F300\nG00 X50\nM30\n"));
  desk.run(2500);
  REQUIRE(desk.operated.hold());
  desk.run(400);
  REQUIRE(desk.operated.jog({AxisVector(0, 0, -3), 20}));
  desk.run(1000);
  CHECK(desk.operated.position()[2] == Approx(-11));
  REQUIRE(desk.operated.resume());
  desk.settle();
  CHECK(desk.errors == std::vector{Code::SC2394});
  CHECK(desk.operated.position()[0] == Approx(20));
}

TEST_CASE("a probing move beyond the travel is an error of its line, and nothing follows",
          "[runtime][probing]") {
  for (const char* code : {"G38.2", "G38.3"}) {
    Desk desk(with_plane(-10));
    REQUIRE(desk.operated.start(std::string("G21 G90\nG00 X5\n") + code +
                                " X5000 F300\nG00 X50\nM30\n"));
    desk.settle();
    CHECK(desk.errors == std::vector{Code::SC4001});
    CHECK(desk.messages.front().find("softcnc:3:1: error: ") == 0);
    CHECK(desk.operated.position()[0] == Approx(5));
    CHECK_FALSE(desk.operated.has_completed());
  }
}

TEST_CASE("behind a door a probing move waits for the spindle", "[runtime][probing]") {
  Machine machine = with_plane(-10);
  machine.spindle.acceleration = 1000;
  Desk desk(machine);
  REQUIRE(desk.operated.start("G21 G90\nS1000 M03\nG38.2 Z-20 F120\nM05\nG00 X5\nM30\n"));
  desk.run(3000, [&] { return desk.operated.position()[2] < -2; });
  REQUIRE(desk.operated.door());
  desk.run(400);
  const AxisVector held = desk.operated.position();
  desk.operated.door_closed();
  REQUIRE(desk.operated.resume());
  desk.run(900);
  CHECK(desk.operated.position() == held);
  CHECK(desk.operated.outputs().spindle_rpm == 1000);
  desk.settle();
  CHECK(desk.errors.empty());
  CHECK(desk.operated.has_completed());
  CHECK(desk.operated.outputs() == Outputs{});
}

TEST_CASE("single block stops before a probing move and behind it", "[runtime][probing]") {
  Desk desk(with_plane(-10));
  desk.operated.set_single_block(true);
  REQUIRE(desk.operated.start("G21 G90\nG01 X2 F600\nG38.2 Z-20 F600\nG01 X3\nM30\n"));
  std::vector<double> x, z;
  for (int i = 0; i < 10 && desk.operated.mode() != MachineMode::idle; ++i) {
    desk.settle();
    x.push_back(desk.operated.position()[0]);
    z.push_back(std::round(desk.operated.position()[2]));
    if (desk.operated.mode() == MachineMode::hold) REQUIRE(desk.operated.resume());
  }
  CHECK(x.front() == Approx(2));
  CHECK(z.front() == 0);
  CHECK(x.back() == Approx(3));
  CHECK(std::count(z.begin(), z.end(), -10) >= 2);
  CHECK(x[1] == Approx(2));
  CHECK(z[1] == -10);
}
