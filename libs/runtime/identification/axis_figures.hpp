// SPDX-License-Identifier: MIT
// What positions tell of a servo axis, and the axis that has these figures.
#pragma once

#include <array>

#include "motion/model/machine.hpp"

namespace softcnc::runtime {

/// The figures of an axis that its positions determine. Positions tell ratios only: twice the
/// inertia with twice the torque moves alike.
struct AxisFigures {
  double kv = 0;                     // 1/s: gain of the position loop
  double torque_over_inertia = 0;    // mm/s^2 of the table per V at the motor, at rest
  double friction_over_inertia = 0;  // mm/s^2: by which Coulomb friction slows the table
  double backlash = 0;               // mm: lost motion between encoder and table
};

inline constexpr std::array<double AxisFigures::*, 4> kAxisFigures{
    &AxisFigures::kv, &AxisFigures::torque_over_inertia, &AxisFigures::friction_over_inertia,
    &AxisFigures::backlash};

/// Returns the figures of an axis as its machine file describes it.
AxisFigures figures_of(const Axis& axis) noexcept;

/// Returns the axis with other figures. Its inertia stays; resistance and friction of the motor
/// change.
Axis with_figures(Axis axis, const AxisFigures& figures) noexcept;

}  // namespace softcnc::runtime
