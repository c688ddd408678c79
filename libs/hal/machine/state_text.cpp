// SPDX-License-Identifier: MIT
// The text of a state file.
#include <string>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "hal/machine/state_file.hpp"
#include "hal/machine/state_names.hpp"
#include "hal/machine/toml_text.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

std::string section(const std::string& name) { return "\n[" + name + "]\n"; }

std::string number_line(const std::string& key, double value) {
  return key + " = " + number_text(value) + '\n';
}

std::string axis_lines(const AxisVector& vector) {
  std::string text;
  for (int axis = 0; axis < kAxes; ++axis)
    text += number_line(axis_name(axis) + "_mm", vector[axis]);
  return text;
}

std::string work_text(const std::string& name, const WorkOffset& work) {
  return section("work." + toml_string(name)) + axis_lines(work.origin) +
         "rotation_deg = " + scaled_text(work.rotation, rad_from_deg, deg_from_rad) + '\n';
}

std::string tool_text(int number, const ToolOffset& tool) {
  return section("tool." + std::to_string(number)) + axis_lines(tool.length) +
         number_line("radius_mm", tool.radius) + number_line("length_wear_mm", tool.length_wear) +
         number_line("radius_wear_mm", tool.radius_wear);
}

}  // namespace

std::string state_toml(const MachineState& state) {
  std::string text = "# What programs have left on the machine. softcnc run --state writes it.\n";
  text += number_line("schema", kStateSchema);
  text += "active = " + toml_string(system_name(state.active)) + '\n';
  text += "g92_in_force = " + toml_string(kNoYes[state.shift_on ? 1 : 0]) + '\n';
  if (state.loaded_tool) text += "tool_in_spindle = " + std::to_string(*state.loaded_tool) + '\n';
  if (state.position)
    text += section("position") + axis_lines(state.position->place) +
            "in_motion = " + toml_string(kNoYes[state.position->in_motion ? 1 : 0]) + '\n';
  text += section("g92") + axis_lines(state.shift);
  text += section("g28") + axis_lines(state.home);
  text += section("g30") + axis_lines(state.second_home);
  for (std::size_t i = 0; i < kFurtherHomes.size(); ++i)
    if (const auto& home = state.further_homes[i])
      text += section(std::string(kFurtherHomes[i])) + axis_lines(*home);
  for (int i = 0; i < kWorkSystems; ++i) text += work_text(system_name(i), state.work_system(i));
  for (const auto& [number, work] : state.further_work)
    if (work != WorkOffset{}) text += work_text(system_name(kWorkSystems + number - 1), work);
  for (const auto& [number, tool] : state.tools) text += tool_text(number, tool);
  text += section("parameter");
  for (const auto& [number, value] : state.parameters)
    if (value != 0) text += number_line(std::to_string(number), value);
  for (const auto& [name, value] : state.globals) text += number_line(toml_key(name), value);
  return text;
}

}  // namespace softcnc::hal
