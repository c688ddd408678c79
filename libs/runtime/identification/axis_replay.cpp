// SPDX-License-Identifier: MIT
#include "runtime/identification/axis_replay.hpp"

#include <algorithm>
#include <cmath>

#include "hal/backends/servo.hpp"
#include "hal/signals/fine_pulses.hpp"

namespace softcnc::runtime {
namespace {

/// Returns the cubic through four evenly spaced values at `part` of the way from b to c.
double between(double a, double b, double c, double d, double part) noexcept {
  const double before = part + 1, after = 1 - part, beyond = 2 - part;
  return -a * part * after * beyond / 6 + b * before * after * beyond / 2 +
         c * before * part * beyond / 2 - d * before * part * after / 6;
}

/// Returns the command at `part` of the period that ends with position i.
double command_at(std::span<const double> commanded, std::size_t i, double part) noexcept {
  const auto at = [commanded](std::size_t k) {
    return commanded[std::min(k, commanded.size() - 1)];
  };
  return between(at(i < 2 ? 0 : i - 2), at(i - 1), at(i), at(i + 1), part);
}

}  // namespace

MotorMotion replay_motor(const Axis& axis, double period, double loop_period,
                         std::span<const double> commanded) {
  MotorMotion motion;
  motion.parts = std::max(1, static_cast<int>(std::lround(period / loop_period)));
  if (commanded.empty()) return motion;
  motion.encoder.reserve(1 + (commanded.size() - 1) * static_cast<std::size_t>(motion.parts));
  motion.encoder.push_back(commanded[0]);
  hal::ServoAxis servo(axis, period / motion.parts);
  servo.reset(commanded[0]);
  hal::FinePulses fine(axis.blu, commanded[0]);
  std::vector<hal::CommandPulse> pulses;
  for (std::size_t i = 1; i < commanded.size(); ++i) {
    for (int part = 1; part <= motion.parts; ++part) {
      pulses.clear();
      const double target =
          part == motion.parts ? commanded[i]
                               : command_at(commanded, i, static_cast<double>(part) / motion.parts);
      fine.move(target, [&](double of_part, int direction) {
        pulses.push_back({of_part, direction});
      });
      servo.advance(pulses);
      motion.encoder.push_back(servo.position());
    }
  }
  return motion;
}

std::vector<double> replay_table(const MotorMotion& motor, const Gap& gap, double start,
                                 double delay) {
  if (motor.encoder.empty()) return {};
  const std::size_t last = motor.encoder.size() - 1;
  std::vector<double> fine{start};
  fine.reserve(last + 1);
  for (std::size_t i = 1; i <= last; ++i) {
    const double low = motor.encoder[i] - gap.ahead;
    const double high = std::max(low, motor.encoder[i] + gap.after);  // without a gap: rounding
    fine.push_back(std::clamp(fine.back(), low, high));
  }
  std::vector<double> table;
  const auto parts = static_cast<std::size_t>(motor.parts);
  table.reserve(last / parts + 1);
  for (std::size_t i = 0; i <= last; i += parts) {
    const double at =
        std::clamp(static_cast<double>(i) - delay * motor.parts, 0.0, static_cast<double>(last));
    const auto before = std::min(static_cast<std::size_t>(at), last == 0 ? 0 : last - 1);
    const std::size_t after = std::min(before + 1, last);
    table.push_back(fine[before] +
                    (at - static_cast<double>(before)) * (fine[after] - fine[before]));
  }
  return table;
}

}  // namespace softcnc::runtime
