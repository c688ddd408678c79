// SPDX-License-Identifier: MIT
// The figures of an axis with which the simulation goes as the axis went.
#pragma once

#include "motion/model/machine.hpp"
#include "runtime/identification/axis_figures.hpp"
#include "runtime/identification/servo_record.hpp"

namespace softcnc::runtime {

/// The result of a fit. A figure that the motion does not determine, or not to a half of its value,
/// has an infinite uncertainty.
struct AxisFit {
  AxisFigures figures;
  AxisFigures uncertainty;                  // twice the standard deviation of each
  double lag = 0, lag_uncertainty = 0;      // s: time constant of the velocity loop
  double delay = 0, delay_uncertainty = 0;  // s: by which the record is late
  double loop_period = 0;                   // s: how often the drive reads its counter
  double residual = 0;                      // mm, rms: what the fitted axis leaves
  double before = 0;                        // mm, rms: what the axis of the machine file leaves
  bool moved = false;                       // else nothing is known
};

/// Fits kv, torque and friction over inertia, and backlash of an axis to its record, and the delay
/// of the record, with the simulated axis itself as the model: a least-squares fit by Levenberg and
/// Marquardt, from several starts. What else the machine file says of the axis is taken as it is,
/// except where another `loop_period` leaves clearly less. Uncertainties come from the residuals in
/// blocks of a quarter of a second, which need not be independent within a block, and from the
/// rounding of counts. `period` and `loop_period` in s.
AxisFit fit_axis(const Axis& axis, const AxisRecord& record, double period, double loop_period);

}  // namespace softcnc::runtime
