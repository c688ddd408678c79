// SPDX-License-Identifier: MIT
// The machine: plain data in internal units (mm, s, V, A, Nm, kg m^2). The defaults together are
// the retrofitted mill of paper 003 (Table 1), with a z axis of the same kind.
//
// Paper 003 names a "400 W class" DC servo motor of 3000 rpm without its maker. The motor here is
// the printed-armature DC servo motor BR13MACH of Pranshu Electricals (380 W, 1.20 Nm, 3000 rpm, 65
// V, 8 A; table of the B and BR series by its maker, http://pranshu.com/node/35). docs/machine.md
// shows how each figure that the table does not give was derived.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/axes.hpp"
#include "motion/geometry/spline.hpp"
#include "motion/model/attendance.hpp"  // IWYU pragma: export
#include "motion/model/contact.hpp"
#include "motion/model/machine_code.hpp"   // IWYU pragma: export
#include "motion/model/machine_ports.hpp"  // IWYU pragma: export
#include "motion/model/method.hpp"         // IWYU pragma: export
#include "motion/roughness/roughness_request.hpp"

namespace softcnc {

/// When the clocks of a method by pulses come: according to the feed profile, or as in paper 003.
enum class PulseClock : std::uint8_t { profile, paper };
inline constexpr std::array<std::string_view, 2> kPulseClockNames{"profile", "paper"};

/// Whether methods by pulses correct the time from clock to clock for the direction of the moves,
/// so that the feed along the path is about the same on all slopes.
enum class ConstantFeed : std::uint8_t { on, off };
inline constexpr std::array<std::string_view, 2> kConstantFeedNames{"on", "off"};

enum class BackendKind : std::uint8_t { none, sim, stepdir, parport, hal_stream };
inline constexpr std::array<std::string_view, 5> kBackendNames{"none", "sim", "stepdir", "parport",
                                                               "hal-stream"};
constexpr std::string_view name(BackendKind backend) noexcept {
  return kBackendNames[static_cast<std::size_t>(backend)];
}
/// Returns whether the setpoints of this backend move a machine outside softcnc.
constexpr bool moves_machine(BackendKind backend) noexcept {
  return backend == BackendKind::parport || backend == BackendKind::hal_stream;
}

/// What commands do about the lag of the drives: nothing, lead by one time an axis, or invert the
/// model of the machine file.
enum class Follow : std::uint8_t { off, lead, model };
inline constexpr std::array<std::string_view, 3> kFollowNames{"off", "lead", "model"};

/// Whether the lines of a curve that a program cut into them become a curve again.
enum class Rebuild : std::uint8_t { off, on };
inline constexpr std::array<std::string_view, 2> kRebuildNames{"off", "on"};

struct Control {
  double period = 0.001;           // s: one setpoint each
  double servo_period = 0;         // s: of fine interpolation; 0: see fine_period()
  double chord_tolerance = 0.001;  // mm
  Method interpolation = Method::arc_length;
  double corner_tolerance = 0.01;  // mm; 0: the path is followed exactly
  double smoothing_tolerance = 0;  // mm: where a program asks for smoothing; 0: corner_tolerance
  double contour_tolerance = 0;    // mm: what the drives may leave of the path; 0: not limited
  BackendKind backend = BackendKind::sim;
  PulseClock pulse_clock = PulseClock::profile;
  double acc_dec = 0;           // s: of acceleration after interpolation; 0: see acc_dec_time()
  double rough_period = 0.008;  // s: of rough interpolation by Method::two_step
  ConstantFeed constant_feed = ConstantFeed::on;
  Follow follow = Follow::off;
  Rebuild rebuild = Rebuild::on;
};

/// Returns whether the clocks of a move are equal parts of it, in whatever direction they lead: by
/// the clock of paper 003, and without constant feed.
constexpr bool has_equal_clocks(const Control& control) noexcept {
  return control.pulse_clock == PulseClock::paper || control.constant_feed == ConstantFeed::off;
}

/// Divides `whole` into equal parts, none longer than `longest`, s.
constexpr double equal_part(double whole, double longest) noexcept {
  constexpr double kRounding = 1e-9;  // of `longest`
  const double parts = whole / longest - kRounding;
  const auto fewer = static_cast<std::int64_t>(parts);
  return whole / static_cast<double>(parts > static_cast<double>(fewer) ? fewer + 1 : fewer);
}

/// Returns the time between positions sent to a port, s: the servo period or, if there is none, 1
/// ms or the next smaller value that divides the period. Limits are kept in samples this far apart,
/// and where x'' jumps the acceleration may change by the jerk times this, whatever the backend.
constexpr double fine_period(const Control& control) noexcept {
  constexpr double kLongest = 1e-3;
  return control.servo_period > 0 ? control.servo_period : equal_part(control.period, kLongest);
}

/// Returns how often the position loop of the simulated axes reads its counters, s: once a servo
/// period or, if there is none, every 0.25 ms or the next smaller value that divides fine_period().
constexpr double loop_period(const Control& control) noexcept {
  constexpr double kLongest = 0.25e-3;
  return control.servo_period > 0 ? control.servo_period
                                  : equal_part(fine_period(control), kLongest);
}

/// Returns how many equal parts of `part` s the period has.
constexpr int parts_of_period(const Control& control, double part) noexcept {
  return static_cast<int>(control.period / part + 0.5);
}

/// Limits along the path; 0: only the axes limit.
struct PathLimits {
  double feed = 250.0;      // mm/s; limits cutting moves
  double tangential = 0.0;  // mm/s^2: how the speed along the path may change
  double normal = 0.0;      // mm/s^2: v^2 / rho, in curves
};

/// A permanent-magnet DC motor with its load, reduced to the motor shaft.
struct Motor {
  double resistance = 1.5;           // ohm
  double inductance = 80e-6;         // H
  double torque_constant = 0.158;    // Nm/A
  double emf_constant = 0.1576;      // V s/rad
  double inertia = 6.1e-4;           // kg m^2: rotor, screw and table
  double viscous_friction = 1.4e-4;  // Nm s/rad
  double coulomb_friction = 0.18;    // Nm: motor, screw and guideways
};

/// The position loop (up/down counter), velocity loop (F/V converter) and amplifier.
struct Drive {
  double kv = 30.0;                 // 1/s: velocity per following error
  int counter_bits = 14;            // of the up/down counter
  double fv_time_constant = 0.001;  // s
  double velocity_gain = 2.0;       // V s/rad: V per rad/s of velocity error
  double velocity_reset = 50.0;     // 1/s: reset rate of the velocity loop's integral part
  double supply_voltage = 80.0;     // V
  double current_limit = 16.0;      // A
  double following_error = 12.0;    // mm: alarm above
  int lost_pulse = 0;               // every n-th command pulse is lost; 0: none
};

/// The home switch of an axis, and how it is found.
struct HomeSwitch {
  double search = 0;    // mm/s, negative towards smaller coordinates; 0: there is none
  double latch = 0;     // mm/s: where the place counts; 0: a BLU each period
  double back_off = 2;  // mm: away from the switch, before it is latched and at the end
  double place = 0;     // mm, machine coordinates: where it closes
  int order = 1;        // axes of the same number search together, smaller ones first

  /// Returns towards which end of the travel it lies: -1 or 1.
  double direction() const noexcept { return search < 0 ? -1 : 1; }
  /// Returns where the axis rests after homing, mm, machine coordinates.
  double rest() const noexcept { return place - direction() * back_off; }
};

struct Axis {
  bool present = true;
  double velocity = 250.0;       // mm/s
  double acceleration = 1000.0;  // mm/s^2
  double jerk = 0.0;             // mm/s^3; 0: no limit
  double min = -1000.0;          // mm
  double max = 1000.0;           // mm
  double blu = 0.0025;           // mm: basic length unit, one command pulse
  double screw_lead = 5.0;       // mm per revolution
  int counts_per_rev = 2000;     // of the encoder
  bool drive_limits = false;     // the acceleration is what the drive allows, not the axis
  Motor motor;
  Drive drive;
  HomeSwitch home;
};

/// Returns whether the machine has the axis, with a home switch.
inline bool has_home_switch(const Axis& axis) noexcept {
  return axis.present && axis.home.search != 0;
}

/// A place of a lead screw and how far the table is beyond it, mm: position and error.
struct PitchPoint {
  double position = 0;
  double error = 0;
};

/// How the table follows the screw: exactly, unless it says otherwise.
struct Screw {
  double backlash = 0;                  // mm: lost in negative direction after a reversal
  std::vector<PitchPoint> pitch_table;  // by position; linear in between, constant outside
};

inline bool has_errors(const Screw& screw) noexcept {
  return screw.backlash > 0 || !screw.pitch_table.empty();
}

struct Spindle {
  double min_rpm = 0;
  double max_rpm = 24000;
  double acceleration = 0;  // rpm/s; 0: it reaches any speed at once
};

/// What a length, or an argument of G65, without a decimal point counts in the fanuc and haas
/// dialects: units of G20 or G21, or the least input increments of these controls, 0.001 mm or
/// 0.0001 inch. Unstated: lengths units and arguments increments, with a warning.
enum class IntegerUnit : std::uint8_t { unstated, units, increments };
inline constexpr std::array<std::string_view, 3> kIntegerUnitNames{"unstated", "units",
                                                                   "increments"};

/// What the offsets D of the haas dialect are, as setting 40 of these controls decides. Unstated:
/// diameters, with a warning.
enum class CutterOffset : std::uint8_t { unstated, diameter, radius };
inline constexpr std::array<std::string_view, 3> kCutterOffsetNames{"unstated", "diameter",
                                                                    "radius"};

struct ProgramReading {
  int block_limit = 2'000'000;  // lines that one loop, or one call with all it calls, may run
  double motion_limit = 3.6e7;  // s: a program that moves for longer is refused; 0: no limit
  SplineParameter spline_parameter = SplineParameter::chord_length;  // of splines through points
  IntegerUnit integers = IntegerUnit::unstated;                      // of lengths without a point
  CutterOffset cutter_offsets = CutterOffset::unstated;              // in the haas dialect
  std::vector<std::string> path;  // folders of subprograms, after that of the program
  std::string path_base;          // from where they count; empty: from the working folder
};

struct Tool {
  double radius = 0;  // mm
  int teeth = 0;
  double length = 0;   // mm: how far it reaches below the control point, for simulated contacts
  std::string name{};  // for whoever puts it into the spindle
};

/// The material that the simulated surface is cut from, as a grid seen from above.
struct Stock {
  AxisVector size = AxisVector::Zero();  // mm; 0: as far as the program cuts
  std::vector<double>
      origin;  // mm: the corner with the smallest coordinates; empty: as far as the program cuts
  double grid = 0.01;  // mm between neighbouring points
};

/// The machine that is simulated where it is not the one that softcnc knows.
struct Plant {
  std::string file;                // as the machine names it; empty: none, or none by name
  bool given = false;              // otherwise the machine itself is simulated
  std::array<Axis, kAxes> axes{};  // present: those it has
  std::array<Screw, kAxes> screws{};
};

/// A touch probe, while no tool of the machine is in the spindle.
struct Probe {
  double radius = 0;  // mm: of its ball
};

struct Machine {
  std::string name = "retrofitted mill (built-in)";
  Control control;
  PathLimits limits;
  std::array<Axis, kAxes> axes;
  Spindle spindle;
  StepPort step_port;
  ParallelPort parallel_port;
  HalStream hal_stream;
  ProgramReading program;
  Surfacing surfacing;
  Stock stock;
  std::map<int, Tool> tools;
  Probe probe;
  Attendance attendance;
  std::map<std::string, ContactBody> contacts;  // by name: what a probe touches in simulation
  std::map<int, MachineCode> m_codes;           // by number: those of its builder or user
  OutputPorts outputs;
  InputPorts inputs;
  std::array<Screw, kAxes> screws;  // of the axes
  Plant plant;
};

/// Returns the time, s, over which methods that accelerate after interpolation average the
/// increments of an axis: control.acc_dec or, if there is none, the shortest time in which every
/// axis can go from rest to its largest velocity. No axis then exceeds its acceleration from rest
/// to any velocity, or back; it may do so in corners and reversals.
inline double acc_dec_time(const Machine& machine) noexcept {
  if (machine.control.acc_dec > 0) return machine.control.acc_dec;
  double longest = 0;
  for (const Axis& axis : machine.axes)
    if (axis.present) longest = std::max(longest, axis.velocity / axis.acceleration);
  return longest;
}

}  // namespace softcnc
