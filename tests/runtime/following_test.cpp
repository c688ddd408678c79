// SPDX-License-Identifier: MIT
// The table of the simulated mill, with commands that know its drives.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "ipo/limits/following_limits.hpp"
#include "runtime/session/session.hpp"
#include "runtime/session/simulate.hpp"
#include "support/files.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"

using namespace softcnc;
using namespace softcnc::runtime;

namespace {

/// A program of the folder with each F as this one.
std::string at_feed(const std::string& name, int feed) {
  std::string text = test::program_text(name), changed;
  for (std::size_t i = 0; i < text.size(); ++i) {
    changed += text[i];
    if (text[i] != 'F' || i + 1 == text.size() || std::isdigit(text[i + 1]) == 0) continue;
    changed += std::to_string(feed);
    while (i + 1 < text.size() && (std::isdigit(text[i + 1]) != 0 || text[i + 1] == '.')) ++i;
  }
  return changed;
}

constexpr const char* kFollowedCircle =
    "G21 G17 G90 G1 X50 F15000\nG3 X50 I-50\nG3 X50 I-50\nG2 X50 I-50\nG1 X0\nM30\n";
constexpr const char* kFollowedSquare =
    "G21 G17 G90 G64 P0.01 F6000\nG1 X50\nY50\nX0\nY0\nX50\nY50\nM30\n";

Machine following_mill(Follow follow, double jerk = 0) {
  Machine machine;
  machine.control.follow = follow;
  for (Axis& axis : machine.axes) axis.jerk = jerk;
  return machine;
}

/// The same with another machine in its place.
Machine with_plant(Machine machine, const std::function<void(Axis&)>& change) {
  machine.plant.given = true;
  machine.plant.axes = machine.axes;
  machine.plant.screws = machine.screws;
  for (Axis& axis : machine.plant.axes) change(axis);
  return machine;
}

struct Followed {
  double contour = 0;  // um, largest
  double time = 0;     // s
  std::array<double, kAxes> misfit{};
};

Followed follow(const std::string& text, const Machine& machine) {
  const auto backend = hal::open_backend(machine);
  Diagnostics diagnostics;
  ipr::Reader reader = ipr::Reader::from_text(text);
  const Outcome outcome =
      simulate(reader, -1, machine, {}, **backend, diagnostics, nullptr, nullptr);
  REQUIRE(diagnostics.errors() == 0);
  REQUIRE(outcome.contour);
  return {1e3 * outcome.contour->cutting.max, outcome.time, (*backend)->lag_misfit()};
}

}  // namespace

TEST_CASE("by its model the table is within one BLU of the path", "[runtime][following]") {
  const std::map<std::string, std::string> programs{
      {"butterfly", at_feed("08_butterfly.nc", 15000)},
      {"circle", kFollowedCircle},
      {"infinity", test::program_text("09_infinity.nc")},
      {"arcs", test::program_text("03_arc.nc")},
      {"square", kFollowedSquare}};
  for (const auto& [name, text] : programs)
    for (const double jerk : {0.0, 50'000.0}) {
      if (test::kSanitized && (name == "butterfly" || name == "infinity")) continue;
      const Followed followed = follow(text, following_mill(Follow::model, jerk));
      const Followed off = follow(text, following_mill(Follow::off, jerk > 0 ? jerk : 60'000));
      CAPTURE(name, jerk, followed.contour, off.contour, followed.time, off.time);
      CHECK(followed.contour <= 2.5);
      CHECK(off.contour > 50);
      // At 223 mm/s without a jerk limit the circle is beyond what commands leave of the velocity.
      CHECK(followed.time <= (name == "circle" && jerk == 0 ? 1.02 : 1.01) * off.time);
    }
}

TEST_CASE("a lead leaves a thirtieth of the error", "[runtime][following]") {
  const std::string butterfly = test::program_text("08_butterfly.nc");
  const double led = follow(butterfly, following_mill(Follow::lead)).contour;
  CHECK(led <= 25);
  CHECK(follow(butterfly, following_mill(Follow::off)).contour > 500);
}

TEST_CASE("a plant near the model is near the path", "[runtime][following]") {
  const std::string butterfly = at_feed("08_butterfly.nc", 15000);
  const auto contour = [&](const std::function<void(Axis&)>& change, Follow how = Follow::model) {
    return follow(butterfly, with_plant(following_mill(how), change));
  };
  for (const double part : {0.8, 1.2}) {
    CHECK(contour([&](Axis& axis) { axis.motor.inertia *= part; }).contour <= 12);
    CHECK(contour([&](Axis& axis) { axis.motor.resistance *= part; }).contour <= 12);
  }
  for (const double part : {0.5, 1.5})
    CHECK(contour([&](Axis& axis) { axis.motor.coulomb_friction *= part; }).contour <= 12);
  for (const double sign : {-1, 1})
    CHECK(contour([&](Axis& axis) {
            axis.motor.inertia *= 1 + sign * 0.2;
            axis.motor.resistance *= 1 + sign * 0.2;
            axis.motor.coulomb_friction *= 1 + sign * 0.5;
          }).contour <= 30);
  for (const double part : {0.95, 1.05}) {
    const auto other = [&](Axis& axis) { axis.drive.kv *= part; };
    const Followed followed = contour(other);
    CHECK(followed.contour <= 2 * contour(other, Follow::lead).contour);
    for (const int axis : {0, 1})
      CHECK(followed.misfit[static_cast<std::size_t>(axis)] == Approx(1 / part - 1).margin(0.006));
    CHECK(std::isnan(followed.misfit[2]));  // does not move
  }
}

TEST_CASE("opposite errors of two gains leave four times what equal ones leave",
          "[runtime][following]") {
  const std::string butterfly = at_feed("08_butterfly.nc", 15000);
  const auto left = [&](double x, double y) {
    Machine machine = with_plant(following_mill(Follow::model), [](Axis&) {});
    machine.plant.axes[0].drive.kv *= x;
    machine.plant.axes[1].drive.kv *= y;
    return follow(butterfly, machine).contour;
  };
  CHECK(left(1.003, 0.997) == Approx(18.5).epsilon(0.02));
  CHECK(left(1.01, 0.99) == Approx(61.5).epsilon(0.02));
  CHECK(left(0.95, 1.05) == Approx(311).epsilon(0.02));
  CHECK(left(1.003, 1.003) == Approx(4.3).epsilon(0.1));
}

TEST_CASE("paths that commands are ahead of leave room for them", "[runtime][following]") {
  Machine machine = following_mill(Follow::model);
  const Machine planned = ipo::planned_machine(machine);
  for (std::size_t i = 0; i < kAxes; ++i) {
    CHECK(planned.axes[i].jerk == 2 * machine.axes[i].acceleration * machine.axes[i].drive.kv);
    CHECK(planned.axes[i].acceleration == machine.axes[i].acceleration);
    // 3 A / 4 Kv = 25 mm/s, and twice a lag of 2.7 ms of the velocity loop
    CHECK(planned.axes[i].velocity == Approx(250 - 25 - 2 * 2.68).margin(0.1));
  }
  machine.axes[0].motor.torque_constant /= 4;  // a motor that cannot push 1000 mm/s^2
  CHECK(ipo::planned_machine(machine).axes[0].acceleration < 1000);
  machine.control.follow = Follow::off;
  CHECK(ipo::planned_machine(machine).axes[0].velocity == machine.axes[0].velocity);
  CHECK(ipo::planned_machine(machine).axes[0].jerk == 0);
}

TEST_CASE("a weak motor makes the plan slower, and the limit is its drive",
          "[runtime][following]") {
  for (const double jerk : {0.0, 50'000.0}) {
    Machine machine = following_mill(Follow::model, jerk);
    machine.axes[0].drive.current_limit = 3;  // A, of 16
    const auto backend = hal::open_backend(machine);
    Session session(machine, {}, **backend);
    REQUIRE(session.feed(kFollowedSquare));
    session.end();
    double current = 0;
    std::map<Limit, int> rows;
    const auto columns = (*backend)->columns();
    const auto at = std::ranges::find(columns, "x_current_a") - columns.begin();
    while (const auto step = session.step()) {
      ++rows[step->setpoint.limit];
      current = std::max(current, std::abs(step->values[static_cast<std::size_t>(at)]));
    }
    CAPTURE(jerk, current);
    CHECK(session.status() == SessionStatus::done);
    CHECK(rows[Limit::drive] > 10);
    CHECK(current <= 3);
    CHECK(session.contour()->cutting.max <= 5e-3);
    machine.axes[0].drive.current_limit = 16;
    CHECK_FALSE(ipo::planned_machine(machine).axes[0].drive_limits);
  }
}

/// SOFTCNC_FOLLOWED_PROGRAMS sets how many random programs are tried; 1000 take some minutes.
unsigned followed_programs() {
  const char* asked = std::getenv("SOFTCNC_FOLLOWED_PROGRAMS");
  return asked != nullptr ? static_cast<unsigned>(std::stoul(asked)) : 40 / test::kPart;
}

TEST_CASE("commands keep the velocity of their axes, whatever is asked", "[runtime][following]") {
  for (unsigned seed = 1; seed <= followed_programs(); ++seed) {
    std::mt19937 random(seed);
    Machine machine = seed % 3 == 0 ? test::random_machine(random) : Machine();
    machine.control.backend = BackendKind::sim;
    machine.control.follow = seed % 2 == 0 ? Follow::lead : Follow::model;
    const auto backend = hal::open_backend(machine);
    Session session(machine, {}, **backend);
    for (Block& block : test::random_program(random, 6)) session.feed(std::move(block));
    session.end();
    const auto columns = (*backend)->columns();
    std::array<std::size_t, kAxes> commands{};
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      commands[axis] = static_cast<std::size_t>(
          std::ranges::find(columns, std::string(1, "xyz"[axis]) + "_cmd_mm") - columns.begin());
    REQUIRE(std::ranges::all_of(commands, [&](std::size_t i) { return i < columns.size(); }));
    AxisVector before = AxisVector::Zero();
    double fastest = 0;
    for (int row = 0; session.status() == SessionStatus::running; ++row) {
      if (random() % 50 == 0) session.set_feed_override(static_cast<double>(random() % 201) / 100);
      if (random() % 80 == 0) session.hold();
      if (random() % 40 == 0) session.resume();
      const auto step = session.step();
      if (!step) break;
      const AxisVector command(step->values[commands[0]], step->values[commands[1]],
                               step->values[commands[2]]);
      for (int axis = 0; axis < kAxes && row > 0; ++axis)
        fastest =
            std::max(fastest, std::abs(command[axis] - before[axis]) / machine.control.period /
                                  machine.axes[static_cast<std::size_t>(axis)].velocity);
      before = command;
      if (row > (test::kSanitized ? 1'000 : 4'000)) break;
    }
    CAPTURE(seed, fastest);
    CHECK(fastest <= 1 + 1e-6);
    CHECK(session.status() != SessionStatus::alarm);
  }
}

TEST_CASE("backlash is made up for where the table follows", "[runtime][following]") {
  const std::string circle = "G21 G17 G90 G1 X50 F1000\nG3 X50 I-50\nG2 X50 I-50\nG1 X0\nM30\n";
  Machine machine = following_mill(Follow::model);
  for (Screw& screw : machine.screws) screw.backlash = 0.1;
  const double compensated = follow(circle, machine).contour;
  Machine unknown = following_mill(Follow::model);
  unknown.plant.given = true;
  unknown.plant.axes = unknown.axes;
  for (Screw& screw : unknown.plant.screws) screw.backlash = 0.1;
  const double uncompensated = follow(circle, unknown).contour;
  CAPTURE(compensated, uncompensated);
  CHECK(compensated <= 10);
  CHECK(uncompensated > 90);
}
