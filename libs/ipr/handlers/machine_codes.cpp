// SPDX-License-Identifier: MIT
// M codes that the machine file defines: rows like those of the built-in codes that they stand for.
#include <algorithm>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

int number_of(const Task& task) { return task.code.number / kCodesPerNumber; }
const MachineCode& machine_code(const Task& task) {
  return task.machine.m_codes.find(number_of(task))->second;
}

void dwell_as_defined(Task& task) {
  if (machine_code(task).seconds > 0) task.out.emit(Dwell{machine_code(task).seconds});
}

void turn_spindle_as_defined(Task& task) {
  const SpindleTurn turn = machine_code(task).direction;
  turn_spindle_as(task, turn == SpindleTurn::cw    ? kSpindleCw
                        : turn == SpindleTurn::ccw ? kSpindleCcw
                                                   : kSpindleOff);
}

void switch_coolant_as_defined(Task& task) {
  const CoolantSwitch coolant = machine_code(task).coolant;
  switch_coolant_as(task, coolant == CoolantSwitch::mist    ? kMist
                          : coolant == CoolantSwitch::flood ? kFlood
                                                            : kCoolantOff);
}

void set_output_as_defined(Task& task) {
  const MachineCode& code = machine_code(task);
  const auto output = find_output(task.machine.outputs, code.output);
  if (output == task.machine.outputs.end())
    return task.out.report(Code::SC2240, task.word.pos,
                           code_name(task.code) + " sets output '" + code.output +
                               "', which the machine does not have");
  task.out.emit(Action{Action::Kind::output, number_of(task), code.value, output->second});
}

/// Where a code acts on its line, and which others exclude it: as that of softcnc's own.
const GCode& model_of(MachineCodeAct act) noexcept {
  constexpr double kStop = 0, kSpindle = 3, kCoolant = 7, kOutput = 64;
  switch (act) {
    case MachineCodeAct::stop:
      return *find_gcode('M', kStop);
    case MachineCodeAct::spindle:
      return *find_gcode('M', kSpindle);
    case MachineCodeAct::coolant:
      return *find_gcode('M', kCoolant);
    default:
      return *find_gcode('M', kOutput);
  }
}

void (*handler_of(MachineCodeAct act) noexcept)(Task&) {
  switch (act) {
    case MachineCodeAct::ignore:
      return nullptr;
    case MachineCodeAct::stop:
      return stop_program;
    case MachineCodeAct::dwell:
      return dwell_as_defined;
    case MachineCodeAct::spindle:
      return turn_spindle_as_defined;
    case MachineCodeAct::coolant:
      return switch_coolant_as_defined;
    case MachineCodeAct::output:
      return set_output_as_defined;
  }
  return nullptr;
}

}  // namespace

std::vector<GCode> machine_codes(const Machine& machine) {
  std::vector<GCode> rows;
  rows.reserve(machine.m_codes.size());
  for (const auto& [number, code] : machine.m_codes) {
    GCode row = model_of(code.act);
    row.number = number * kCodesPerNumber;
    if (code.act == MachineCodeAct::dwell) row.order = find_gcode('G', 4)->order;
    row.words = code.words;
    row.act = handler_of(code.act);
    row.says = "An M code of the machine.";
    rows.push_back(row);
  }
  return rows;
}

const GCode* find_machine_code(std::span<const GCode> codes, double value) noexcept {
  const auto found = std::find_if(codes.begin(), codes.end(), [&](const GCode& code) {
    return code.number == value * kCodesPerNumber;
  });
  return found == codes.end() ? nullptr : &*found;
}

}  // namespace softcnc::ipr
