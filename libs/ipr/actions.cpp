// SPDX-License-Identifier: MIT
// Codes that do something at rest: dwell, tool, spindle, coolant, stop, end.
#include <algorithm>
#include <string>

#include "ipr/handlers.hpp"
#include "motion/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kCodesPerNumber = 10;  // GCode::number counts tenths

int m_number(const Task& task) { return task.code.number / kCodesPerNumber; }

void emit_action(Task& task, Action::Kind kind, double value = 0) {
  task.out.emit(Action{kind, m_number(task), value});
}

}  // namespace

/// G04 P: seconds; FANUC: milliseconds.
void dwell(Task& task) {
  const bool fanuc = task.options.dialect == Dialect::fanuc;
  if (!task.values.has('P'))
    return task.out.report(
        Code::SC2005, task.word.pos,
        fanuc ? "G04 needs P, the time in milliseconds" : "G04 needs P, the time in seconds");
  const Word& time = task.values.word('P');
  if (time.value < 0)
    return task.out.report(Code::SC2007, time.pos, "P, the time of G04, must not be negative");
  if (time.value > 0) task.out.emit(Dwell{fanuc ? s_from_ms(time.value) : time.value});
}

void set_speed(Task& task) {
  const double speed = task.word.value;
  task.modal.uncertain.remove('S');
  if (speed < 0) {
    task.out.report(Code::SC2007, task.word.pos, "S must not be negative");
    task.modal.uncertain.add('S');
    return;
  }
  const Spindle& spindle = task.machine.spindle;
  const double reached = speed == 0 ? 0 : std::clamp(speed, spindle.min_rpm, spindle.max_rpm);
  if (reached != speed && !task.modal.spindle_warned) {
    task.out.report(Code::SC2202, task.word.pos,
                    "the spindle turns at " + number_text(spindle.min_rpm) + " to " +
                        number_text(spindle.max_rpm) + " rpm; S is held within, here and below");
    task.modal.spindle_warned = true;
  }
  task.modal.spindle_speed = reached;
  if (task.modal.spindle_direction != 0 && !task.command.has(Group::spindle))
    task.out.emit(Action{Action::Kind::spindle, 0, task.modal.spindle_direction * reached});
}

void select_tool(Task& task) {
  task.modal.uncertain.remove('T');
  if (const auto number = whole_number(task, task.word))
    task.modal.tool = number;
  else
    task.modal.uncertain.add('T');
}

void change_tool(Task& task) {
  if (task.modal.tool) {
    task.modal.loaded_tool = task.modal.tool;
    return emit_action(task, Action::Kind::tool, *task.modal.tool);
  }
  report_if_certain(task, "T", Code::SC2204, task.word.pos, "M06 without a tool: T is not set");
  task.modal.uncertain.add('T');
}

void turn_spindle(Task& task) {
  constexpr int kM03 = 30, kM04 = 40;
  task.modal.spindle_direction = task.code.number == kM03 ? 1 : (task.code.number == kM04 ? -1 : 0);
  const bool on = task.modal.spindle_direction != 0;
  if (on && !task.modal.spindle_speed && !task.modal.uncertain.has('S'))
    task.out.report(Code::SC2203, task.word.pos,
                    code_name(task.code) + " without S: the spindle does not turn");
  const double speed = task.modal.spindle_speed.value_or(0);
  emit_action(task, Action::Kind::spindle, on ? task.modal.spindle_direction * speed : 0);
}

void switch_coolant(Task& task) { emit_action(task, Action::Kind::coolant); }

void stop_program(Task& task) { emit_action(task, Action::Kind::stop); }

void stop_optionally(Task& task) {
  if (task.options.optional_stop) emit_action(task, Action::Kind::stop);
}

void end_program(Task& task) {
  task.out.stop_compensation();
  emit_action(task, Action::Kind::end);
  task.modal.ended = true;
}

}  // namespace softcnc::ipr
