// SPDX-License-Identifier: MIT
#include "serve/grbl_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "hal/machine/state_names.hpp"
#include "ipr/interpreter/memory.hpp"
#include "motion/core/units.hpp"
#include "runtime/operator/homing.hpp"

namespace softcnc::app {
namespace {

constexpr int kBlocks = 15, kBytes = 65535;                             // free, as Bf tells
constexpr int kOffsetMoving = 30, kOverridesMoving = 20, kAtRest = 10;  // reports

/// "G1", "G38.2"
std::string code_text(const ipr::GCode& code) {
  const int tenth = code.number % 10;
  return fmt::format("{}{}{}", code.letter, code.number / 10,
                     tenth == 0 ? "" : fmt::format(".{}", tenth));
}

double whole(double value) { return std::abs(value) < 0.5 ? 0.0 : value; }

using Setting = std::pair<int, double>;

std::vector<Setting> machine_settings(const Machine& machine) {
  const bool homes = runtime::Homing::is_possible(machine);
  int towards_negative = 0;
  double search = 0, latch = 0, back_off = 0;
  for (int i = 0; i < kAxes; ++i) {
    const Axis& axis = machine.axes[static_cast<std::size_t>(i)];
    if (!has_home_switch(axis)) continue;
    if (axis.home.direction() < 0) towards_negative |= 1 << i;
    search = std::abs(axis.home.search);
    latch = axis.home.latch > 0 ? axis.home.latch : axis.blu / machine.control.period;
    back_off = axis.home.back_off;
  }
  std::vector<Setting> settings{
      {0, std::max(1.0, std::round(1e6 * machine.step_port.step_length))},
      {1, 255},
      {2, 0},
      {3, 0},
      {4, 0},
      {5, 0},
      {6, 0},
      {11, machine.control.corner_tolerance},
      {12, machine.control.chord_tolerance},
      {20, 1},
      {21, 0},
      {22, homes ? 1 : 0},
      {23, static_cast<double>(towards_negative)},
      {24, mm_min_from_mm_s(latch)},
      {25, mm_min_from_mm_s(search)},
      {26, 0},
      {27, back_off},
      {30, machine.spindle.max_rpm},
      {31, machine.spindle.min_rpm},
      {32, 0},
  };
  const auto of_axes = [&](int first, double (*value)(const Axis&)) {
    for (int i = 0; i < kAxes; ++i)
      if (machine.axes[static_cast<std::size_t>(i)].present)
        settings.emplace_back(first + i, value(machine.axes[static_cast<std::size_t>(i)]));
  };
  of_axes(100, [](const Axis& axis) { return 1 / axis.blu; });
  of_axes(110, [](const Axis& axis) { return mm_min_from_mm_s(axis.velocity); });
  of_axes(120, [](const Axis& axis) { return axis.acceleration; });
  of_axes(130, [](const Axis& axis) { return axis.max - axis.min; });
  return settings;
}

std::string setting_text(int number, double value) {
  const bool is_whole = number < 11 || (number >= 20 && number <= 23) || number == 32;
  return is_whole ? fmt::format("${}={:.0f}", number, value)
                  : fmt::format("${}={:.3f}", number, value);
}

}  // namespace

std::string GrblReports::place(const AxisVector& mm) const {
  const double unit = inches_ ? kMmPerInch : 1;
  std::string text;
  for (int axis = 0; axis < kAxes; ++axis) {
    const double least = inches_ ? 0.00005 : 0.0005;
    const double value = std::abs(mm[axis] / unit) < least ? 0.0 : mm[axis] / unit;
    text += fmt::format("{}{:.{}f}", axis > 0 ? "," : "", value, inches_ ? 4 : 3);
  }
  return text;
}

std::string GrblReports::status(const AttendedMachine& machine, const Requests& requests,
                                const std::string& state) {
  const runtime::Operator& control = machine.control();
  const AxisVector& mm = control.position();
  const AxisVector work = control.programmed(mm);
  const bool by_machine = (shown_ & 1) != 0, moves = control.moving();
  const double unit = inches_ ? kMmPerInch : 1;
  std::string text =
      fmt::format("<{}|{}:{}", state, by_machine ? "MPos" : "WPos", place(by_machine ? mm : work));
  if ((shown_ & 2) != 0)
    text += fmt::format("|Bf:{},{}", std::max(kBlocks - control.blocks_ahead(), 0), kBytes);
  if (moves && control.last().line > 0) text += fmt::format("|Ln:{}", control.last().line);
  text +=
      fmt::format("|FS:{:.0f},{:.0f}", whole(moves ? mm_min_from_mm_s(control.last().v) / unit : 0),
                  std::abs(control.outputs().spindle_rpm));
  std::string offset = place(AxisVector(mm - work));
  const auto& percent = requests.overrides();
  std::string overrides = fmt::format("{:.0f},{:.0f},{:.0f}", 100 * percent.feed,
                                      100 * percent.rapid, 100 * percent.spindle);
  std::string on;
  const Outputs& outputs = control.outputs();
  if (outputs.spindle_rpm != 0) on += outputs.spindle_rpm > 0 ? 'S' : 'C';
  if (outputs.flood) on += 'F';
  if (outputs.mist) on += 'M';
  if (!on.empty()) overrides += "|A:" + on;
  if (offset != offset_) to_offset_ = 0;
  if (overrides != overrides_) to_overrides_ = std::min(to_overrides_, to_offset_ == 0 ? 1 : 0);
  if (to_offset_ <= 0) {
    text += "|WCO:" + offset;
    offset_ = std::move(offset);
    to_offset_ = moves ? kOffsetMoving : kAtRest;
    to_overrides_ = std::max(to_overrides_, 1);
  } else if (to_overrides_ <= 0) {
    text += "|Ov:" + overrides;
    overrides_ = std::move(overrides);
    to_overrides_ = moves ? kOverridesMoving : kAtRest;
  }
  --to_offset_;
  --to_overrides_;
  return text + '>';
}

std::string GrblReports::settings(const Machine& machine) const {
  std::vector<Setting> all = machine_settings(machine);
  all.emplace_back(10, shown_);
  all.emplace_back(13, inches_ ? 1 : 0);
  std::sort(all.begin(), all.end());
  std::string text;
  for (const auto& [number, value] : all) {
    const bool is_flag = number == 10 || number == 13;
    text += (text.empty() ? "" : "\r\n") +
            (is_flag ? fmt::format("${}={:.0f}", number, value) : setting_text(number, value));
  }
  return text;
}

bool GrblReports::set(int number, double value, const Machine& machine) {
  constexpr double kShown = 0.0005;
  if (number == 10 && value >= 0 && value <= 3) {
    shown_ = static_cast<int>(value);
    return true;
  }
  if (number == 13 && (value == 0 || value == 1)) {
    inches_ = value == 1;
    return true;
  }
  for (const auto& [known, is] : machine_settings(machine))
    if (known == number) return std::abs(is - value) <= kShown;
  return false;
}

std::string GrblReports::offsets(const AttendedMachine& machine) const {
  constexpr int kSystems = 6;  // G54 to G59
  const MachineState state = machine.control().state();
  const auto& modal = machine.control().memory().modal;
  std::string text;
  for (int i = 0; i < kSystems; ++i)
    text += fmt::format("[{}:{}]\r\n", hal::system_name(i), place(state.work_system(i).origin));
  text += fmt::format("[G28:{}]\r\n[G30:{}]\r\n", place(state.home), place(state.second_home));
  text += fmt::format("[G92:{}]\r\n",
                      place(state.shift_on ? state.shift : AxisVector(AxisVector::Zero())));
  text += fmt::format("[TLO:{:.3f}]\r\n", modal.tool_offset[2] / (inches_ ? kMmPerInch : 1));
  return text + probed();
}

/// Programs find the contact in #5061 to #5063, in their coordinates, and in #5070 whether there
/// was one.
void GrblReports::keep_probed(const AttendedMachine& machine) {
  constexpr int kFirst = 5061, kContact = 5070;
  const runtime::Operator& control = machine.control();
  const auto read = [&](int number) {
    const double value = control.memory().parameters.read(number).value_or(0);
    return std::isfinite(value) ? value : 0;
  };
  probed_.reset();
  if (read(kContact) == 0) return;
  AxisVector there;
  for (int axis = 0; axis < kAxes; ++axis)
    there[axis] = read(kFirst + axis) * control.mm_per_unit();
  const AxisVector& here = control.position();
  probed_ = here + there - control.programmed(here);
}

std::string GrblReports::probed() const {
  return probed_ ? fmt::format("[PRB:{}:1]", place(*probed_))
                 : fmt::format("[PRB:{}:0]", place(AxisVector::Zero()));
}

std::string GrblReports::modes(const AttendedMachine& machine) const {
  const auto& modal = machine.control().memory().modal;
  constexpr const char* kPlanes[] = {"G17", "G18", "G19"};
  constexpr const char* kFeeds[] = {"G94", "G93", "G95"};
  const std::string motion = modal.motion == nullptr ? "G0" : code_text(*modal.motion);
  const Outputs& on = machine.control().outputs();
  const std::string coolant = on.mist && on.flood ? "M7 M8"
                              : on.mist           ? "M7"
                              : on.flood          ? "M8"
                                                  : "M9";
  const int tool = modal.tool.value_or(modal.state.loaded_tool.value_or(0));
  return fmt::format("[GC:{} {} {} {} {} {} {} {} T{} F{:.0f} S{:.0f}]", motion,
                     hal::system_name(modal.state.active),
                     kPlanes[static_cast<std::size_t>(modal.plane)],
                     modal.mm_per_unit == 1 ? "G21" : "G20", modal.incremental ? "G91" : "G90",
                     kFeeds[static_cast<std::size_t>(modal.feed_mode)],
                     modal.spindle_direction == 0  ? "M5"
                     : modal.spindle_direction > 0 ? "M3"
                                                   : "M4",
                     coolant, tool, mm_min_from_mm_s(modal.feed) / modal.mm_per_unit,
                     modal.spindle_speed.value_or(0));
}

std::string GrblReports::build() {
  return fmt::format("[VER:1.1h.20190830:softcnc (Grbl 1.1)]\r\n[OPT:VNMZ,{},{}]", kBlocks, kBytes);
}

std::string GrblReports::help() {
  return "[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]";
}

}  // namespace softcnc::app
