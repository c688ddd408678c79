// SPDX-License-Identifier: MIT
#include "hal/ports/port_pins.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>

namespace softcnc::hal {
namespace {

enum class Register : std::uint8_t { data, control, status };

struct PinEntry {
  int pin;
  Register where;
  std::uint8_t bit;
  bool inverted;  // by the port itself
};

constexpr PinEntry kPinTable[] = {
    {1, Register::control, 0x01, true},  {2, Register::data, 0x01, false},
    {3, Register::data, 0x02, false},    {4, Register::data, 0x04, false},
    {5, Register::data, 0x08, false},    {6, Register::data, 0x10, false},
    {7, Register::data, 0x20, false},    {8, Register::data, 0x40, false},
    {9, Register::data, 0x80, false},    {10, Register::status, 0x40, false},
    {11, Register::status, 0x80, true},  {12, Register::status, 0x20, false},
    {13, Register::status, 0x10, false}, {14, Register::control, 0x02, true},
    {15, Register::status, 0x08, false}, {16, Register::control, 0x04, false},
    {17, Register::control, 0x08, true},
};

const PinEntry* entry_of(int pin) noexcept {
  const auto* entry = std::find_if(std::begin(kPinTable), std::end(kPinTable),
                                   [&](const PinEntry& r) { return r.pin == std::abs(pin); });
  return entry == std::end(kPinTable) ? nullptr : entry;
}

bool is_of(int pin, Register where) noexcept {
  const PinEntry* entry = entry_of(pin);
  return entry && entry->where == where;
}

/// Levels of a bit with its inversions.
std::uint8_t level_of_high(const PinEntry& entry, int pin) noexcept {
  return entry.inverted == (pin < 0) ? entry.bit : std::uint8_t{0};
}

constexpr std::uint8_t with(std::uint8_t bits, std::uint8_t bit, std::uint8_t level) noexcept {
  return static_cast<std::uint8_t>((bits & ~bit) | level);
}

}  // namespace

bool is_data_pin(int pin) { return is_of(pin, Register::data); }
bool is_output_pin(int pin) { return is_data_pin(pin) || is_of(pin, Register::control); }
bool is_input_pin(int pin) { return is_of(pin, Register::status); }

PortPins::Line PortPins::line_of(int pin) {
  const PinEntry* entry = entry_of(pin);
  if (!entry) return {};
  const std::uint8_t high = level_of_high(*entry, pin);
  if (entry->where == Register::data) return {{entry->bit, 0}, {high, 0}};
  return {{0, entry->bit}, {0, high}};
}

PortPins::Input PortPins::input_of(int pin) {
  const PinEntry* entry = entry_of(pin);
  return entry ? Input{entry->bit, level_of_high(*entry, pin)} : Input{};
}

PortPins::PortPins(const Machine& machine)
    : max_rpm_(machine.spindle.max_rpm), pwm_levels_(machine.parallel_port.spindle_pwm_levels) {
  const ParallelPort& port = machine.parallel_port;
  for (std::size_t i = 0; i < lines_.size(); ++i)
    if (machine.axes[i].present)
      lines_[i] = {line_of(port.step_pin[i]), line_of(port.direction_pin[i])};
  enable_ = line_of(port.enable_pin);
  charge_pump_ = line_of(port.charge_pump_pin);
  estop_ = input_of(port.estop_pin);
  limit_ = input_of(port.limit_pin);
  fault_ = input_of(port.fault_pin);
  probe_ = input_of(port.probe_pin);
  door_ = input_of(port.door_pin);
  for (std::size_t i = 0; i < homes_.size(); ++i)
    if (machine.axes[i].present) homes_[i] = input_of(port.home_pin[i]);
  spindle_ = line_of(port.spindle_pin);
  spindle_ccw_ = line_of(port.spindle_ccw_pin);
  spindle_pwm_ = line_of(port.spindle_pwm_pin);
  mist_ = line_of(port.mist_pin);
  flood_ = line_of(port.flood_pin);
  for (const auto& [name, output] : machine.outputs)
    if (output.pin != 0 && is_switched(output))
      outputs_.push_back({output.number, line_of(output.pin)});
  for (const auto& axis : lines_)
    for (const Line& line : axis) put(rest_, line, false);
  put(rest_, enable_, false);
  put(rest_, charge_pump_, false);
  put(rest_, spindle_pwm_, false);
  set(rest_, Outputs());
}

PortWord PortPins::enabled() const noexcept {
  PortWord word = rest_;
  put(word, enable_, true);
  return word;
}

void PortPins::set(PortWord& word, int axis, Wire wire, bool high) const noexcept {
  put(word, lines_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(wire)], high);
}

void PortPins::set(PortWord& word, const Outputs& outputs) const noexcept {
  put(word, spindle_, outputs.spindle_rpm != 0);
  put(word, spindle_ccw_, outputs.spindle_rpm < 0);
  put(word, mist_, outputs.mist);
  put(word, flood_, outputs.flood);
  for (const Output& output : outputs_) put(word, output.line, outputs.is_on(output.number));
  const double part = max_rpm_ > 0 ? std::min(std::abs(outputs.spindle_rpm) / max_rpm_, 1.0) : 0;
  word.speed = static_cast<std::uint16_t>(std::lround(part * pwm_levels_));
}

PortWord PortPins::at(PortWord word, std::int64_t tick) const noexcept {
  put(word, charge_pump_, tick % 2 == 0);
  put(word, spindle_pwm_, tick % pwm_levels_ < word.speed);
  return word;
}

void PortPins::put(PortWord& word, const Line& line, bool high) noexcept {
  const auto level = [&](std::uint8_t bit, std::uint8_t of_high) {
    return static_cast<std::uint8_t>(high ? of_high : bit & ~of_high);
  };
  word.data = with(word.data, line.bit.data, level(line.bit.data, line.high.data));
  word.control = with(word.control, line.bit.control, level(line.bit.control, line.high.control));
}

bool PortPins::looks() const noexcept {
  const bool is_homed =
      std::any_of(homes_.begin(), homes_.end(), [](const Input& home) { return home.bit != 0; });
  return is_homed || (estop_.bit | limit_.bit | fault_.bit | probe_.bit | door_.bit) != 0;
}

InputLevels PortPins::inputs(std::uint8_t status) const noexcept {
  InputLevels inputs{{}, is_high(probe_, status), is_high(door_, status)};
  for (std::size_t i = 0; i < homes_.size(); ++i) inputs.home[i] = is_high(homes_[i], status);
  return inputs;
}

Alarm PortPins::alarm(std::uint8_t status) const noexcept {
  if (is_high(estop_, status)) return Alarm::emergency_stop;
  if (is_high(fault_, status)) return Alarm::driver_fault;
  if (is_high(limit_, status)) return Alarm::limit_switch;
  return Alarm::none;
}

}  // namespace softcnc::hal
