// SPDX-License-Identifier: MIT
// M98, M99 and G65: calls of programs by number, and the way back.
#include <cmath>
#include <string>

#include "ipr/flow/flow.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/handlers/macro_arguments.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kOldForm = 10000;  // M98 P51000: five times O1000

/// The number of the program, 0 of one that is called by name; nothing if it is missing or bad,
/// which is reported.
std::optional<int> program_number(Task& task) {
  if (!task.command.called().empty()) {
    if (task.values.has('P'))
      report_word(task, 'P', Code::SC2004, "P beside the name of the subprogram");
    return 0;
  }
  if (task.values.has('P')) return whole_number(task, task.values.word('P'));
  task.out.report(Code::SC2005, task.word.pos,
                  code_name(task.code) + " needs P, the number of the subprogram");
  return std::nullopt;
}

std::optional<int> optional_number(Task& task, char letter) {
  if (!task.values.has(letter)) return std::nullopt;
  return whole_number(task, task.values.word(letter));
}

/// In FANUC's old form P holds the count as well.
void split_old_form(Task& task, Jump& jump) {
  if (task.values.has('L') || jump.number < kOldForm) return;
  task.out.note_difference(DialectDifference::old_call, task.values.word('P').pos);
  if (task.options.dialect != Dialect::fanuc) return;
  jump.times = jump.number / kOldForm;
  jump.number %= kOldForm;
}

Jump call_of(Task& task, Jump::Kind kind, int number) {
  Jump jump;
  jump.kind = kind;
  jump.number = number;
  jump.name = task.command.called();
  jump.times = optional_number(task, 'L').value_or(1);
  jump.pos = task.word.pos;
  return jump;
}

}  // namespace

void call_program(Task& task) {
  const auto number = program_number(task);
  if (!number) return task.flow.miss_call(false);
  Jump jump = call_of(task, Jump::Kind::call, *number);
  jump.line_number = optional_number(task, 'Q');
  split_old_form(task, jump);
  task.flow.jump(std::move(jump), task.out.text());
}

/// M97: Haas' mill operator's manual, "M97 Local Sub-Program Call".
void call_lines(Task& task) {
  if (!task.values.has('P')) {
    task.out.report(Code::SC2005, task.word.pos, "M97 needs P, the number of the line N to call");
    return task.flow.miss_call(false);
  }
  const auto number = whole_number(task, task.values.word('P'));
  if (!number) return task.flow.miss_call(false);
  task.flow.jump(call_of(task, Jump::Kind::call_lines, *number), task.out.text());
}

void call_macro(Task& task) {
  const auto number = program_number(task);
  auto arguments = macro_arguments(task);
  if (!number || !arguments) return task.flow.miss_call(true);
  Jump jump = call_of(task, Jump::Kind::call_macro, *number);
  jump.arguments = std::move(*arguments);
  task.flow.jump(std::move(jump), task.out.text());
}

void refuse_modal_macro(Task& task) {
  task.out.report(Code::SC2315, task.word.pos,
                  code_name(task.code) +
                      " is not supported: what it would call after every move "
                      "cannot be seen in the lines themselves");
}

void leave_program(Task& task) {
  Jump jump;
  jump.kind = Jump::Kind::leave;
  jump.line_number = optional_number(task, 'P');
  jump.pos = task.word.pos;
  if (jump.line_number && task.flow.in_subprogram())
    task.out.note_difference(DialectDifference::leave_to_line, task.values.word('P').pos);
  const bool nowhere = task.values.has('P') && !jump.line_number;  // reported
  if (nowhere && !task.flow.in_subprogram())
    task.modal.ended = true;
  else
    task.flow.jump(std::move(jump), task.out.text());
}

}  // namespace softcnc::ipr
