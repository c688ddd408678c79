// SPDX-License-Identifier: MIT
// Which coordinates count: work systems, the machine's own, and the shifts of G52 and G92.
#include <optional>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kMostOfHaas = 99;  // G154 P

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

void select_system(Task& task, int index) {
  task.modal.state.active = index;
  task.modal.update_coordinates();
}

/// The code beside this one that takes P, or nullptr if there is none.
const GCode* other_user_of_p(const Task& task) {
  const bool fanuc = is_fanuc(task);
  for (const auto& [code, word] : task.command.codes()) {
    if (code == &task.code) continue;
    const bool takes =
        LetterSet(code->words).has('P') || (fanuc && LetterSet(code->fanuc_words).has('P'));
    if (takes) return code;
  }
  return nullptr;
}

/// P of G54.1 and G154: FANUC takes the first system without it, and forbids codes beside it that
/// take P.
std::optional<int> further_number(Task& task) {
  const bool of_haas = task.code.number == kG154;
  if (!task.values.has('P') && !of_haas) return 1;
  if (!task.values.has('P')) {
    task.out.report(Code::SC2005, task.word.pos, "G154 needs P, the work system");
    return std::nullopt;
  }
  if (const GCode* other = other_user_of_p(task)) {
    report_word(task, 'P', Code::SC2266,
                "P may belong to " + code_name(task.code) + " or to " + code_name(*other));
    return std::nullopt;
  }
  const auto number = whole_number(task, task.values.word('P'));
  const int most = of_haas ? kMostOfHaas : kFurtherSystems;
  if (!number || (*number >= 1 && *number <= most)) return number;
  report_word(
      task, 'P', Code::SC2007,
      code_name(task.code) + " takes P from 1 to " + std::to_string(most) + ", the work system");
  return std::nullopt;
}

}  // namespace

/// G54 to G59, G59.1 to G59.3. In the fanuc dialect G54 P is G54.1 P, unless another code of the
/// line takes P.
void select_work_system(Task& task) {
  const int number = task.code.number;
  const bool further =
      number == kG54 && is_fanuc(task) && task.values.has('P') && other_user_of_p(task) == nullptr;
  if (further) return select_further_system(task);
  select_system(task, system_index(number));
}

/// G54.1 P, G154 P, G110 to G129.
void select_further_system(Task& task) {
  const int code = task.code.number;
  const bool by_code = code >= kG110 && code < kG154;
  const auto number =
      by_code ? std::optional((code - kG110) / kCodesPerNumber + 1) : further_number(task);
  if (number) select_system(task, kWorkSystems + *number - 1);
}

/// G53. On Haas' controls it leaves G91 and transformations for its line, and moves nothing without
/// axes.
void use_machine_coordinates(Task& task) {
  Modal& modal = task.modal;
  const bool haas = is_haas(task);
  const GCode* motion = task.command.find(Group::motion);
  modal.machine_coordinates = true;
  if (haas && !task.values.letters().has_any(kAxisWords)) return;
  if (motion == nullptr || (motion->number != kG00 && motion->number != kG01)) {
    task.out.report(Code::SC2111, task.word.pos,
                    task.values.letters().has_any(kAxisWords)
                        ? "G53 moves by G00 or G01 only, written beside it or in force"
                        : "G53 counts for its own line only, and this one names no axis");
  } else if (modal.incremental && !haas) {
    task.out.report(Code::SC2111, task.word.pos,
                    "G53 requires G90: machine coordinates are absolute");
  }
}

/// G52: in the fanuc dialect a shift of its own, otherwise the one of G92.
void set_local_shift(Task& task) {
  if (!names_axes(task)) return;
  Modal& modal = task.modal;
  const bool own = is_fanuc(task);
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
  if (named && is_fanuc(task)) {
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
