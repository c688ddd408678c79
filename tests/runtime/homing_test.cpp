// SPDX-License-Identifier: MIT
// Homing: from wherever the machine stands, and whatever it takes its position to be, the machine
// coordinates are those of its switches; and what is wrong with a switch ends it.
#include "runtime/operator/homing.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "support/operated.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::runtime;
using namespace softcnc::test;

namespace {

/// A machine with a switch at the upper end of X and Z and at the lower one of Y; Z comes first.
Machine with_switches(BackendKind backend, double jerk) {
  Machine machine = machine_to_operate(backend, jerk);
  const double ends[] = {195.3, -195.7, 95.1}, searches[] = {20, -30, 10};
  for (std::size_t i = 0; i < machine.axes.size(); ++i) {
    Axis& axis = machine.axes[i];
    axis.min = i == 2 ? -100 : -200;
    axis.max = -axis.min;
    axis.home = {searches[i], 0, 2, ends[i], i == 2 ? 1 : 2};
  }
  return machine;
}

/// Where the tables are, mm, as the commands count.
AxisVector measured(const Desk& desk) {
  const auto actual = desk.backend->actual();
  return actual.empty() ? desk.operated.position() : actual.back();
}

/// Moves to `place`, and lets the machine take it for another. Returns where the tables truly are.
AxisVector stand_unknown(Desk& desk, const AxisVector& place, const AxisVector& taken_for) {
  REQUIRE(desk.operated.jog({place - desk.operated.position(), 200}));
  desk.settle();
  REQUIRE(desk.operated.line("G04 P1\n"));  // the tables come to rest, too
  desk.settle();
  const AxisVector true_place = measured(desk);
  REQUIRE(desk.operated.set_position(taken_for));
  desk.places.clear();
  desk.periods.clear();
  return true_place;
}

/// The switches of a machine, the way a fault changes them: `level` says what an axis reads where
/// the true switch reads `closed` at `place`.
class FaultySwitches final : public hal::Backend {
 public:
  using Level = std::function<bool(int axis, double place, bool closed)>;
  FaultySwitches(const Machine& machine, Level level)
      : backend_(std::move(*hal::open_backend(machine))), level_(std::move(level)) {}

  Feedback exchange(const Setpoint& setpoint) noexcept override {
    Feedback feedback = backend_->exchange(setpoint);
    for (int axis = 0; axis < kAxes; ++axis) {
      bool& closed = feedback.home[static_cast<std::size_t>(axis)];
      closed = level_(axis, setpoint.position[axis], closed);
    }
    return feedback;
  }
  bool has_home_switches() const noexcept override { return true; }
  AxisVector settle() const noexcept override { return backend_->settle(); }

 private:
  std::unique_ptr<hal::Backend> backend_;
  Level level_;
};

/// Homes with such switches, which must fail, and returns why.
std::string failure_with(FaultySwitches::Level level, double farthest) {
  const Machine machine = with_switches(BackendKind::none, 0);
  Desk desk(machine, std::make_unique<FaultySwitches>(machine, std::move(level)));
  REQUIRE(desk.operated.home());
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::alarm);
  CHECK(desk.operated.knows_position());  // as before: nothing has been set
  REQUIRE(desk.errors == std::vector{Code::SC5090});
  for (const AxisVector& place : desk.places) CHECK(place.cwiseAbs().maxCoeff() <= farthest);
  desk.check_limits();
  return desk.messages.front();
}

}  // namespace

TEST_CASE("homing finds the machine coordinates from random starts to one BLU",
          "[runtime][homing][property]") {
  std::mt19937 engine(48);
  std::uniform_real_distribution<double> part(-0.9, 0.9);
  const auto random_place = [&] {
    return AxisVector(200 * part(engine), 200 * part(engine), 100 * part(engine));
  };
  for (int i = 0; i < 100 / kPart; ++i) {
    const BackendKind backend = i % 2 == 0 ? BackendKind::sim : BackendKind::none;
    Desk desk(with_switches(backend, i % 3 == 0 ? 20'000 : 0));
    const AxisVector place = random_place(), taken_for = random_place();
    CAPTURE(i, place.transpose(), taken_for.transpose());
    const AxisVector true_place = stand_unknown(desk, place, taken_for);
    REQUIRE(desk.operated.home());
    desk.run(900'000, [&] { return desk.operated.has_homed(); });
    REQUIRE(desk.operated.knows_position());
    CHECK(desk.errors.empty());
    desk.check_limits();
    const AxisVector expected =
        (backend == BackendKind::sim ? measured(desk) : desk.places.back()) + true_place -
        taken_for;
    for (int axis = 0; axis < kAxes; ++axis) {
      const Axis& of = desk.machine.axes[static_cast<std::size_t>(axis)];
      CHECK(std::abs(desk.operated.position()[axis] - expected[axis]) <= of.blu);
      const double rest = of.home.place - std::copysign(of.home.back_off, of.home.search);
      CHECK(desk.operated.position()[axis] == Approx(rest).margin(of.blu));
    }
    desk.settle();
    REQUIRE(desk.operated.mode() == MachineMode::idle);
    for (int axis = 0; axis < kAxes; ++axis)
      CHECK(desk.operated.position()[axis] ==
            desk.machine.axes[static_cast<std::size_t>(axis)].home.rest());
    desk.check_limits();
  }
}

TEST_CASE("axes are homed in their order, those of one number together", "[runtime][homing]") {
  Desk desk(with_switches(BackendKind::none, 0));
  REQUIRE(desk.operated.home());
  desk.settle();
  REQUIRE(desk.operated.mode() == MachineMode::idle);
  std::size_t z_last = 0, x_first = desk.rows(), y_first = desk.rows();
  for (std::size_t i = 1; i < desk.rows(); ++i) {
    const AxisVector way = desk.places[i] - desk.places[i - 1];
    if (way.z() != 0) z_last = i;
    if (way.x() != 0) x_first = std::min(x_first, i);
    if (way.y() != 0) y_first = std::min(y_first, i);
  }
  CHECK(x_first > z_last);
  CHECK(x_first == y_first);
}

TEST_CASE("after homing the ends of travel count, and lines move in machine coordinates",
          "[runtime][homing]") {
  Desk desk(with_switches(BackendKind::sim, 0));
  REQUIRE(desk.operated.start("G01 X100 F3000\nM30\n"));
  desk.run(500);
  desk.operated.estop();
  REQUIRE(desk.operated.set_position(AxisVector(-50, 20, 10)));  // somebody has looked badly
  REQUIRE(desk.operated.home());
  desk.settle();
  REQUIRE(desk.operated.line("G53 G00 X0 Y0 Z0\n"));
  desk.settle();
  CHECK(desk.operated.position().isZero(1e-9));
  CHECK_FALSE(desk.operated.jog({AxisVector(201, 0, 0), 50}));
  CHECK(desk.operated.jog({AxisVector(-199, 0, 0), 50}));
}

TEST_CASE("homing makes a position known only where every axis has a switch", "[runtime][homing]") {
  Machine machine = with_switches(BackendKind::none, 0);
  SECTION("all") {}
  SECTION("not Y") { machine.axes[1].home.search = 0; }
  const bool all = machine.axes[1].home.search != 0;
  Desk desk(machine);
  REQUIRE(desk.operated.start("G01 X100 Y7 F3000\nM30\n"));
  desk.run(500);
  desk.operated.estop();
  REQUIRE_FALSE(desk.operated.knows_position());
  const double y = desk.operated.position().y();
  REQUIRE(desk.operated.home());
  desk.settle();
  REQUIRE(desk.operated.mode() == MachineMode::idle);
  CHECK(desk.operated.knows_position() == all);
  CHECK(desk.operated.line("G04 P0.1\n").has_value() == all);
  if (!all) CHECK(desk.operated.position().y() == y);
}

TEST_CASE("a homing that is ended sets nothing", "[runtime][homing]") {
  const AxisVector taken_for(7, 8, 9);
  const auto end = GENERATE(as<std::optional<Request>>(), Request::hold, Request::cancel,
                            Request::abort, Request::reset, Request::door, std::nullopt);
  const bool is_estop = GENERATE(false, true);
  if (end && is_estop) return;  // a fault is the one or the other
  Desk desk(with_switches(BackendKind::none, 20'000));
  stand_unknown(desk, AxisVector(1, 2, 3), taken_for);
  REQUIRE(desk.operated.home());
  desk.run(15'000);
  REQUIRE(desk.operated.mode() == MachineMode::home);
  if (end) REQUIRE(ask(desk.operated, *end));
  if (!end && is_estop) desk.operated.estop();
  if (!end && !is_estop) desk.operated.limit_switch(0, 1);
  desk.run(1000);
  CHECK_FALSE(desk.operated.moving());
  CHECK(desk.operated.position() == desk.places.back());
  CHECK(desk.errors.empty());
  const MachineMode after = !end || end == Request::reset ? MachineMode::alarm
                            : end == Request::door        ? MachineMode::door
                                                          : MachineMode::idle;
  CHECK(desk.operated.mode() == after);
  if (is_estop) return;  // rows end without a ramp
  desk.check_limits();
}

TEST_CASE("a homing that has begun in Alarm and is ended leads back there", "[runtime][homing]") {
  Desk desk(with_switches(BackendKind::none, 0));
  REQUIRE(desk.operated.start("G01 X100 F3000\nM30\n"));
  desk.run(500);
  REQUIRE(desk.operated.reset());
  desk.settle();
  desk.run(500);
  REQUIRE(desk.operated.mode() == MachineMode::alarm);
  REQUIRE(desk.operated.home());
  desk.run(500);
  const bool door = GENERATE(false, true);
  REQUIRE((door ? desk.operated.door() : desk.operated.cancel()));
  desk.run(500);
  if (door) {
    desk.operated.door_closed();
    REQUIRE(desk.operated.resume());
  }
  CHECK(desk.operated.mode() == MachineMode::alarm);
  CHECK_FALSE(desk.operated.line("G04 P0.1\n"));
  REQUIRE(desk.operated.home());
  desk.settle();
  CHECK(desk.operated.mode() == MachineMode::idle);
}

TEST_CASE("a switch that is seen once a period is found as well", "[runtime][homing]") {
  Machine machine = with_switches(BackendKind::none, 0);
  machine.control.period = 0.01;
  for (Axis& axis : machine.axes) {
    axis.home.search = std::copysign(50, axis.home.search);
    axis.home.latch = 0.2;
  }
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> part(-1, 1);
  for (int i = 0; i < 8; ++i) {
    Desk desk(machine);
    const AxisVector place(part(engine), part(engine), part(engine));
    REQUIRE(desk.operated.jog({place, 50}));
    desk.settle();
    REQUIRE(desk.operated.home());
    desk.settle();
    CHECK(desk.messages.empty());
    CHECK(desk.operated.mode() == MachineMode::idle);
  }
}

TEST_CASE("homing needs switches, and a backend that reads them", "[runtime][homing]") {
  Machine none = with_switches(BackendKind::none, 0);
  for (Axis& axis : none.axes) axis.home.search = 0;
  Desk without(none);
  CHECK_FALSE(without.operated.home());
  Desk blind(with_switches(BackendKind::stepdir, 0));
  const Status refused = blind.operated.home();
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == Code::SC5080);
  CHECK(blind.operated.mode() == MachineMode::idle);
}

TEST_CASE("what is wrong with a home switch is an alarm with its name", "[runtime][homing]") {
  const auto of = [](int which, std::function<bool(double, bool)> level) {
    return [which, level](int axis, double place, bool closed) {
      return axis == which ? level(place, closed) : closed;
    };
  };
  CHECK(failure_with(of(1, [](double, bool) { return true; }), 0) ==
        "softcnc: error: the home switch of Y is closed already where homing begins [SC5090]\n");
  CHECK(failure_with(of(2, [](double, bool) { return false; }), 205) ==
        "softcnc: error: the home switch of Z has not closed over the whole travel [SC5090]\n");
  CHECK(failure_with(of(0, [](double, bool) { return false; }), 405) ==
        "softcnc: error: the home switch of X has not closed over the whole travel [SC5090]\n");
  // a cam that is shorter than the way to rest
  CHECK(failure_with(of(1, [](double y, bool) { return y < -100 && y > -100.2; }), 205) ==
        "softcnc: error: the home switch of Y has opened again where the axis came to rest beyond "
        "it [SC5090]\n");
  // a contact that sticks
  bool sticks = false;
  CHECK(failure_with(of(0, [&](double, bool closed) { return sticks = sticks || closed; }), 205) ==
        "softcnc: error: the home switch of X is still closed 2 mm away from where it closed "
        "[SC5090]\n");
  // a wire that breaks once the switch has opened
  int openings = 0;
  bool before = false;
  CHECK(failure_with(of(0,
                        [&](double, bool closed) {
                          openings += before && !closed ? 1 : 0;
                          before = closed;
                          return closed && openings == 0;
                        }),
                     205) ==
        "softcnc: error: the home switch of X has not closed again within 4 mm [SC5090]\n");
  // a loose switch
  CHECK(failure_with(of(2,
                        [&, loose = false](double z, bool closed) mutable {
                          loose = loose || closed;
                          return z >= (loose ? 93.6 : 95.1);
                        }),
                     205) ==
        "softcnc: error: the home switch of Z has closed at two places, 1.498 mm apart [SC5090]\n");
}

TEST_CASE("homing takes its time from speeds, reach and places", "[runtime][homing]") {
  Machine machine = with_switches(BackendKind::none, 0);
  for (std::size_t i = 1; i < 3; ++i) machine.axes[i].home.search = 0;
  machine.axes[0].home.latch = 1;
  Desk desk(machine);
  REQUIRE(desk.operated.home());
  desk.settle();
  // 195.3 mm at 20 mm/s and braking over 0.2 mm; back 2.2 mm; 2 mm at 1 mm/s; back 2 mm; 6 / Kv
  // behind each way back; the ramps of 20 ms
  const double expected = 195.3 / 20 + 2.2 / 20 + 2.0 / 1 + 2.0 / 20 + 2 * 6.0 / 30 + 0.1;
  CHECK(static_cast<double>(desk.rows()) * 1e-3 == Approx(expected).margin(0.05));
}
