// SPDX-License-Identifier: MIT
// Which coordinates count: work systems, the machine's own, and the shifts of G52 and G92.
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kG00 = 0, kG01 = 10;  // as GCode::number
constexpr int kG54 = 540, kG59 = 590, kWhole = 10;
constexpr int kFirstTenth = 6;  // index of G59.1

AxisVector shift_in_force(const MachineState& state) {
  return state.shift_on ? state.shift : AxisVector::Zero();
}

void set_shift(Task& task, const AxisVector& shift) {
  if (!keep_offset(task, task.modal.state.shift, shift)) return;
  task.modal.state.shift_on = true;
  task.modal.update_coordinates();
}

bool names_axes(Task& task) {
  const bool named = task.values.letters().has_any(kAxisWords);
  if (!named)
    task.out.report(Code::SC2005, task.word.pos, code_name(task.code) + " needs X, Y or Z");
  return named;
}

/// G52 names axes that G92 has shifted.
void compare_shift(Task& task) {
  const AxisVector of_g92 = shift_in_force(task.modal.state) - task.modal.shift_of_g52;
  bool both = false;
  for_named_axes(task, [&](int axis, double) { both = both || of_g92[axis] != 0; });
  if (both) task.out.note_difference(DialectDifference::local_shift, task.word.pos);
}

/// G92.2 and G92.3 where G52 has shifted axes: in the fanuc dialect its shift stays.
void compare_suspension(Task& task) {
  const Modal& modal = task.modal;
  const bool shifted = !modal.local_shift.isZero(0) || !modal.shift_of_g52.isZero(0);
  if (shifted) task.out.note_difference(DialectDifference::local_shift, task.word.pos);
}

}  // namespace

/// G54 to G59, G59.1 to G59.3.
void select_work_system(Task& task) {
  const int number = task.code.number;
  task.modal.state.active =
      number > kG59 ? kFirstTenth + number - kG59 - 1 : (number - kG54) / kWhole;
  task.modal.update_coordinates();
}

/// G53.
void use_machine_coordinates(Task& task) {
  Modal& modal = task.modal;
  const GCode* motion = task.command.find(Group::motion);
  modal.machine_coordinates = true;
  if (motion == nullptr || (motion->number != kG00 && motion->number != kG01)) {
    task.out.report(Code::SC2111, task.word.pos,
                    "G53 moves by G00 or G01 only, written beside it or in force");
  } else if (modal.incremental) {
    task.out.report(Code::SC2111, task.word.pos,
                    "G53 requires G90: machine coordinates are absolute");
  }
}

/// G52: in the fanuc dialect a shift of its own, otherwise the one of G92.
void set_local_shift(Task& task) {
  if (!names_axes(task)) return;
  Modal& modal = task.modal;
  const bool own = is_fanuc_like(task.options.dialect);
  compare_shift(task);
  AxisVector shift = own ? modal.local_shift : shift_in_force(modal.state);
  for_named_axes(task, [&](int axis, double value) { shift[axis] = value; });
  if (!own) {
    for_named_axes(task, [&](int axis, double value) { modal.shift_of_g52[axis] = value; });
    return set_shift(task, shift);
  }
  if (keep_offset(task, modal.local_shift, shift)) modal.update_coordinates();
}

/// G92: the position gets the coordinates given.
void name_position(Task& task) {
  if (!names_axes(task)) return;
  compare_offsets(task);
  Modal& modal = task.modal;
  const AxisVector now = modal.coordinates.to_program(modal.position);
  AxisVector shift = shift_in_force(modal.state);
  for_named_axes(task, [&](int axis, double value) {
    shift[axis] += now[axis] - value + modal.local_shift[axis];
    modal.local_shift[axis] = modal.shift_of_g52[axis] = 0;
  });
  set_shift(task, shift);
}

/// G92.1: no shift, and none to come back to; FANUC's has it of the axes that it names, whatever
/// their values.
void clear_shift(Task& task) {
  const bool named = task.values.letters().has_any(kAxisWords);
  if (named) task.out.note_difference(DialectDifference::named_shift, task.word.pos);
  if (named && is_fanuc_like(task.options.dialect)) {
    for_named_axes(task, [&](int axis, double) {
      task.modal.local_shift[axis] = task.modal.shift_of_g52[axis] = 0;
      task.modal.state.shift[axis] = 0;
    });
    return task.modal.update_coordinates();
  }
  task.modal.local_shift.setZero();
  task.modal.shift_of_g52.setZero();
  task.modal.state.shift.setZero();
  suspend_shift(task);
}

/// G92.2
void suspend_shift(Task& task) {
  compare_suspension(task);
  task.modal.state.shift_on = false;
  task.modal.update_coordinates();
}

/// G92.3
void resume_shift(Task& task) {
  compare_suspension(task);
  task.modal.state.shift_on = true;
  task.modal.update_coordinates();
}

}  // namespace softcnc::ipr
