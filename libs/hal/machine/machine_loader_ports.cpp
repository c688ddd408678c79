// SPDX-License-Identifier: MIT
// Whether the pulses that axes and feed ask for can be made, and the pins of a parallel port.
#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "hal/machine/machine_loader.hpp"
#include "hal/ports/port_pins.hpp"
#include "hal/ports/port_timing.hpp"
#include "motion/core/units.hpp"
#include "motion/model/step_rate.hpp"

namespace softcnc::hal {
namespace {

/// What rounding may add to a product.
constexpr double kRoundedUp = 1 + 1e-9;

/// What rounding may add to a feed that steps can just make.
constexpr double kFeedRoundedUp = 1 + 1e-12;

/// A rate, Hz, without an exponent where it is whole.
std::string hertz(double rate) {
  const double whole = std::round(rate);
  return whole == rate ? std::to_string(std::llround(whole)) : number_text(rate);
}

/// A feed that would be accepted: mm/min, of at most three decimals, not above `feed`, mm/s.
std::string feed_text(double feed) {
  return number_text(std::floor(mm_min_from_mm_s(feed) * kFeedRoundedUp * 1e3) / 1e3);
}

std::string blu_text(int axis, double blu) {
  return "axis." + axis_name(axis) + ".blu_um = " + scaled_text(blu, mm_from_um, um_from_mm);
}

/// The largest rate of pulses; and where steps in whole ns cannot have it, what they make of it.
std::string rate_text(const StepPort& port) {
  return " times backend.stepdir.max_rate_hz = " + hertz(port.max_rate) +
         (step_rate(port) < port.max_rate
              ? ", in whole ns a step every " + std::to_string(step_interval(port)) + " ns"
              : std::string());
}

std::string port_rate_text(const Machine& machine) {
  const auto interval = static_cast<double>(port_timing(machine).rules.interval);
  return " every " + number_text(interval / 1e3) +
         " us, the shortest time between steps at backend.parport.base_period_us = " +
         number_text(ns_from_s(machine.parallel_port.base_period) / 1e3);
}

/// A speed, mm/s, above what pulses can make.
std::string too_fast(const std::string& key, double speed, const std::string& than, double most) {
  return key + " = " + scaled_text(speed, mm_s_from_mm_min, mm_min_from_mm_s) + " is more than " +
         than + ", which is " + feed_text(most) + " mm/min";
}

/// Of the axes the machine has; -1 if it has none.
int axis_of_largest_blu(const Machine& machine) {
  const auto& axes = machine.axes;
  const auto largest = std::max_element(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) {
    return std::pair(a.present, a.blu) < std::pair(b.present, b.blu);
  });
  return largest->present ? static_cast<int>(largest - axes.begin()) : -1;
}

}  // namespace

void MachineLoader::check_step_port() {
  const StepPort& port = loaded_.machine.step_port;
  const double fastest = 1.0 / (port.step_length + port.step_space);
  if (port.max_rate > fastest * kRoundedUp)
    return clash(Code::SC7019,
                 {"backend.stepdir.max_rate_hz", "backend.stepdir.step_length_ns",
                  "backend.stepdir.step_space_ns"},
                 "backend.stepdir.max_rate_hz = " + hertz(port.max_rate) +
                     " is more than step_length_ns and step_space_ns leave: " +
                     hertz(std::floor(fastest * kRoundedUp)) + " Hz");
  for (int axis = 0; axis < kAxes; ++axis) check_pulse_rate(axis);
  check_feed(step_rate(port), rate_text(port));
}

/// An axis is no faster than its pulses can be.
void MachineLoader::check_pulse_rate(int index) {
  const Axis& axis = loaded_.machine.axes[static_cast<std::size_t>(index)];
  const StepPort& port = loaded_.machine.step_port;
  const double most = axis.blu * step_rate(port);
  if (!axis.present || axis.velocity <= most * kFeedRoundedUp) return;
  const std::string name = "axis." + axis_name(index);
  clash(Code::SC7018,
        {name + ".velocity_mm_min", "backend.stepdir.max_rate_hz", name + ".blu_um",
         "control.backend", "control.interpolation", "backend.stepdir.step_length_ns",
         "backend.stepdir.step_space_ns"},
        too_fast(name + ".velocity_mm_min", axis.velocity,
                 blu_text(index, axis.blu) + rate_text(port), most));
}

/// No axis could move as fast as the limit along the path if its pulses came at this rate, Hz. The
/// default gives way.
void MachineLoader::check_feed(double rate, const std::string& in_words) {
  const std::string key = "limits.feed_mm_min";
  Machine& machine = loaded_.machine;
  const int fastest = axis_of_largest_blu(machine);
  if (fastest < 0) return;
  const double blu = machine.axes[static_cast<std::size_t>(fastest)].blu;
  const double most = blu * rate;
  double& feed = machine.limits.feed;
  if (feed <= most * kFeedRoundedUp) return;
  if (!loaded_.given.contains(key)) {
    feed = most;
    return;
  }
  clash(Code::SC7090,
        {key, "axis.x.blu_um", "axis.y.blu_um", "axis.z.blu_um", "backend.stepdir.max_rate_hz",
         "backend.stepdir.step_length_ns", "backend.stepdir.step_space_ns",
         "backend.parport.base_period_us"},
        too_fast(key, feed, blu_text(fastest, blu) + in_words, most));
}

void MachineLoader::check_parallel_port() {
  const ParallelPort& port = loaded_.machine.parallel_port;
  for (int axis = 0; axis < kAxes; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (!loaded_.machine.axes[i].present) continue;
    check_port_rate(axis);
    check_pin(axis_name(axis) + "_step_pin", port.step_pin[i], is_data_pin);
    check_pin(axis_name(axis) + "_direction_pin", port.direction_pin[i], is_data_pin);
  }
  const auto interval = static_cast<double>(port_timing(loaded_.machine).rules.interval);
  check_feed(1 / s_from_ns(interval), port_rate_text(loaded_.machine));
  check_pin("enable_pin", port.enable_pin, is_output_pin);
  check_pin("charge_pump_pin", port.charge_pump_pin, is_output_pin);
  check_pin("estop_pin", port.estop_pin, is_input_pin);
  check_pin("limit_pin", port.limit_pin, is_input_pin);
  check_pin("fault_pin", port.fault_pin, is_input_pin);
  check_pin("probe_pin", port.probe_pin, is_input_pin);
  check_pin("door_pin", port.door_pin, is_input_pin);
  for (int axis = 0; axis < kAxes; ++axis) check_home_pin(axis);
  check_pin("spindle_pin", port.spindle_pin, is_output_pin);
  check_pin("spindle_ccw_pin", port.spindle_ccw_pin, is_output_pin);
  check_pin("spindle_pwm_pin", port.spindle_pwm_pin, is_output_pin);
  if (port.spindle_pwm_pin != 0 && loaded_.machine.spindle.max_rpm == 0)
    clash(Code::SC7071, {"backend.parport.spindle_pwm_pin", "spindle.max_rpm", "control.backend"},
          "backend.parport.spindle_pwm_pin needs a spindle.max_rpm, of which speeds are parts");
  check_pin("mist_pin", port.mist_pin, is_output_pin);
  check_pin("flood_pin", port.flood_pin, is_output_pin);
  for (const auto& [name, output] : loaded_.machine.outputs)
    check_pin_of("output." + name + ".pin", output.pin, is_output_pin);
  used_pins_.clear();
}

void MachineLoader::check_port_rate(int index) {
  const Axis& axis = loaded_.machine.axes[static_cast<std::size_t>(index)];
  const double interval =
      s_from_ns(static_cast<double>(port_timing(loaded_.machine).rules.interval));
  const double most = axis.blu / interval;
  if (axis.velocity <= most * kFeedRoundedUp) return;
  const std::string name = "axis." + axis_name(index);
  clash(Code::SC7070,
        {name + ".velocity_mm_min", "backend.parport.base_period_us", name + ".blu_um",
         "control.backend", "backend.stepdir.step_length_ns", "backend.stepdir.step_space_ns"},
        too_fast(name + ".velocity_mm_min", axis.velocity,
                 blu_text(index, axis.blu) + port_rate_text(loaded_.machine), most));
}

/// Axes that search one after the other may share a pin.
void MachineLoader::check_home_pin(int index) {
  const auto& axes = loaded_.machine.axes;
  const auto& pins = loaded_.machine.parallel_port.home_pin;
  const auto i = static_cast<std::size_t>(index);
  if (!axes[i].present) return;
  bool shares = false;
  for (std::size_t before = 0; before < i; ++before) {
    if (!axes[before].present || pins[before] == 0 || pins[before] != pins[i]) continue;
    shares = axes[before].home.order != axes[i].home.order;
    if (!shares) break;
  }
  if (shares) return;
  check_pin(axis_name(index) + "_home_pin", pins[i], is_input_pin);
}

void MachineLoader::check_pin(const std::string& key, int pin, bool (*fits)(int)) {
  check_pin_of("backend.parport." + key, pin, fits);
}

/// A pin does what `fits` says, and one thing only.
void MachineLoader::check_pin_of(const std::string& name, int pin, bool (*fits)(int)) {
  if (pin == 0) return;
  const std::string text = name + " = " + std::to_string(pin);
  if (!fits(pin))
    return clash(Code::SC7071, {name, "control.backend"},
                 text + (fits == is_input_pin    ? " is not an input: 10, 11, 12, 13, 15"
                         : fits == is_output_pin ? " is not an output: 1 to 9, 14, 16, 17"
                                                 : " is not a data pin: 2 to 9"));
  const auto [used, is_new] = used_pins_.try_emplace(std::abs(pin), name);
  if (!is_new)
    clash(Code::SC7071, {name, used->second, "control.backend"},
          text + " is the pin of " + used->second);
}

}  // namespace softcnc::hal
