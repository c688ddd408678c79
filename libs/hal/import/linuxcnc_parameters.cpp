// SPDX-License-Identifier: MIT
#include "hal/import/linuxcnc_parameters.hpp"

#include <cmath>

#include "hal/import/setting_value.hpp"
#include "motion/core/axes.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr int kFirstOrdinary = 31, kEndOrdinary = 5000;
constexpr int kHome = 5161, kSecondHome = 5181, kShiftOn = 5210, kShift = 5211, kActive = 5220;
constexpr int kFirstWork = 5221, kPerWork = 20, kRotation = 9;

bool is_axis(int number, int first) { return number >= first && number < first + kAxes; }

/// Returns false where the value is beyond what a state may hold.
bool put(double& place, double value) {
  if (std::abs(value) > kFarthest) return false;
  place = without_rounding(value);
  return true;
}

bool put_work(MachineState& state, int number, double value, double mm_per_unit) {
  const auto system = static_cast<std::size_t>((number - kFirstWork) / kPerWork);
  const int part = (number - kFirstWork) % kPerWork;
  if (part < kAxes) return put(state.work[system].origin[part], value * mm_per_unit);
  if (part != kRotation) return true;
  if (std::abs(value) > kMostTurned) return false;
  state.work[system].rotation = rad_from_deg(value);
  return true;
}

bool put_active(MachineState& state, double value) {
  if (!(value >= 1 && value <= kWorkSystems) || value != std::floor(value)) return false;
  state.active = static_cast<int>(value) - 1;
  return true;
}

bool put_parameter(MachineState& state, int number, double value, double mm_per_unit) {
  if (is_axis(number, kHome)) return put(state.home[number - kHome], value * mm_per_unit);
  if (is_axis(number, kSecondHome))
    return put(state.second_home[number - kSecondHome], value * mm_per_unit);
  if (is_axis(number, kShift)) return put(state.shift[number - kShift], value * mm_per_unit);
  if (number == kActive) return put_active(state, value);
  if (number == kShiftOn) {
    state.shift_on = value != 0;
  } else if (number >= kFirstWork && number < kFirstWork + kWorkSystems * kPerWork) {
    return put_work(state, number, value, mm_per_unit);
  } else if (number >= kFirstOrdinary && number < kEndOrdinary && value != 0) {
    state.parameters[number] = value;
  }
  return true;
}

}  // namespace

void take_parameters(std::string_view text, const std::string& file, double mm_per_unit,
                     MachineDraft& draft) {
  const std::vector<std::string> lines = setting_lines(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int line = static_cast<int>(i) + 1;
    const std::string_view setting = trimmed_setting(lines[i]);
    if (setting.empty()) continue;
    const auto blank = std::min(setting.find_first_of(" \t"), setting.size());
    const auto number = setting_number(setting.substr(0, blank));
    const std::string_view rest = trimmed_setting(setting.substr(blank));
    const auto value = setting_number(rest);
    if (!number || !value || *number != std::floor(*number) || std::abs(*number) > 1e6) {
      draft.fail(Code::SC7034, place_of(file, line, lines[i], setting),
                 "this is no line of a parameter file of LinuxCNC: a number and its value");
      continue;
    }
    if (!put_parameter(draft.state(), static_cast<int>(*number), *value, mm_per_unit))
      draft.fail(
          Code::SC7035, place_of(file, line, lines[i], rest),
          "#" + std::to_string(static_cast<int>(*number)) + " cannot be " + std::string(rest));
  }
}

}  // namespace softcnc::hal
