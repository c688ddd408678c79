// SPDX-License-Identifier: MIT
#include "motion/model/position_loop.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace softcnc {
namespace {

/// A circle: its angular speed, its radius, and the gain of the loop there.
struct CircularMotion {
  double w, radius, gain;
};

std::vector<CircularMotion> circular_motions(const Axis& axis, double loop_period) {
  constexpr int kMotions = 400;
  constexpr double kFastest = 10;  // times Kv: errors of faster circles are smaller
  const double slowest = axis.acceleration / axis.velocity;
  const double fastest = std::max(kFastest * axis.drive.kv, 2 * slowest);
  std::vector<CircularMotion> all;
  for (int i = 0; i <= kMotions; ++i) {
    const double w = slowest * std::pow(fastest / slowest, static_cast<double>(i) / kMotions);
    all.push_back({w, axis.acceleration / (w * w), position_gain(axis, loop_period, w)});
  }
  return all;
}

double largest_error(const std::vector<CircularMotion>& motions, double lead) noexcept {
  double most = 0;
  for (const CircularMotion& turn : motions)
    most = std::max(most, turn.radius * std::abs(turn.gain * std::hypot(1, turn.w * lead) - 1));
  return most;
}

}  // namespace

double position_gain(const Axis& axis, double loop_period, double w) {
  const Motor& motor = axis.motor;
  const Drive& drive = axis.drive;
  const std::complex<double> s(0, w);
  const auto plant = motor.torque_constant / ((motor.resistance + motor.inductance * s) *
                                                  (motor.inertia * s + motor.viscous_friction) +
                                              motor.torque_constant * motor.emf_constant);
  const auto forward = drive.velocity_gain * (1.0 + drive.velocity_reset / s) * plant;
  const auto velocity = forward / (1.0 + forward / (1.0 + drive.fv_time_constant * s)) *
                        std::exp(-s * loop_period / 2.0);
  return std::abs(drive.kv * velocity / (s + drive.kv * velocity));
}

double lead_time(const Axis& axis, double loop_period) {
  const std::vector<CircularMotion> all = circular_motions(axis, loop_period);
  double low = 0, high = 2 / axis.drive.kv;
  while (high - low > 1e-9 * high) {  // a largest of functions that fall and then rise
    const double third = (high - low) / 3;
    if (largest_error(all, low + third) < largest_error(all, high - third))
      high -= third;
    else
      low += third;
  }
  return (low + high) / 2;
}

}  // namespace softcnc
