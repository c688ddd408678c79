// SPDX-License-Identifier: MIT
// What leads from softcnc to a machine: step and direction lines, a parallel port, rows for HAL.
#pragma once

#include <array>
#include <string>

#include "motion/core/axes.hpp"

namespace softcnc {

/// Drives with step and direction inputs, and the timing that their inputs require.
struct StepPort {
  std::string file = "steps.vcd";  // of edges; empty: none
  double max_rate = 100e3;         // Hz: pulses of an axis
  double step_length = 2.5e-6;     // s
  double step_space = 2.5e-6;      // s
  double direction_setup = 5e-6;   // s
  double direction_hold = 5e-6;    // s
};

/// A PC's parallel port as step and direction lines, within the timing of StepPort. Pins are those
/// of the 25-pole plug; a negative one is inverted, 0 is none.
struct ParallelPort {
  std::string device = "/dev/parport0";  // empty: none
  double base_period = 50e-6;            // s between two writes to the port
  std::array<int, kAxes> step_pin{2, 4, 6}, direction_pin{3, 5, 7};
  int enable_pin = 8;       // out: high while it runs
  int charge_pump_pin = 9;  // out: toggles every base period while it runs
  int estop_pin = 10;       // in: high is pressed, so that a broken wire stops the machine, too
  int limit_pin = 0;        // in: high is an axis at the end of its travel
  int fault_pin = 0;        // in: high is a drive that has switched itself off
  std::array<int, kAxes> home_pin{};  // in: high is a home switch that is closed
  int probe_pin = 0;                  // in: high is a probe that touches
  int door_pin = 0;                   // in: high is an open door
  int spindle_pin = 0;                // out: high while the spindle turns
  int spindle_ccw_pin = 0;            // out: high while it turns counterclockwise
  int spindle_pwm_pin = 0;       // out: high for the part of the time that S is of spindle.max_rpm,
  int spindle_pwm_levels = 100;  // in cycles of so many base periods
  int mist_pin = 0, flood_pin = 0;  // out: high while on
};

/// Rows for LinuxCNC's halstreamer.
struct HalStream {
  std::string file = "setpoints.txt";  // or a FIFO; "-": standard output; empty: none
  double patience = 5.0;               // s: timeout for a blocked pipe
  bool outputs = false;                // rows have spindle, coolant and digital outputs, too
};

}  // namespace softcnc
