// SPDX-License-Identifier: MIT
// The rows of the table of machine keys, and how a name finds its row.
#include "hal/machine/machine_keys.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <vector>

#include "hal/files/axis_name.hpp"
#include "motion/core/spelling.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr double s_from_us(double us) noexcept { return us / 1e6; }
constexpr double us_from_s(double s) noexcept { return s * 1e6; }

// Floors and ceilings. What is smaller than a floor is no property of a machine, but makes motions
// that last longer than any machine, or figures that are lost in rounding.
constexpr double kLeastRate = 1e-3;        // mm/min, mm/s^2, mm/s^3, 1/s, rpm
constexpr double kMostVelocity = 1e7;      // mm/min
constexpr double kMostAcceleration = 1e7;  // mm/s^2
constexpr double kMostJerk = 1e10;         // mm/s^3
constexpr double kLeastTolerance = 1e-3;   // um
constexpr double kMostTolerance = 1e6;     // um
constexpr double kLeastLength = 1e-3;      // mm, of tools and stocks
constexpr double kLeastElectrical = 1e-6;  // V, A, V s/rad

constexpr ValueRange at_least_0(double high) { return {0, high}; }
constexpr ValueRange kPinRange{-17, 17};
constexpr std::string_view kSwitchNames[] = {"off", "on"};
constexpr ValueRange rate(double high) { return {kLeastRate, high}; }
constexpr ValueRange rate_or_0(double high) { return {kLeastRate, high, true}; }
constexpr ValueRange length_or_0(double high) { return {kLeastLength, high, true}; }
constexpr ValueRange electrical(double high) { return {kLeastElectrical, high}; }

template <auto Part, auto Member>
auto& in_part(Machine& machine, int) {
  return machine.*Part.*Member;
}
template <auto Member>
auto& in_axis(Machine& machine, int axis) {
  return axis_at(machine, axis).*Member;
}
template <auto Part, auto Member>
auto& in_axis_part(Machine& machine, int axis) {
  return axis_at(machine, axis).*Part.*Member;
}
template <auto Member>
auto& in_screw(Machine& machine, int axis) {
  const bool of_plant = axis >= kAxes;
  auto& screws = of_plant ? machine.plant.screws : machine.screws;
  return screws[static_cast<std::size_t>(of_plant ? axis - kAxes : axis)].*Member;
}
template <auto Member>
auto& in_tool(Machine& machine, int number) {
  return machine.tools[number].*Member;
}
std::string& machine_name(Machine& machine, int) { return machine.name; }
std::vector<double>& stock_origin(Machine& machine, int) { return machine.stock.origin; }
std::vector<double>& tool_change_place(Machine& machine, int) {
  return machine.attendance.tool_change;
}
template <int axis>
double& stock_size(Machine& machine, int) {
  return machine.stock.size[axis];
}
std::string& edge_file(Machine& machine, int) { return machine.step_port.file; }
std::string& port_device(Machine& machine, int) { return machine.parallel_port.device; }
template <auto Member, std::size_t axis>
int& axis_pin(Machine& machine, int) {
  return (machine.parallel_port.*Member)[axis];
}
std::vector<std::string>& subprogram_folders(Machine& machine, int) { return machine.program.path; }
std::string& plant_file(Machine& machine, int) { return machine.plant.file; }
std::string& stream_file(Machine& machine, int) { return machine.hal_stream.file; }

template <auto Part, auto Member>
constexpr ChoiceKey choice_in(std::span<const std::string_view> words) {
  return {words, [](const Machine& m) { return static_cast<int>((m.*Part).*Member); },
          [](Machine& m, int i) {
            auto& place = (m.*Part).*Member;
            place = static_cast<std::remove_reference_t<decltype(place)>>(i);
          }};
}

template <auto Member>
constexpr auto motor = in_axis_part<&Axis::motor, Member>;
template <auto Member>
constexpr auto drive = in_axis_part<&Axis::drive, Member>;
template <auto Member>
constexpr auto home = in_axis_part<&Axis::home, Member>;
template <auto Member>
constexpr auto control = in_part<&Machine::control, Member>;
template <auto Member>
constexpr auto port = in_part<&Machine::parallel_port, Member>;
template <std::size_t axis>
constexpr auto step_pin = axis_pin<&ParallelPort::step_pin, axis>;
template <std::size_t axis>
constexpr auto direction_pin = axis_pin<&ParallelPort::direction_pin, axis>;
template <std::size_t axis>
constexpr auto home_pin = axis_pin<&ParallelPort::home_pin, axis>;
template <auto Member>
constexpr auto step_port = in_part<&Machine::step_port, Member>;

// clang-format off
const MachineKey kMachineKeys[] = {
    {"name", "", "name of the machine in reports; absent: the name of the file",
     TextKey{machine_name}},

    {"control.period_ms", "ms", "interpolation period: one setpoint each",
     NumberKey{control<&Control::period>, s_from_ms, ms_from_s, {0.001, 1000}}},
    {"control.servo_period_ms", "ms", "period of fine interpolation: positions sent to ports are the plan itself at these instants; where the curvature of the path jumps, "
     "the acceleration may change by the jerk limit times this period; the simulated axes read their counters once in it. It must divide period_ms. 0 or absent: 1 ms, or the next smaller period that divides period_ms, and 0.25 ms for the simulated axes",
     NumberKey{control<&Control::servo_period>, s_from_ms, ms_from_s, {0.001, 1000, true}}},
    {"control.chord_tolerance_um", "um", "largest distance between curve and chord within one period",
     NumberKey{control<&Control::chord_tolerance>, mm_from_um, um_from_mm, {kLeastTolerance, kMostTolerance}}},
    {"control.contour_tolerance_um", "um", "largest distance that the drives may leave between table and path (docs/following.md): corners rest until the lag is within it, and the speed is limited where the path is curved; 0: not limited",
     NumberKey{control<&Control::contour_tolerance>, mm_from_um, um_from_mm, {kLeastTolerance, kMostTolerance, true}}},
    {"control.interpolation", "", "how the next point on a curve is found",
     choice_in<&Machine::control, &Control::interpolation>(kMethodNames)},
    {"control.pulse_clock", "", "timing of the clocks of an interpolation by pulses: that of the feed profile, or that of paper 003",
     choice_in<&Machine::control, &Control::pulse_clock>(kPulseClockNames)},
    {"control.acc_dec_ms", "ms", "time over which methods that accelerate after interpolation average the increments of each axis; 0: the longest time that an axis needs from rest to its largest speed",
     NumberKey{control<&Control::acc_dec>, s_from_ms, ms_from_s, {0.001, 1e4, true}}},
    {"control.rough_period_ms", "ms", "period of the rough interpolation of two-step; period_ms must divide it",
     NumberKey{control<&Control::rough_period>, s_from_ms, ms_from_s, {0.001, 1000}}},
    {"control.follow", "", "what commands do about the lag of the drives (docs/following.md): nothing; lead: they are ahead of the path by one time an axis, of the least contour error; model: they are those with which the axes of this file go where they should",
     choice_in<&Machine::control, &Control::follow>(kFollowNames)},
    {"control.constant_feed", "", "whether an interpolation by pulses keeps the feed along the path on every slope: by the times of the profile, or by clocks that are dropped; off: a move for each clock, as paper 003 before its compensation",
     choice_in<&Machine::control, &Control::constant_feed>(kConstantFeedNames)},
    {"control.corner_tolerance_um", "um", "largest deviation of corners that G64 without P rounds; 0: the path is followed exactly",
     NumberKey{control<&Control::corner_tolerance>, mm_from_um, um_from_mm, {kLeastTolerance, kMostTolerance, true}}},
    {"control.smoothing_tolerance_um", "um", "the same between G05.1 Q1 and Q0 (fanuc) and after G187 with P and without E (haas); 0: these codes have no effect",
     NumberKey{control<&Control::smoothing_tolerance>, mm_from_um, um_from_mm, {kLeastTolerance, kMostTolerance, true}}},
    {"control.rebuild", "", "whether lines and arcs that a program cut a curve into become a curve again, within the tolerance of corners, where axes have jerk limits (docs/corners.md)",
     choice_in<&Machine::control, &Control::rebuild>(kRebuildNames)},
    {"control.backend", "", "where setpoints go: nowhere, to the simulated mill, to drives with step and direction inputs (a file of edges or a parallel port), or to a machine on LinuxCNC's HAL",
     choice_in<&Machine::control, &Control::backend>(kBackendNames)},

    {"limits.feed_mm_min", "mm/min", "limit of the speed of cutting moves along the path; 0, or absent in a file that names its axes: only the axes limit it. Where softcnc makes the pulses, at most the speed that they allow the fastest axis, which is also the default",
     NumberKey{in_part<&Machine::limits, &PathLimits::feed>, mm_s_from_mm_min, mm_min_from_mm_s, rate_or_0(kMostVelocity)}},
    {"limits.tangential_mm_s2", "mm/s^2", "limit of the acceleration along the path, also in rapids; 0: only the axes limit it",
     NumberKey{in_part<&Machine::limits, &PathLimits::tangential>, unconverted, unconverted, rate_or_0(kMostAcceleration)}},
    {"limits.normal_mm_s2", "mm/s^2", "limit of the acceleration across the path (speed squared over the radius of curvature), also in rapids; 0: only the axes limit it",
     NumberKey{in_part<&Machine::limits, &PathLimits::normal>, unconverted, unconverted, rate_or_0(kMostAcceleration)}},

    {"axis.*.velocity_mm_min", "mm/min", "largest speed of the axis",
     NumberKey{in_axis<&Axis::velocity>, mm_s_from_mm_min, mm_min_from_mm_s, rate(kMostVelocity)}},
    {"axis.*.acceleration_mm_s2", "mm/s^2", "largest acceleration of the axis",
     NumberKey{in_axis<&Axis::acceleration>, unconverted, unconverted, rate(kMostAcceleration)}},
    {"axis.*.jerk_mm_s3", "mm/s^3", "largest jerk of the axis; 0: no limit",
     NumberKey{in_axis<&Axis::jerk>, unconverted, unconverted, rate_or_0(kMostJerk)}},
    {"axis.*.min_mm", "mm", "lower end of travel, in machine coordinates",
     NumberKey{in_axis<&Axis::min>, unconverted, unconverted, {-1e5, 1e5}}},
    {"axis.*.max_mm", "mm", "upper end of travel, in machine coordinates",
     NumberKey{in_axis<&Axis::max>, unconverted, unconverted, {-1e5, 1e5}}},
    {"axis.*.blu_um", "um", "basic length unit: one command pulse",
     NumberKey{in_axis<&Axis::blu>, mm_from_um, um_from_mm, {0.001, 1e4}}},
    {"axis.*.screw_lead_mm", "mm", "travel per turn of the screw",
     NumberKey{in_axis<&Axis::screw_lead>, unconverted, unconverted, {0.01, 1000}}},
    {"axis.*.counts_per_rev", "", "encoder counts per turn of the motor, all edges",
     WholeKey{in_axis<&Axis::counts_per_rev>, {1, 1e8}}},
    {"axis.*.backlash_um", "um", "lost motion of the screw when it turns back: the commands of every backend make up for it, and the simulated table stays where it is while the screw turns through it",
     NumberKey{in_screw<&Screw::backlash>, mm_from_um, um_from_mm, at_least_0(1e4)}},
    {"axis.*.pitch_table", "", "errors of the screw as [position_mm, error_um] pairs: how far the table is beyond that position; linear between them, constant outside. The commands of every backend make up for them, and the simulated table has them",
     PairsKey{in_screw<&Screw::pitch_table>, mm_from_um, um_from_mm, {-1e5, 1e5}, {-1e4, 1e4}, 100, 0.1}},

    {"axis.*.motor.resistance_ohm", "ohm", "terminal resistance of the armature circuit",
     NumberKey{motor<&Motor::resistance>, unconverted, unconverted, {1e-3, 1e4}}},
    {"axis.*.motor.inductance_mh", "mH", "inductance of the armature circuit",
     NumberKey{motor<&Motor::inductance>, s_from_ms, ms_from_s, {1e-3, 1e4}}},
    {"axis.*.motor.torque_constant_nm_a", "Nm/A", "torque per current",
     NumberKey{motor<&Motor::torque_constant>, unconverted, unconverted, {1e-4, 1e3}}},
    {"axis.*.motor.emf_constant_v_s_rad", "V s/rad", "back-EMF per speed",
     NumberKey{motor<&Motor::emf_constant>, unconverted, unconverted, {1e-4, 1e3}}},
    {"axis.*.motor.inertia_kg_m2", "kg m^2", "rotor, coupling, screw and table, reduced to the motor shaft",
     NumberKey{motor<&Motor::inertia>, unconverted, unconverted, {1e-8, 1e3}}},
    {"axis.*.motor.viscous_friction_nm_s_rad", "Nm s/rad", "friction torque per speed",
     NumberKey{motor<&Motor::viscous_friction>, unconverted, unconverted, at_least_0(100)}},
    {"axis.*.motor.coulomb_friction_nm", "Nm", "friction torque of any motion; a motor torque below it does not move the axis",
     NumberKey{motor<&Motor::coulomb_friction>, unconverted, unconverted, at_least_0(1e4)}},

    {"axis.*.drive.kv_1_s", "1/s", "gain of the position loop: speed per following error",
     NumberKey{drive<&Drive::kv>, unconverted, unconverted, rate(1000)}},
    {"axis.*.drive.counter_bits", "", "width of the up/down counter, sign included; an overflow is an alarm",
     WholeKey{drive<&Drive::counter_bits>, {2, 32}}},
    {"axis.*.drive.fv_time_constant_ms", "ms", "lag of the frequency-to-voltage converter that measures the speed",
     NumberKey{drive<&Drive::fv_time_constant>, s_from_ms, ms_from_s, {0.01, 1000}}},
    {"axis.*.drive.velocity_gain_v_s_rad", "V s/rad", "motor voltage per speed error at the motor shaft",
     NumberKey{drive<&Drive::velocity_gain>, unconverted, unconverted, electrical(1e4)}},
    {"axis.*.drive.velocity_reset_1_s", "1/s", "reset rate of the integral part of the velocity loop; 0: proportional only",
     NumberKey{drive<&Drive::velocity_reset>, unconverted, unconverted, rate_or_0(1e4)}},
    {"axis.*.drive.supply_v", "V", "largest motor voltage, either way",
     NumberKey{drive<&Drive::supply_voltage>, unconverted, unconverted, electrical(1e4)}},
    {"axis.*.drive.current_limit_a", "A", "largest motor current, either way",
     NumberKey{drive<&Drive::current_limit>, unconverted, unconverted, electrical(1e4)}},
    {"axis.*.drive.following_error_um", "um", "a larger distance between command and axis is an alarm",
     NumberKey{drive<&Drive::following_error>, mm_from_um, um_from_mm, {kLeastTolerance, 1e8}}},
    {"axis.*.drive.lost_pulse", "", "for tests: every n-th command pulse is lost before the counter, which is an alarm; 0: none is lost",
     WholeKey{drive<&Drive::lost_pulse>, {0, 1e9}}},

    {"axis.*.home.search_mm_min", "mm/min", "speed at which the home switch is searched, negative towards smaller coordinates; 0: the axis has none (docs/homing.md)",
     NumberKey{home<&HomeSwitch::search>, mm_s_from_mm_min, mm_min_from_mm_s, {-kMostVelocity, kMostVelocity}}},
    {"axis.*.home.latch_mm_min", "mm/min", "speed at which the switch is approached once more, and its place counts; 0: one blu_um each control.period_ms",
     NumberKey{home<&HomeSwitch::latch>, mm_s_from_mm_min, mm_min_from_mm_s, rate_or_0(kMostVelocity)}},
    {"axis.*.home.back_off_mm", "mm", "how far the axis moves away from the switch before it is latched, and at the end",
     NumberKey{home<&HomeSwitch::back_off>, unconverted, unconverted, {0.01, 1000}}},
    {"axis.*.home.switch_mm", "mm", "where the switch closes, in machine coordinates",
     NumberKey{home<&HomeSwitch::place>, unconverted, unconverted, {-1e5, 1e5}}},
    {"axis.*.home.order", "", "axes of the same number are homed together, those with a smaller one before",
     WholeKey{home<&HomeSwitch::order>, {1, 9}}},

    {"spindle.min_rpm", "rpm", "a smaller S is clamped with a warning",
     NumberKey{in_part<&Machine::spindle, &Spindle::min_rpm>, unconverted, unconverted, rate_or_0(1e6)}},
    {"spindle.max_rpm", "rpm", "a larger S is clamped with a warning",
     NumberKey{in_part<&Machine::spindle, &Spindle::max_rpm>, unconverted, unconverted, rate_or_0(1e6)}},
    {"spindle.acceleration_rpm_s", "rpm/s", "after M03, M04 and S the next cutting move waits at rest until the spindle has reached its speed; 0: at once",
     NumberKey{in_part<&Machine::spindle, &Spindle::acceleration>, unconverted, unconverted, rate_or_0(1e7)}},

    {"surface.model", "", "model that keeps the roughness a program asks for: cutting edges simulated on the ball, or the formulas of paper 004",
     choice_in<&Machine::surfacing, &Surfacing::model>(kRoughnessModels)},
    {"surface.phase", "", "phase between the cutting edges of neighbouring passes in the simulated surface: aligned as in the paper, or by time",
     choice_in<&Machine::surfacing, &Surfacing::phase>(kSpindlePhases)},

    {"backend.sim.plant", "", "machine file whose axes are simulated instead of those of the machine, in the folder of the machine file; empty: none",
     TextKey{plant_file}},

    {"backend.stepdir.file", "", "file for the edges of the step and direction lines: .vcd or .edges; empty: none",
     TextKey{edge_file}},
    {"backend.stepdir.max_rate_hz", "Hz", "largest pulse rate of an axis, and of the clocks where interpolation is by pulses",
     NumberKey{step_port<&StepPort::max_rate>, unconverted, unconverted, {1, 1e7}}},
    {"backend.stepdir.step_length_ns", "ns", "time for which a step line stays high",
     NumberKey{step_port<&StepPort::step_length>, s_from_ns, ns_from_s, {1, 1e8}}},
    {"backend.stepdir.step_space_ns", "ns", "least time for which a step line stays low",
     NumberKey{step_port<&StepPort::step_space>, s_from_ns, ns_from_s, {1, 1e8}}},
    {"backend.stepdir.direction_setup_ns", "ns", "least time from a change of direction to the next step",
     NumberKey{step_port<&StepPort::direction_setup>, s_from_ns, ns_from_s, at_least_0(1e8)}},
    {"backend.stepdir.direction_hold_ns", "ns", "least time from the end of a step to a change of direction",
     NumberKey{step_port<&StepPort::direction_hold>, s_from_ns, ns_from_s, at_least_0(1e8)}},

    {"backend.parport.device", "", "the parallel port; empty: pulses are counted and not sent",
     TextKey{port_device}},
    {"backend.parport.base_period_us", "us", "time between two writes to the port; a step takes at least two",
     NumberKey{port<&ParallelPort::base_period>, s_from_us, us_from_s, {1, 1e6}}},
    {"backend.parport.x_step_pin", "", "pin of the step line, 2 to 9; negative: inverted, 0: none. Timing is that of backend.stepdir",
     WholeKey{step_pin<0>, kPinRange}},
    {"backend.parport.x_direction_pin", "", "pin of the direction line, likewise; high is negative direction",
     WholeKey{direction_pin<0>, kPinRange}},
    {"backend.parport.y_step_pin", "", "the same for Y", WholeKey{step_pin<1>, kPinRange}},
    {"backend.parport.y_direction_pin", "", "the same for Y", WholeKey{direction_pin<1>, kPinRange}},
    {"backend.parport.z_step_pin", "", "the same for Z", WholeKey{step_pin<2>, kPinRange}},
    {"backend.parport.z_direction_pin", "", "the same for Z", WholeKey{direction_pin<2>, kPinRange}},
    {"backend.parport.enable_pin", "", "output, high while the drives are enabled: 1 to 9, 14, 16, 17; negative: inverted, 0: none",
     WholeKey{port<&ParallelPort::enable_pin>, kPinRange}},
    {"backend.parport.charge_pump_pin", "", "output that toggles every base period as long as softcnc runs, numbered likewise",
     WholeKey{port<&ParallelPort::charge_pump_pin>, kPinRange}},
    {"backend.parport.estop_pin", "", "input of the emergency stop, high is pressed: 10 to 13, 15; negative: low is pressed, 0: none",
     WholeKey{port<&ParallelPort::estop_pin>, kPinRange}},
    {"backend.parport.limit_pin", "", "input of the limit switches, likewise",
     WholeKey{port<&ParallelPort::limit_pin>, kPinRange}},
    {"backend.parport.fault_pin", "", "input of the drives' fault line, likewise",
     WholeKey{port<&ParallelPort::fault_pin>, kPinRange}},
    {"backend.parport.x_home_pin", "", "input of the home switch, high is closed; axes may share one, if they are homed one after the other",
     WholeKey{home_pin<0>, kPinRange}},
    {"backend.parport.y_home_pin", "", "the same for Y", WholeKey{home_pin<1>, kPinRange}},
    {"backend.parport.z_home_pin", "", "the same for Z", WholeKey{home_pin<2>, kPinRange}},
    {"backend.parport.probe_pin", "", "input of the probe, high is a contact, likewise numbered",
     WholeKey{port<&ParallelPort::probe_pin>, kPinRange}},
    {"backend.parport.door_pin", "", "input of the door, high is open, likewise numbered",
     WholeKey{port<&ParallelPort::door_pin>, kPinRange}},

    {"backend.parport.spindle_pin", "", "output, high while the spindle turns, numbered as enable_pin",
     WholeKey{port<&ParallelPort::spindle_pin>, kPinRange}},
    {"backend.parport.spindle_ccw_pin", "", "output, high while the spindle turns counterclockwise (M04), likewise",
     WholeKey{port<&ParallelPort::spindle_ccw_pin>, kPinRange}},
    {"backend.parport.spindle_pwm_pin", "", "output, high for the part of the time that the speed of the spindle is of spindle.max_rpm, likewise",
     WholeKey{port<&ParallelPort::spindle_pwm_pin>, kPinRange}},
    {"backend.parport.spindle_pwm_levels", "", "base periods in one cycle of that signal, and so the speeds that it distinguishes: 100 of 50 us are 200 Hz",
     WholeKey{port<&ParallelPort::spindle_pwm_levels>, {2, 10000}}},
    {"backend.parport.mist_pin", "", "output, high while mist coolant is on (M07), likewise",
     WholeKey{port<&ParallelPort::mist_pin>, kPinRange}},
    {"backend.parport.flood_pin", "", "output, high while flood coolant is on (M08), likewise",
     WholeKey{port<&ParallelPort::flood_pin>, kPinRange}},

    {"backend.hal-stream.file", "", "destination of the rows for LinuxCNC's halstreamer: a file, a FIFO, or - for standard output; empty: none",
     TextKey{stream_file}},
    {"backend.hal-stream.patience_s", "s", "timeout for a blocked pipe, after which the run ends",
     NumberKey{in_part<&Machine::hal_stream, &HalStream::patience>, unconverted, unconverted, {0.001, 1e6}}},

    {"backend.hal-stream.outputs", "", "whether each row ends with the speed of the spindle, mist, flood and the digital outputs of the machine up to number 63",
     choice_in<&Machine::hal_stream, &HalStream::outputs>(kSwitchNames)},

    {"stock.x_mm", "mm", "length of the stock along X; 0: the extent of the cuts and the tool radius around them",
     NumberKey{stock_size<0>, unconverted, unconverted, length_or_0(1e5)}},
    {"stock.y_mm", "mm", "the same along Y",
     NumberKey{stock_size<1>, unconverted, unconverted, length_or_0(1e5)}},
    {"stock.z_mm", "mm", "height of the stock above its origin; 0: up to the highest cut and the tool radius above it",
     NumberKey{stock_size<2>, unconverted, unconverted, length_or_0(1e5)}},
    {"stock.origin_mm", "mm", "X, Y and Z of the corner of the stock with the smallest coordinates, in machine coordinates; "
     "[]: where the program cuts, less the tool radius",
     PointKey{stock_origin, {-1e5, 1e5}}},
    {"stock.grid_um", "um", "distance of neighbouring points of the simulated surface",
     NumberKey{in_part<&Machine::stock, &Stock::grid>, mm_from_um, um_from_mm, {0.1, 1e4}}},

    {"program.block_limit", "", "lines that one loop, or one call with all its calls, may run; beyond them the loop counts as endless, which is an error",
     WholeKey{in_part<&Machine::program, &ProgramReading::block_limit>, {1, 1e9}}},
    {"program.motion_limit_h", "h", "longest motion of a program; a longer one is refused; 0: no limit",
     NumberKey{in_part<&Machine::program, &ProgramReading::motion_limit>, s_from_h, h_from_s, at_least_0(1e9)}},
    {"program.spline_parameter", "", "parameter of splines through points: the length of the chords between them, or the same from each point to the next",
     choice_in<&Machine::program, &ProgramReading::spline_parameter>(kSplineParameterNames)},
    {"program.integers", "", "what a length or an argument of G65 without a decimal point counts in the fanuc and haas dialects: units (mm or inches), or increments of 0.001 mm or 0.0001 inch; unstated: lengths units, arguments increments, with warnings",
     choice_in<&Machine::program, &ProgramReading::integers>(kIntegerUnitNames)},
    {"program.cutter_offsets", "", "what G10 L12, L13 and #2401 to #2800 give in the haas dialect (setting 40): the diameter or the radius of a tool; unstated: the diameter, with a warning",
     choice_in<&Machine::program, &ProgramReading::cutter_offsets>(kCutterOffsetNames)},
    {"program.path", "", "folders of subprograms, looked through in this order after the folder of the program and those of --subprograms; relative ones count from the folder of the machine file",
     ListKey{subprogram_folders}},

    {"probe.radius_mm", "mm", "radius of the ball of a probe, where no [tool.*] is in the spindle",
     NumberKey{in_part<&Machine::probe, &Probe::radius>, unconverted, unconverted, length_or_0(1e3)}},
    {"tool_change.at", "mm", "X, Y and Z of the place to which the machine moves before a tool is changed by hand, in machine coordinates (docs/operating.md); []: it stays where it is",
     PointKey{tool_change_place, {-1e5, 1e5}}},
    {"operate.alone_s", "s", "how long the spindle goes on turning where the operator's terminal has gone and the machine has come to rest",
     NumberKey{in_part<&Machine::attendance, &Attendance::alone>, unconverted, unconverted, at_least_0(86400)}},
    {"serve.on_error", "", "whether softcnc serve goes on after a line in error, which is left out, or holds",
     choice_in<&Machine::attendance, &Attendance::on_error>(kOnErrorNames)},
    {"serve.on_disconnect", "", "whether softcnc serve holds its own program when the client that commands has gone, or finishes it; lines that a client streams end there in any case",
     choice_in<&Machine::attendance, &Attendance::on_disconnect>(kOnDisconnectNames)},
    {"tool.*.name", "", "description of the tool, for whoever puts it into the spindle",
     TextKey{in_tool<&Tool::name>}},
    {"tool.*.length_mm", "mm", "how far the tool reaches below the control point, for simulated contacts",
     NumberKey{in_tool<&Tool::length>, unconverted, unconverted, length_or_0(1e4)}},
    {"tool.*.radius_mm", "mm", "radius of the cutter",
     NumberKey{in_tool<&Tool::radius>, unconverted, unconverted, length_or_0(1e4)}},
    {"tool.*.teeth", "", "number of teeth",
     WholeKey{in_tool<&Tool::teeth>, {0, 1000}}},
};
// clang-format on

constexpr std::string_view kPlant = "plant.";

/// A path as that of the machine itself, and whether it is one of an axis of the plant.
struct Owner {
  std::string_view path;
  bool plant;
};
Owner owner_of(std::string_view path) {
  constexpr std::string_view kAxis = "axis";
  const std::string_view own = path.substr(path.starts_with(kPlant) ? kPlant.size() : path.size());
  const bool plant = own == kAxis || (own.starts_with(kAxis) && own[kAxis.size()] == '.');
  return {plant ? own : path, plant};
}

std::optional<int> axis_index_of(std::string_view part) {
  if (part.size() != 1 || part[0] < 'a') return std::nullopt;
  const int axis = axis_index(part[0]);
  return axis < 0 ? std::nullopt : std::optional(axis);
}

std::optional<int> tool_of(std::string_view part) {
  int number = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
  const bool plain = error == std::errc{} && end == part.data() + part.size() && part[0] != '0';
  return plain && number > 0 ? std::optional(number) : std::nullopt;
}

/// What the '*' of a pattern stands for if `parts` begin as the pattern does; 0 if it has none.
std::optional<int> match_prefix(const std::vector<std::string_view>& parts,
                                const std::vector<std::string_view>& pattern) {
  if (parts.size() > pattern.size()) return std::nullopt;
  int index = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (pattern[i] == parts[i]) continue;
    if (pattern[i] != "*") return std::nullopt;
    const auto found = pattern[0] == "axis" ? axis_index_of(parts[i]) : tool_of(parts[i]);
    if (!found) return std::nullopt;
    index = *found;
  }
  return index;
}

/// The axis or tool that `path` names where `key` has its '*', otherwise the first.
int index_like(std::string_view path, const MachineKey& key) {
  const auto parts = path_parts(path);
  const bool axis = is_axis_key(key);
  if (parts.size() > 1 && parts[0] == path_parts(key.name)[0])
    if (const auto index = axis ? axis_index_of(parts[1]) : tool_of(parts[1])) return *index;
  return axis ? 0 : 1;
}

/// The known key, cut off after `depth` parts, that is most like `path`; empty if none is like it.
std::string nearest(std::string_view path, std::size_t depth) {
  std::vector<std::string> all;
  for (const MachineKey& key : kMachineKeys) {
    std::string known = path_of({&key, index_like(path, key)});
    const auto parts = path_parts(known);
    if (depth < parts.size())
      known.resize(static_cast<std::size_t>(parts[depth].data() - known.data()) - 1);
    all.push_back(std::move(known));
  }
  return nearest_name(path, std::vector<std::string_view>(all.begin(), all.end()));
}

}  // namespace

std::vector<std::string_view> path_parts(std::string_view path) {
  std::vector<std::string_view> parts;
  for (std::size_t dot; (dot = path.find('.')) != path.npos; path.remove_prefix(dot + 1))
    parts.push_back(path.substr(0, dot));
  parts.push_back(path);
  return parts;
}

std::span<const MachineKey> machine_keys() noexcept { return kMachineKeys; }

bool is_axis_key(const MachineKey& key) noexcept { return key.name.starts_with("axis."); }
bool is_tool_key(const MachineKey& key) noexcept { return key.name.starts_with("tool."); }

Axis& axis_at(Machine& machine, int index) noexcept {
  return index < kAxes ? machine.axes[static_cast<std::size_t>(index)]
                       : machine.plant.axes[static_cast<std::size_t>(index - kAxes)];
}
const Axis& axis_at(const Machine& machine, int index) noexcept {
  return index < kAxes ? machine.axes[static_cast<std::size_t>(index)]
                       : machine.plant.axes[static_cast<std::size_t>(index - kAxes)];
}

std::optional<KeyRef> find_key(std::string_view path) {
  const auto [own_path, of_plant] = owner_of(path);
  const auto parts = path_parts(own_path);
  for (const MachineKey& key : kMachineKeys) {
    const auto pattern = path_parts(key.name);
    if (pattern.size() != parts.size()) continue;
    if (const auto index = match_prefix(parts, pattern))
      return KeyRef{&key, of_plant ? *index + kAxes : *index};
  }
  return std::nullopt;
}

bool is_section(std::string_view path) {
  if (path == kPlant.substr(0, kPlant.size() - 1)) return true;
  const auto parts = path_parts(owner_of(path).path);
  return std::any_of(std::begin(kMachineKeys), std::end(kMachineKeys), [&](const MachineKey& key) {
    const auto pattern = path_parts(key.name);
    return parts.size() < pattern.size() && match_prefix(parts, pattern);
  });
}

std::string path_of(const KeyRef& ref) {
  std::string path(ref.key->name);
  const auto star = path.find('*');
  if (star == path.npos) return path;
  if (!is_axis_key(*ref.key)) return path.replace(star, 1, std::to_string(ref.index));
  path.replace(star, 1, axis_name(ref.index % kAxes));
  return ref.index < kAxes ? path : std::string(kPlant) + path;
}

std::string nearest_key(std::string_view path) {
  const auto [own_path, of_plant] = owner_of(path);
  const std::string known = nearest(own_path, std::string_view::npos);
  return of_plant && known.starts_with("axis.") ? std::string(kPlant) + known : known;
}

std::string nearest_section(std::string_view path) {
  return nearest(path, static_cast<std::size_t>(std::count(path.begin(), path.end(), '.')) + 1);
}

}  // namespace softcnc::hal
