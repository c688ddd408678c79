// SPDX-License-Identifier: MIT
// A servo axis against closed forms and against its differential equations, integrated finely.
#include "hal/backends/servo.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "support_hal.hpp"

namespace softcnc::hal {
namespace {

using test::kPeriod;
using test::largest_difference;

constexpr int kLoops = 4;  // of the servo in a period

/// The retrofitted mill's axis without friction that is not linear.
Axis smooth_axis() {
  Axis axis;
  axis.motor.coulomb_friction = 0;
  return axis;
}

/// The same axis as continuous equations: no counts, no substeps. Fourth-order Runge-Kutta.
class Reference {
 public:
  explicit Reference(const Axis& axis)
      : axis_(axis), mm_per_rad_(axis.screw_lead / 2 / std::numbers::pi) {}

  /// Follows command(t), in mm, from t = 0; returns the position (mm) every `every` seconds.
  std::vector<double> run(const std::function<double(double)>& command, double duration,
                          double every) {
    constexpr double kStep = 2e-6;
    std::vector<double> positions;
    State x{};
    const auto steps = static_cast<int>(std::lround(duration / kStep));
    const auto stride = static_cast<int>(std::lround(every / kStep));
    for (int i = 0; i <= steps; ++i) {
      if (i % stride == 0) positions.push_back(x[3] * mm_per_rad_);
      const double t = i * kStep;
      const State a = slope(x, command(t));
      const State b = slope(plus(x, a, kStep / 2), command(t + kStep / 2));
      const State c = slope(plus(x, b, kStep / 2), command(t + kStep / 2));
      const State d = slope(plus(x, c, kStep), command(t + kStep));
      for (std::size_t k = 0; k < x.size(); ++k)
        x[k] += kStep / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    }
    return positions;
  }

 private:
  using State = std::array<double, 5>;  // current, speed, measured speed, angle, integral

  static State plus(State x, const State& slope, double h) {
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += h * slope[k];
    return x;
  }

  State slope(const State& x, double command) const {
    const Motor& m = axis_.motor;
    const Drive& d = axis_.drive;
    const double wanted_speed = d.kv * (command / mm_per_rad_ - x[3]);
    const double error = wanted_speed - x[2];
    const double wanted = d.velocity_gain * (error + d.velocity_reset * x[4]);
    const double emf = m.emf_constant * x[1];
    const double reach = m.resistance * d.current_limit;
    const double voltage = std::clamp(std::clamp(wanted, emf - reach, emf + reach),
                                      -d.supply_voltage, d.supply_voltage);
    const double friction = std::tanh(x[1] / 1e-3) * m.coulomb_friction;
    return {(voltage - m.resistance * x[0] - emf) / m.inductance,
            (m.torque_constant * x[0] - m.viscous_friction * x[1] - friction) / m.inertia,
            (x[1] - x[2]) / d.fv_time_constant, x[1], voltage == wanted ? error : 0.0};
  }

  Axis axis_;
  double mm_per_rad_;
};

/// Led from place to place: within each servo period the pulses come evenly spread.
class Led : public ServoAxis {
 public:
  Led(const Axis& axis, double servo_period) : ServoAxis(axis, servo_period), counts_(axis.blu) {}

  void reset(double position) {
    told_ = counts_(position);
    ServoAxis::reset(position);
  }
  void advance(double position) {
    const std::int64_t from = std::exchange(told_, counts_(position));
    const std::int64_t n = std::abs(told_ - from);
    std::vector<CommandPulse> pulses;
    for (std::int64_t k = 1; k <= n; ++k)
      pulses.push_back({static_cast<double>(k) / static_cast<double>(n), told_ < from ? -1 : 1});
    ServoAxis::advance(pulses);
  }

 private:
  Counts counts_;
  std::int64_t told_ = 0;
};

/// The simulated axis at the end of each period, on an even way within it.
std::vector<double> simulate(const Axis& axis, const std::function<double(double)>& command,
                             double duration) {
  Led servo(axis, kPeriod / kLoops);
  servo.reset(command(0));
  std::vector<double> positions{servo.position()};
  const auto periods = static_cast<int>(std::lround(duration / kPeriod));
  for (int i = 1; i <= periods; ++i) {
    const double from = command((i - 1) * kPeriod), way = command(i * kPeriod) - from;
    for (int k = 1; k <= kLoops; ++k) servo.advance(from + way * k / kLoops);
    positions.push_back(servo.position());
  }
  return positions;
}

/// A step whose pulses come within the first period, as pulses must.
std::function<double(double)> step_of(double height) {
  return [height](double t) { return height * std::min(t / kPeriod, 1.0); };
}

}  // namespace

TEST_CASE("a step is answered as the differential equations say, to 1 %", "[hal][servo]") {
  const int counts = GENERATE(100, 120, 400, 4000);  // beyond 127 the current limit is reached
  INFO(counts << " counts");
  const Axis axis = smooth_axis();
  const double height = counts * axis.blu;
  const auto simulated = simulate(axis, step_of(height), 0.5);
  const auto expected = Reference(axis).run(step_of(height), 0.5, kPeriod);
  CHECK(largest_difference(simulated, expected) < 0.01 * height);
  CHECK(std::abs(simulated.back() - height) <= axis.blu);
}

TEST_CASE("a purely proportional velocity loop answers a step as its equations say",
          "[hal][servo]") {
  Axis axis = smooth_axis();
  axis.drive.velocity_reset = 0;
  const auto simulated = simulate(axis, step_of(0.3), 0.5);
  const auto expected = Reference(axis).run(step_of(0.3), 0.5, kPeriod);
  CHECK(largest_difference(simulated, expected) < 0.01 * 0.3);
}

TEST_CASE("on a ramp the settled following error is v / Kv, to 1 %", "[hal][servo]") {
  const double speed = GENERATE(7.5, 50.0, 250.0, -250.0);  // mm/s; 7.5 makes 100 counts
  INFO(speed << " mm/s");
  const Axis axis = smooth_axis();
  const auto ramp = [&](double t) {  // with a start that the motor can follow
    const double start = std::abs(speed) / axis.acceleration;
    const double sign = speed > 0 ? 1 : -1;
    return t < start ? sign * axis.acceleration * t * t / 2 : speed * (t - start / 2);
  };
  const auto positions = simulate(axis, ramp, 1.5);
  double mean = 0;
  constexpr std::size_t kLast = 100;
  for (std::size_t i = positions.size() - kLast; i < positions.size(); ++i)
    mean += (ramp(static_cast<double>(i) * kPeriod) - positions[i]) / kLast;
  CHECK(mean == Approx(speed / axis.drive.kv).epsilon(0.01));
}

TEST_CASE("a move under friction and limits is that of the differential equations",
          "[hal][servo]") {
  const Axis axis;  // with Coulomb friction
  const auto there_and_back = [](double t) { return 5.0 * (1 - std::cos(8.0 * t)); };
  const auto simulated = simulate(axis, there_and_back, 1.5);
  const auto expected = Reference(axis).run(there_and_back, 1.5, kPeriod);
  CHECK(largest_difference(simulated, expected) < 0.005);  // two counts of 20 mm
}

TEST_CASE("a blocked motor's current rises to u / R", "[hal][servo]") {
  Axis axis;
  axis.motor.coulomb_friction = 1e3;
  axis.motor.inductance = 3e-3;  // 2 ms
  axis.drive.velocity_reset = 0;
  const double voltage = 60 * axis.blu / axis.screw_lead * 2 * std::numbers::pi * axis.drive.kv *
                         axis.drive.velocity_gain;
  Led servo(axis, ServoAxis::kSubstep);
  servo.reset(0);
  servo.advance(60 * axis.blu);  // the pulses of this period are read in the next
  for (int i = 1; i < 40; ++i) {
    servo.advance(60 * axis.blu);
    const double t = i * ServoAxis::kSubstep;
    const double expected = voltage / axis.motor.resistance *
                            -std::expm1(-t * axis.motor.resistance / axis.motor.inductance);
    REQUIRE(servo.current() == Approx(expected).epsilon(1e-12));
  }
  CHECK(servo.position() == 0);
}

TEST_CASE("the current never exceeds its limit by more than one part in a hundred",
          "[hal][servo]") {
  Axis axis;
  axis.drive.following_error = 100;
  axis.drive.counter_bits = 20;
  Led servo(axis, kPeriod);
  servo.reset(0);
  double largest = 0;
  for (int i = 0; i < 2000; ++i) {
    servo.advance(i / 500 % 2 == 0 ? 50.0 : 0.0);
    largest = std::max(largest, std::abs(servo.current()));
  }
  CHECK(largest > 0.99 * axis.drive.current_limit);
  CHECK(largest < 1.01 * axis.drive.current_limit);
}

TEST_CASE("the supply voltage bounds the speed", "[hal][servo]") {
  Axis axis = smooth_axis();
  axis.motor.viscous_friction = 0;
  axis.drive.following_error = 1e4;
  axis.drive.counter_bits = 32;
  axis.drive.supply_voltage = 40;
  Led servo(axis, kPeriod);
  servo.reset(0);
  for (int i = 1; i <= 3000; ++i) servo.advance(0.4 * i);  // 400 mm/s
  const double top = 40 / axis.motor.emf_constant * axis.screw_lead / 2 / std::numbers::pi;
  CHECK(servo.velocity() == Approx(top).epsilon(1e-3));
}

TEST_CASE("a torque below the friction moves nothing", "[hal][servo]") {
  Axis axis;
  axis.drive.velocity_reset = 0;
  const double torque_per_count = axis.motor.torque_constant / axis.motor.resistance *
                                  axis.drive.velocity_gain * axis.drive.kv * axis.blu /
                                  axis.screw_lead * 2 * std::numbers::pi;
  const int enough = static_cast<int>(std::ceil(axis.motor.coulomb_friction / torque_per_count));
  const auto moved = [&](int counts) {
    return simulate(axis, step_of(counts * axis.blu), 1.0).back() > 0;
  };
  CHECK_FALSE(moved(enough - 1));
  CHECK(moved(enough));
}

TEST_CASE("the integral part carries the axis onto its count against friction", "[hal][servo]") {
  const int counts = GENERATE(1, 3, -7, 100);
  const Axis axis;
  const auto positions = simulate(axis, step_of(counts * axis.blu), 2.0);
  CHECK(std::abs(positions.back() - counts * axis.blu) <= 0.5 * axis.blu);
  CHECK(positions.back() == positions[positions.size() - 200]);  // and holds it there
}

TEST_CASE("an axis that holds its position does not creep", "[hal][servo]") {
  const Axis axis;
  const auto positions = simulate(
      axis, [](double) { return 0.0; }, 1.0);
  CHECK(positions.back() == 0);
}

TEST_CASE("both directions are alike", "[hal][servo]") {
  const Axis axis;
  const auto up = simulate(
      axis, [](double t) { return 3 * std::sin(9 * t); }, 1.0);
  const auto down = simulate(
      axis, [](double t) { return -3 * std::sin(9 * t); }, 1.0);
  for (std::size_t i = 0; i < up.size(); ++i) REQUIRE(std::abs(up[i] + down[i]) < axis.blu);
}

TEST_CASE("the loop reads its counter once a servo period", "[hal][servo]") {
  // When within a period its pulses come makes no difference.
  const Axis axis;
  ServoAxis early(axis, kPeriod), late(axis, kPeriod);
  early.reset(0);
  late.reset(0);
  for (int i = 0; i < 400; ++i) {
    const std::vector<CommandPulse> at_once(10, {0.1, 1}), at_end(10, {1.0, 1});
    early.advance(at_once);
    late.advance(at_end);
    REQUIRE(early.position() == late.position());
    REQUIRE(early.counter() == late.counter());
  }
  CHECK(early.position() > 1);
}

TEST_CASE("the counter overflows with an alarm", "[hal][servo]") {
  Axis axis;
  axis.drive.counter_bits = 8;  // -128 .. 127
  Led servo(axis, kPeriod);
  servo.reset(0);
  servo.advance(127 * axis.blu);
  CHECK(servo.alarm() == Alarm::none);
  servo.reset(0);
  servo.advance(128 * axis.blu);
  CHECK(servo.alarm() == Alarm::counter_overflow);
  CHECK(servo.counter() == 127);
  servo.reset(0);
  servo.advance(-128 * axis.blu);
  CHECK(servo.alarm() == Alarm::none);
  servo.reset(0);
  servo.advance(-129 * axis.blu);
  CHECK(servo.alarm() == Alarm::counter_overflow);
}

TEST_CASE("too large a following error is an alarm", "[hal][servo]") {
  Axis axis;
  axis.drive.following_error = 100 * axis.blu;
  Led servo(axis, kPeriod);
  servo.reset(5);
  servo.advance(5 + 100 * axis.blu);
  CHECK(servo.alarm() == Alarm::none);
  servo.reset(5);
  servo.advance(5 + 101 * axis.blu);
  CHECK(servo.alarm() == Alarm::following_error);
  servo.reset(5);
  CHECK(servo.alarm() == Alarm::none);
}

TEST_CASE("an encoder finer or coarser than the BLU is geared to it", "[hal][servo]") {
  const int counts_per_rev = GENERATE(500, 2000, 10000, 2048);
  Axis axis;
  axis.counts_per_rev = counts_per_rev;
  const auto positions = simulate(
      axis, [](double t) { return std::min(20 * t, 10.0); }, 1.5);
  const double resolution = std::max(axis.blu, axis.screw_lead / counts_per_rev);
  CHECK(std::abs(positions.back() - 10.0) <= 1.01 * resolution);
}

}  // namespace softcnc::hal
