// SPDX-License-Identifier: MIT
// M codes that the machine file defines: rows like those of the built-in codes that they stand for;
// and codes that are known, and ask for what no machine of softcnc can do.
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

// Refused ----------------------------------------------------------------------------------------

namespace {

void refuse(Task& task, const std::string& why) {
  task.out.report(Code::SC2114, task.word.pos, code_name(task.code) + " is refused: " + why);
}

}  // namespace

/// G33, G33.1, G76.
void refuse_thread(Task& task) {
  // G76: a thread of LinuxCNC's, fine boring of FANUC's.
  if (task.code.number == kG76 && is_fanuc(task)) return refuse_cycle(task);
  refuse(task, "threads need a spindle with an encoder, which the axes could follow");
  task.modal.motion = task.modal.motion_below = nullptr;
}

/// M29. Whether the spindle would turn after it is not known.
void refuse_rigid_tapping(Task& task) {
  refuse(task,
         "rigid tapping needs a spindle in step with the axis; G74 and G84 without M29 take a "
         "floating holder and a spindle that turns");
  task.modal.unknown.add(Part::spindle);
}

/// G47, G150, M109.
void refuse_of_haas(Task& task) {
  if (task.code.number == kG47)
    return refuse(task, "it engraves a text or a serial number in the letters of the control");
  if (task.code.number == kG150)
    return refuse(task,
                  "it clears a pocket whose outline is the program of P, by paths of the control");
  refuse(task, "it shows a text to the operator and puts the key pressed into the variable of P");
}

/// G103: how far a control looks ahead; G187 P: how smoothly it moves.
void pass_over(Task& task) {
  task.out.report(Code::SC2268, task.word.pos,
                  code_name(task.code) +
                      " has no effect: softcnc looks ahead over the whole program, and keeps the "
                      "tolerance of G64");
}

}  // namespace softcnc::ipr
