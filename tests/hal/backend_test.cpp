// SPDX-License-Identifier: MIT
// Backends: what they hand back, their columns, and the simulated mill as a whole.
#include "hal/backends/backend.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "hal/machine/machine_file.hpp"
#include "hal/signals/pulse_source.hpp"
#include "motion/pulses/counts.hpp"
#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::setpoint_at;

std::unique_ptr<Backend> opened(const Machine& machine) {
  auto backend = open_backend(machine);
  REQUIRE(backend);
  return std::move(*backend);
}

Machine retrofit() {
  Machine machine;
  machine.axes[2].present = false;
  return machine;
}

/// A move of `distance` at the axis limits: trapezoid or triangle.
double planned(const Axis& axis, double distance, double t) {
  const double ramp =
      std::min(axis.velocity / axis.acceleration, std::sqrt(distance / axis.acceleration));
  const double speed = axis.acceleration * ramp;
  const double duration = distance / speed + ramp;
  if (t < ramp) return axis.acceleration * t * t / 2;
  if (t < duration - ramp) return speed * (t - ramp / 2);
  const double left = std::max(0.0, duration - t);
  return distance - axis.acceleration * left * left / 2;
}

}  // namespace

TEST_CASE("without a backend the axes are where they are commanded", "[hal][backend]") {
  Machine machine;
  machine.control.backend = BackendKind::none;
  const auto backend = opened(machine);
  CHECK(backend->columns().empty());
  const Feedback feedback = backend->exchange(setpoint_at(1, 2, 3));
  CHECK(feedback.position == AxisVector(1, 2, 3));
  CHECK(feedback.alarm == Alarm::none);
  CHECK(backend->settle() == AxisVector(1, 2, 3));
  CHECK(std::isnan(backend->following_error_max()[0]));
}

TEST_CASE("the simulated mill names columns for the axes it has", "[hal][sim]") {
  const auto backend = opened(retrofit());
  const auto columns = backend->columns();
  CHECK(std::vector<std::string>(columns.begin(), columns.end()) ==
        std::vector<std::string>{"x_act_mm", "x_err_um", "x_current_a", "y_act_mm", "y_err_um",
                                 "y_current_a"});
}

TEST_CASE("the simulated loop reads its counters once a servo period", "[hal][sim]") {
  const auto after = [](double servo_period) {
    Machine machine = retrofit();
    machine.control.period = 0.008;
    machine.control.servo_period = servo_period;
    const auto mill = opened(machine);
    for (int i = 0; i <= 20; ++i)
      mill->exchange(setpoint_at(planned(machine.axes[0], 100, i * machine.control.period)));
    std::array<double, 6> values{};
    mill->values(values);
    return values[0];
  };
  const double every_8 = after(8e-3), every_1 = after(1e-3), every_quarter = after(0.25e-3);
  CHECK(after(0) == every_quarter);
  CHECK(every_8 < every_1);  // the longer it waits, the further it is behind
  CHECK(every_1 < every_quarter);
}

TEST_CASE("pulses follow the fine points of a setpoint", "[hal][sim]") {
  const Machine machine = retrofit();
  PulseSource source(0, machine);
  source.begin(0);
  const double blu = machine.axes[0].blu;
  const std::vector<FinePoint> points{{0, {4 * blu, 0, 0}}, {0, {5 * blu, 0, 0}}};
  Setpoint setpoint = setpoint_at(5 * blu);
  setpoint.fine = points;
  std::vector<double> parts;
  source.move(setpoint, [&](double part, int direction) {
    CHECK(direction == 1);
    parts.push_back(part);
  });
  REQUIRE(parts.size() == 5);
  for (int i = 0; i < 4; ++i)
    CHECK(parts[static_cast<std::size_t>(i)] == Approx((i + 0.5) / 4 / 2));
  CHECK(parts[4] == Approx(0.75));
}

TEST_CASE("the first setpoint says where the mill stands", "[hal][sim]") {
  const auto backend = opened(retrofit());
  const Feedback feedback = backend->exchange(setpoint_at(-12.3456, 7));
  CHECK(feedback.position[0] == Approx(-12.3456).epsilon(1e-15));
  CHECK(feedback.position[1] == Approx(7).epsilon(1e-15));
  std::array<double, 6> values{};
  backend->values(values);
  CHECK(std::abs(values[1]) < 1e-9);
  CHECK(backend->following_error_max()[0] < 1e-12);
}

TEST_CASE("the default mill runs at its limits without an alarm", "[hal][sim]") {
  const Machine machine;
  const auto backend = opened(machine);
  double largest_error = 0, largest_current = 0;
  std::array<double, 9> values{};
  for (int i = 0; i < 6000; ++i) {
    const double t = i * machine.control.period;
    const double x =
        t < 3 ? planned(machine.axes[0], 500, t) : 500 - planned(machine.axes[0], 500, t - 3);
    const Feedback feedback = backend->exchange(setpoint_at(x, -x, x / 3));
    REQUIRE(feedback.alarm == Alarm::none);
    backend->values(values);
    REQUIRE(values[0] == feedback.position[0]);
    REQUIRE(values[1] == Approx((x - values[0]) * 1000).margin(1e-9));
    largest_error = std::max(largest_error, std::abs(x - values[0]));
    largest_current = std::max(largest_current, std::abs(values[2]));
  }
  CHECK(backend->following_error_max()[0] == largest_error);
  CHECK(largest_error == Approx(250.0 / 30.0).epsilon(0.01));
  CHECK(largest_current < 8.0);  // rated current of the motor: it can do so all day
}

TEST_CASE("the machines by name run at their limits without an alarm", "[hal][sim]") {
  const std::string name = GENERATE("retrofit", "paper_004", "bench_mill");
  INFO(name);
  const auto machine =
      load_machine(std::string(SOFTCNC_SOURCE_DIR) + "/programs/machines/" + name + ".toml", {});
  REQUIRE(machine);
  const auto mill = opened(*machine);
  const Axis& axis = machine->axes[0];
  const double way = std::min(200.0, axis.max - axis.min);
  for (int i = 0; i * machine->control.period < 3.0; ++i) {
    const double x = planned(axis, way, i * machine->control.period);
    REQUIRE(mill->exchange(setpoint_at(x, x)).alarm == Alarm::none);
  }
  const Counts counts(axis.blu);
  CHECK(counts(mill->settle()[0]) == counts(way));
  CHECK(mill->following_error_max()[0] == Approx(axis.velocity / axis.drive.kv).epsilon(0.02));
}

TEST_CASE("the mill settles on the commanded counts and is left as it was", "[hal][sim]") {
  const double target = GENERATE(0.0025, 1.0, 33.3325, -87.6);
  const Machine machine = retrofit();
  const auto backend = opened(machine);
  const int periods = 700;
  for (int i = 0; i <= periods; ++i) {
    const double part = planned(machine.axes[0], std::abs(target), i * 0.001) / std::abs(target);
    backend->exchange(setpoint_at(target * std::min(part, 1.0), 0));
  }
  std::array<double, 6> before{}, after{};
  backend->values(before);
  const AxisVector settled = backend->settle();
  backend->values(after);
  CHECK(before == after);
  const Counts counts(machine.axes[0].blu);
  CHECK(counts(settled[0]) == counts(target));
  CHECK(counts(settled[1]) == 0);
  CHECK(backend->settle() == settled);
}

TEST_CASE("a jump of the command is an alarm that names its axis", "[hal][sim]") {
  const auto backend = opened(retrofit());
  backend->exchange(setpoint_at(0, 0));
  const Feedback feedback = backend->exchange(setpoint_at(0, 15));
  CHECK(feedback.alarm == Alarm::following_error);
  CHECK(feedback.alarm_axis == 1);
}

TEST_CASE("between setpoints the mill is led along the line in servo periods", "[hal][sim]") {
  // 8 ms given as one setpoint is 8 setpoints of 1 ms on the same line.
  Machine slow = retrofit();
  slow.control.period = 0.008;
  const auto coarse = opened(slow);
  const auto fine = opened(retrofit());
  coarse->exchange(setpoint_at(0, 0));
  fine->exchange(setpoint_at(0, 0));
  for (int i = 1; i <= 100; ++i) {
    Feedback expected;
    for (int k = 1; k <= 8; ++k)
      expected = fine->exchange(setpoint_at(0.1 * (i - 1 + k / 8.0), 0.05 * i));
    const Feedback feedback = coarse->exchange(setpoint_at(0.1 * i, 0));
    REQUIRE(feedback.position[0] == Approx(expected.position[0]).margin(1e-12));
  }
}

TEST_CASE("the same setpoints move the mill the same, bit for bit", "[hal][sim]") {
  const auto run = [] {
    const auto backend = opened(retrofit());
    AxisVector last;
    for (int i = 0; i < 3000; ++i)
      last = backend->exchange(setpoint_at(30 * std::sin(i * 0.004), 30 * std::cos(i * 0.004) - 30))
                 .position;
    return last;
  };
  CHECK(run() == run());
}

}  // namespace softcnc::hal
