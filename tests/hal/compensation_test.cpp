// SPDX-License-Identifier: MIT
// Backlash and pitch errors: of the simulated screw, and what the commands of backends make up for.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "hal/backends/backend.hpp"
#include "hal/backends/lead_screw.hpp"
#include "hal/signals/commands.hpp"
#include "hal/signals/edge_reader.hpp"
#include "hal/support_hal.hpp"
#include "motion/pulses/counts.hpp"

namespace softcnc::hal {
namespace {

using test::kPeriod;
using test::largest_difference;
using test::setpoint_at;

const std::vector<PitchPoint> kTable{{-100, 0.01}, {0, 0}, {20, 0.012}, {50, -0.006}};

/// Two axes, the first with a backlash, mm, and pitch errors.
Machine mill(double backlash, std::vector<PitchPoint> table = {}) {
  Machine machine;
  machine.axes[2].present = false;
  machine.screws[0] = {backlash, std::move(table)};
  return machine;
}

/// The same machine, whose plant has these errors on its first axis.
Machine on_plant(Machine machine, double backlash, std::vector<PitchPoint> table = {}) {
  machine.plant.given = true;
  machine.plant.axes = machine.axes;
  machine.plant.screws[0] = {backlash, std::move(table)};
  return machine;
}

/// A circle of 50 mm at 1000 mm/min, counter-clockwise from the right, and a quarter more; with a
/// ramp of the speed at 100 mm/s^2 before it.
AxisVector circle(double t) {
  constexpr double kRadius = 50, kSpeed = 1000.0 / 60, kRamp = kSpeed / 100;
  const double s = t < kRamp ? kSpeed * t * t / kRamp / 2 : kSpeed * (t - kRamp / 2);
  return {kRadius * std::cos(s / kRadius), kRadius * std::sin(s / kRadius), 0};
}

/// The first axis's table, mm, in each period of a run of `seconds`.
std::vector<double> tables(const Machine& machine, const std::function<AxisVector(double)>& path,
                           double seconds) {
  const auto backend = std::move(*open_backend(machine));
  std::vector<double> positions;
  for (int i = 0; i * kPeriod <= seconds; ++i)
    positions.push_back(backend->exchange(setpoint_at(path(i * kPeriod))).position[0]);
  return positions;
}

}  // namespace

TEST_CASE("pitch errors are linear in the table and constant outside", "[hal][screw]") {
  const PitchErrors errors(kTable);
  CHECK(errors(-1000) == 0.01);
  CHECK(errors(-50) == Approx(0.005));
  CHECK(errors(0) == 0);
  CHECK(errors(10) == Approx(0.006));
  CHECK(errors(35) == Approx(0.003));
  CHECK(errors(50) == -0.006);
  CHECK(errors(60) == -0.006);
  CHECK(PitchErrors({})(7) == 0);
}

TEST_CASE("a compensated pitch puts the table where it is to be", "[hal][screw]") {
  const PitchErrors errors(kTable), compensation = pitch_compensation(kTable);
  for (double p = -120; p < 80; p += 0.37) {
    const double q = p + compensation(p);
    CHECK(q + errors(q) == Approx(p).margin(1e-12));
  }
}

TEST_CASE("commands know how fast they have been", "[hal][screw]") {
  Commands commands(mill(0.1));
  commands(setpoint_at({0, 0, 0}));
  commands(setpoint_at({0.2, 0.2, 0}));
  CHECK(commands.velocity_max() == AxisVector(0.2 / kPeriod, 0, 0));
}

TEST_CASE("a table waits while its screw turns through the lost motion", "[hal][screw]") {
  LeadScrew screw({0.1, {}});
  screw.begin(5);
  CHECK(screw.table() == 5);
  screw.turn(6);
  CHECK(screw.table() == 6);
  screw.turn(5.95);
  CHECK(screw.table() == 6);
  screw.turn(5.9);
  CHECK(screw.table() == Approx(6));
  screw.turn(5);
  CHECK(screw.table() == Approx(5.1));
  screw.turn(5.05);
  CHECK(screw.table() == Approx(5.1));
  screw.turn(6);
  CHECK(screw.table() == 6);
}

TEST_CASE("a machine without errors of its screws sends its path", "[hal][screw]") {
  Commands commands(mill(0));
  CHECK_FALSE(commands.differ());
  const Setpoint setpoint = setpoint_at({1, 2, 3});
  CHECK(&commands(setpoint) == &setpoint);
  CHECK(commands.next_to_release() == nullptr);
}

TEST_CASE("backlash is added by a ramp of the axis's acceleration where the path leaves it",
          "[hal][screw]") {
  Axis axis;
  AxisCompensation compensation(axis, {0.1, {}});
  CHECK(compensation.begin(10) == 10);
  // Up by A, down by A/5: the speed w with w^2/2A + 5w^2/2A = B, and the time 6w/A.
  compensation.move(10 - 2e-5, kPeriod);
  int periods = 1;
  double last = 0, fastest = 0;
  for (; !compensation.is_complete() && periods < 1000; ++periods) {
    compensation.move(10 - 2e-5, kPeriod);
    fastest = std::max(fastest, std::abs(compensation.added() - last) / kPeriod);
    last = compensation.added();
  }
  CHECK(compensation.added() == -0.1);
  const double w = std::sqrt(0.1 * axis.acceleration / 3);
  CHECK(fastest == Approx(w).epsilon(0.1));
  CHECK(periods * kPeriod == Approx(6 * w / axis.acceleration).margin(4 * kPeriod));
}

TEST_CASE("a turn of less than a hundredth of a micrometre is none", "[hal][screw]") {
  AxisCompensation compensation(Axis{}, {0.1, {}});
  compensation.begin(0);
  for (int i = 0; i < 100; ++i) compensation.move(i % 2 ? 9e-6 : 0, kPeriod);
  CHECK(compensation.added() == 0);
  for (int i = 0; i < 100; ++i) compensation.move(-2e-5, kPeriod);
  CHECK(compensation.added() == -0.1);
}

TEST_CASE("commands are never faster than the axis, however the path moves", "[hal][screw]") {
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> target(-60, 60), part(0.05, 1);
  Axis axis;
  for (int run = 0; run < 50; ++run) {
    AxisCompensation compensation(axis, {0.3 * part(random), kTable});
    double position = 0, speed = 0, command = compensation.begin(0), command_speed = 0;
    for (int move = 0; move < 30; ++move) {
      const double goal = target(random), most = axis.velocity * part(random);
      for (int i = 0; i < 2000 && (std::abs(goal - position) > 1e-6 || speed != 0); ++i) {
        const double left = goal - position;
        const double wanted = std::copysign(
            std::min({most, std::sqrt(2 * 900 * std::abs(left)), std::abs(left) / kPeriod}), left);
        speed +=
            std::clamp(wanted - speed, -axis.acceleration * kPeriod, axis.acceleration * kPeriod);
        position += speed * kPeriod;
        const double next = compensation.move(position, kPeriod);
        const double next_speed = (next - command) / kPeriod;
        REQUIRE(std::abs(next_speed) <= axis.velocity * (1 + 1e-9));
        // What the pitch adds where its slope changes: 1.2 um/mm at most, at the full speed.
        REQUIRE(std::abs(next_speed - command_speed) / kPeriod <=
                1.2 * axis.acceleration + 1.2e-3 * axis.velocity / kPeriod + 2);
        command = next;
        command_speed = next_speed;
      }
    }
    for (int i = 0; i < 1000; ++i) compensation.move(position, kPeriod);
    CHECK(compensation.is_complete());
    compensation.release();
    for (int i = 0; i < 1000; ++i) compensation.move(position, kPeriod);
    CHECK(compensation.added() == pitch_compensation(kTable)(position));
  }
}

TEST_CASE("uncompensated backlash is a step of its height on a circle", "[hal][sim][screw]") {
  constexpr double kTime = 19;
  const auto clean = tables(mill(0), circle, kTime);
  const auto worn = tables(on_plant(mill(0), 0.1), circle, kTime);
  // The motors do the same: on the way back the table is late by the backlash, on the way up not.
  for (const int i : {3000, 9000})
    CHECK(worn[static_cast<std::size_t>(i)] - clean[static_cast<std::size_t>(i)] ==
          Approx(0.1).margin(1e-9));
  for (const int i : {12000, 18000})
    CHECK(worn[static_cast<std::size_t>(i)] == clean[static_cast<std::size_t>(i)]);
  CHECK(largest_difference(worn, clean) == Approx(0.1).margin(1e-9));
}

TEST_CASE("compensated backlash leaves less than its lag on a circle", "[hal][sim][screw]") {
  constexpr double kTime = 19, kBlu = 0.0025;
  const auto clean = tables(mill(0), circle, kTime);
  const auto equal = tables(mill(0.1), circle, kTime);
  CHECK(largest_difference(equal, clean) < 0.012);
  for (const int i : {3000, 5000, 9000, 12000, 15000, 18000})
    CHECK(std::abs(equal[static_cast<std::size_t>(i)] - clean[static_cast<std::size_t>(i)]) <=
          kBlu);
}

TEST_CASE("a compensated screw puts the table to the path where it rests", "[hal][sim][screw]") {
  Machine machine = on_plant(mill(0.08, kTable), 0.08, kTable);
  const auto backend = std::move(*open_backend(machine));
  double position = 0;
  backend->exchange(setpoint_at({position, 0, 0}));
  for (const double goal : {30.0, 12.0, 45.0, -20.0, -19.0}) {
    while (std::abs(goal - position) > 1e-9) {
      position += std::clamp(goal - position, -0.02, 0.02);
      backend->exchange(setpoint_at({position, 0, 0}));
    }
    for (int i = 0; i < 800; ++i) backend->exchange(setpoint_at({position, 0, 0}));
    INFO(goal);
    CHECK(std::abs(backend->settle()[0] - goal) <= machine.axes[0].blu);
  }
}

TEST_CASE("the loop does not see the errors of the screw", "[hal][sim][screw]") {
  const Machine machine = on_plant(mill(0), 0.1, kTable);
  const auto backend = std::move(*open_backend(machine));
  CHECK(std::vector<std::string>(backend->columns().begin(), backend->columns().end())[0] ==
        "x_act_mm");
  const Feedback first = backend->exchange(setpoint_at({20, 0, 0}));
  CHECK(first.position[0] == Approx(20.012));
  CHECK(backend->actual().back()[0] == Approx(20.012));
  CHECK(backend->settle()[0] == Approx(20.012));
}

TEST_CASE("backends with compensation have columns of what they send", "[hal][screw]") {
  Machine machine = mill(0.1);
  const auto names = [&](BackendKind kind) {
    machine.control.backend = kind;
    const auto backend = std::move(*open_backend(without_port(machine)));
    return std::vector<std::string>(backend->columns().begin(), backend->columns().end());
  };
  using test::Names;
  CHECK(names(BackendKind::sim) == Names{"x_cmd_mm", "x_act_mm", "x_err_um", "x_current_a",
                                         "y_cmd_mm", "y_act_mm", "y_err_um", "y_current_a"});
  CHECK(names(BackendKind::stepdir) == Names{"x_cmd_mm", "x_count", "y_cmd_mm", "y_count"});
  CHECK(names(BackendKind::hal_stream) == Names{"x_cmd_mm", "y_cmd_mm"});
}

TEST_CASE("pulses are the counts of the compensated commands, and end where programs begin",
          "[hal][stepdir][screw]") {
  const test::Folder folder;
  Machine machine = mill(0.05, kTable);
  machine.control.backend = BackendKind::stepdir;
  machine.step_port.file = folder / "steps.edges";
  const Counts counts(machine.axes[0].blu);
  const auto backend = std::move(*open_backend(machine));
  std::vector<double> values(backend->columns().size());
  double x = 0;
  backend->exchange(setpoint_at({x, 0, 0}));
  for (const double goal : {15.0, 4.0}) {
    while (std::abs(goal - x) > 1e-9) {
      x += std::clamp(goal - x, -0.05, 0.05);
      const Feedback feedback = backend->exchange(setpoint_at({x, 0, 0}));
      backend->values(values);
      REQUIRE(values[1] == static_cast<double>(counts(values[0])));
      REQUIRE(std::abs(feedback.position[0] - x) <= machine.axes[0].blu / 2 + 1e-9);
    }
    for (int i = 0; i < 100; ++i) backend->exchange(setpoint_at({x, 0, 0}));
  }
  backend->values(values);
  CHECK(values[0] == Approx(4 - 0.05 + pitch_compensation(kTable)(4)).margin(1e-12));
  REQUIRE(backend->finish());
  backend->values(values);
  CHECK(values[1] == static_cast<double>(counts(4 + pitch_compensation(kTable)(4))));
}

}  // namespace softcnc::hal
