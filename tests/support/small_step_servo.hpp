// SPDX-License-Identifier: MIT
// A second simulation of a servo axis, in steps of 5 us, that shares no code with the first.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/model/machine.hpp"

namespace softcnc::test {

/// Returns where the table of an axis is, mm, at each instant at which its counter is read and a
/// position of `commanded` (mm) has come, `period` s apart. It begins at rest in the first one,
/// with `backlash` mm of gap in front of it. The equations are those of docs/machine.md, by Euler's
/// method; the gap is that of the screw.
inline std::vector<double> small_step_table(const Axis& axis, double backlash, double period,
                                            const std::vector<double>& commanded) {
  constexpr double kTurn = 6.283185307179586, kStep = 5e-6;
  const Motor& m = axis.motor;
  const Drive& d = axis.drive;
  const double mm = axis.screw_lead / kTurn;  // per rad
  const int steps = static_cast<int>(std::lround(period / kStep));
  double i = 0, w = 0, measured = 0, sum = 0, angle = commanded.front() / mm;
  double table = commanded.front();
  std::vector<double> positions;
  for (const double sent : commanded) {
    positions.push_back(table);
    const double count = axis.screw_lead / axis.counts_per_rev;
    const double encoder = count * std::round(angle * axis.counts_per_rev / kTurn);
    const double command = d.kv * (axis.blu * std::round(sent / axis.blu) - encoder) / mm;
    for (int step = 0; step < steps; ++step) {
      const double error = command - measured;
      const double wanted = d.velocity_gain * (error + d.velocity_reset * sum);
      const double reach = m.resistance * d.current_limit, emf = m.emf_constant * w;
      const double u = std::clamp(std::clamp(wanted, emf - reach, emf + reach), -d.supply_voltage,
                                  d.supply_voltage);
      if (u == wanted) sum += kStep * error;
      i += kStep * (u - m.resistance * i - emf) / m.inductance;
      const double torque = m.torque_constant * i - m.viscous_friction * w;
      const bool sticks = w == 0 && std::abs(torque) <= m.coulomb_friction;
      const double friction = std::copysign(m.coulomb_friction, w != 0 ? w : torque);
      const double after = sticks ? 0 : w + kStep * (torque - friction) / m.inertia;
      w = w * after < 0 ? 0 : after;
      measured += kStep * (w - measured) / d.fv_time_constant;
      angle += kStep * w;
      table = std::clamp(table, angle * mm - backlash, angle * mm);
    }
  }
  return positions;
}

}  // namespace softcnc::test
