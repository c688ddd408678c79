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

std::vector<double> replay_axis(const Axis& axis, const Gap& gap, double period, double loop_period,
                                std::span<const double> commanded, double start) {
  std::vector<double> table;
  if (commanded.empty()) return table;
  table.reserve(commanded.size());
  table.push_back(start);
  const int parts = std::max(1, static_cast<int>(std::lround(period / loop_period)));
  hal::ServoAxis servo(axis, period / parts);
  servo.reset(commanded[0]);
  hal::FinePulses fine(axis.blu, commanded[0]);
  std::vector<hal::CommandPulse> pulses;
  for (std::size_t i = 1; i < commanded.size(); ++i) {
    for (int part = 1; part <= parts; ++part) {
      pulses.clear();
      const double target = part == parts
                                ? commanded[i]
                                : command_at(commanded, i, static_cast<double>(part) / parts);
      fine.move(target, [&](double of_part, int direction) {
        pulses.push_back({of_part, direction});
      });
      servo.advance(pulses);
    }
    const double encoder = servo.position();
    table.push_back(std::clamp(table.back(), encoder - gap.ahead, encoder + gap.after));
  }
  return table;
}

}  // namespace softcnc::runtime
