// SPDX-License-Identifier: MIT
// Commands with which simulated axes go where they should, against closed forms.
#include "hal/signals/axis_following.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "hal/backends/servo.hpp"
#include "hal/signals/fine_pulses.hpp"
#include "motion/model/position_loop.hpp"
#include "support/property.hpp"

namespace softcnc::hal {
namespace {

constexpr double kLoop = 0.25e-3;  // s

/// Where an axis is asked to be, where its command is, and where a plant then goes; mm.
struct Followed {
  std::vector<double> asked, command, actual;

  /// Returns the largest |actual - asked| from `first` s on.
  double largest_error(double first = 0) const {
    double most = 0;
    for (auto i = static_cast<std::size_t>(first / kLoop); i < asked.size(); ++i)
      most = std::max(most, std::abs(actual[i] - asked[i]));
    return most;
  }
  /// Returns the largest speed of the command, mm/s.
  double fastest() const {
    double most = 0;
    for (std::size_t i = 1; i < command.size(); ++i)
      most = std::max(most, std::abs(command[i] - command[i - 1]) / kLoop);
    return most;
  }
};

Followed follow(const Axis& known, const Axis& plant, Follow how,
                const std::function<double(double)>& position, double duration) {
  AxisFollowing following(known, how, kLoop);
  ServoAxis servo(plant, kLoop);
  FinePulses fine(plant.blu, position(0));
  following.begin(position(0));
  servo.reset(position(0));
  Followed result{{position(0)}, {position(0)}, {position(0)}};
  std::vector<CommandPulse> pulses;
  for (int i = 1; i * kLoop <= duration; ++i) {
    const double asked = position(i * kLoop), command = following.move(asked, kLoop);
    pulses.clear();
    fine.move(command, [&](double part, int direction) { pulses.push_back({part, direction}); });
    servo.advance(pulses);
    result.asked.push_back(asked);
    result.command.push_back(command);
    result.actual.push_back(servo.position());
  }
  return result;
}

/// A move of 100 mm at 100 mm/s with ramps of bounded jerk: a quintic of time at either end.
double ramped(double t) {
  constexpr double kRamp = 0.2, kSpeed = 100;
  const auto ramp = [](double x) {  // the integral of 6x^5 - 15x^4 + 10x^3
    return x * x * x * x * (x * x - 3 * x + 2.5);
  };
  if (t < kRamp) return kSpeed * kRamp * ramp(t / kRamp);
  if (t < 1) return kSpeed * (kRamp / 2 + t - kRamp);
  if (t < 1 + kRamp) return 100 - kSpeed * kRamp * ramp((1 + kRamp - t) / kRamp);
  return 100;
}

/// A sine that begins and ends at rest, of the speed 200 mm/s and the acceleration 800 mm/s^2.
double swinging(double t) {
  constexpr double kW = 4;
  const double fade = std::clamp(t / 0.5, 0.0, 1.0);
  return 50 * std::sin(kW * t) * fade * fade * fade * (fade * (6 * fade - 15) + 10);
}

}  // namespace

TEST_CASE("an axis whose model is known goes where it should", "[hal][following]") {
  const Axis axis;
  for (const auto& motion : {ramped, swinging}) {
    const Followed followed = follow(axis, axis, Follow::model, motion, 2);
    CHECK(followed.largest_error() < axis.blu);
    CHECK(followed.fastest() <= axis.velocity * (1 + 1e-9));
  }
  CHECK(follow(axis, axis, Follow::off, ramped, 2).largest_error() ==
        Approx(100 / axis.drive.kv).epsilon(0.01));  // v / Kv
}

TEST_CASE("commands by the model differ with each part of it", "[hal][following]") {
  for (const int part : {0, 1, 2, 3}) {
    const Axis known;
    Axis plant = known;
    if (part == 0) plant.motor.inertia *= 1.2;
    if (part == 1) plant.motor.resistance *= 1.2;
    if (part == 2) plant.motor.coulomb_friction *= 1.5;
    if (part == 3) plant.drive.kv *= 1.02;
    CAPTURE(part);
    const double unknown = follow(known, plant, Follow::model, swinging, 2).largest_error();
    CHECK(unknown > 2 * known.blu);
    CHECK(follow(plant, plant, Follow::model, swinging, 2).largest_error() < known.blu);
  }
}

TEST_CASE("at rest the command is the position", "[hal][following]") {
  for (const Follow how : {Follow::off, Follow::lead, Follow::model}) {
    const Axis axis;
    const Followed followed = follow(axis, axis, how, ramped, 2.5);
    CHECK(followed.command.back() == 100);
    CHECK(followed.actual.back() == Approx(100).margin(1.5 * axis.blu));
  }
}

TEST_CASE("led axes cut circles as large as the closed form says", "[hal][following]") {
  Axis axis;
  axis.motor.coulomb_friction = 0;
  const double lead = lead_time(axis, kLoop);
  CHECK(lead > 0.03);
  CHECK(lead < 1 / axis.drive.kv);
  // To the second order |P| sqrt(1 + (w t)^2) is 1 where t^2 = 1/Kv^2 - 2 b / Kv. The speed is
  // b = R / (Kp Kt k) (B + Kt Ke / R) late behind a ramp of its command, with the reset rate k,
  // less the lag of the F/V converter, and half a period of the loop.
  const Motor& motor = axis.motor;
  const double b =
      motor.resistance /
          (axis.drive.velocity_gain * motor.torque_constant * axis.drive.velocity_reset) *
          (motor.viscous_friction + motor.torque_constant * motor.emf_constant / motor.resistance) -
      axis.drive.fv_time_constant + kLoop / 2;
  const double second = std::sqrt(1 / axis.drive.kv / axis.drive.kv - 2 * b / axis.drive.kv);
  CHECK(lead == Approx(second).epsilon(0.03));
  CHECK(lead < second);  // faster circles need less
  // A sine of each axis is what a circle asks of it.
  const Followed followed = follow(axis, axis, Follow::lead, swinging, 6);
  double largest = 0;
  for (std::size_t i = followed.actual.size() / 2; i < followed.actual.size(); ++i)
    largest = std::max(largest, followed.actual[i]);
  CHECK(largest == Approx(50).margin(0.013));
  const double unled = [&] {
    const Followed off = follow(axis, axis, Follow::off, swinging, 6);
    return *std::max_element(off.actual.begin() + 12'000, off.actual.end());
  }();
  CHECK(unled < 50 - 0.3);  // 50 (4/30)^2 / 2 = 0.44 mm smaller
}

TEST_CASE("commands are never faster than their axis", "[hal][following][property]") {
  softcnc::test::holds([] {
    const Axis axis;
    const double amplitude = softcnc::test::real(1, 40), w = softcnc::test::real(1, 40),
                 phase = softcnc::test::real(0, 6);
    const double part = std::min(1.0, axis.velocity / (amplitude * w));
    const auto swing = [&](double t) {
      return part * amplitude * (std::sin(w * t + phase) - std::sin(phase));
    };
    for (const Follow how : {Follow::lead, Follow::model})
      RC_ASSERT(follow(axis, axis, how, swing, 0.5).fastest() <= axis.velocity * (1 + 1e-9));
  });
}

}  // namespace softcnc::hal
