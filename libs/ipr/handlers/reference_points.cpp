// SPDX-License-Identifier: MIT
// G28 and G30: to a place kept in machine coordinates; G28.1 and G30.1 keep one.
#include <string>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kG28 = 280, kG281 = 281;
constexpr int kSecond = 2;  // of G30 P

/// G30 P2 is G30; third and fourth points there are none.
bool check_point(Task& task) {
  if (!task.values.has('P')) return true;
  const Word& word = task.values.word('P');
  const bool may_choose = task.options.dialect == Dialect::fanuc && task.code.number != kG28;
  if (!may_choose) {
    task.out.report(Code::SC2004, word.pos, "P is not used by " + code_name(task.code));
  } else if (word.value != kSecond) {
    report_word(task, 'P', Code::SC2007, "G30 takes P2: there is no other reference point");
  } else {
    return true;
  }
  return false;
}

/// The axes that go: those named; all of them where none is, except in the fanuc dialect.
LetterSet going(Task& task) {
  LetterSet named, present;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const char letter = kAxisLetters[i];
    if (task.values.has(letter)) named.add(letter);
    if (task.machine.axes[i].present) present.add(letter);
  }
  if (!named.empty()) return named;
  if (task.options.dialect != Dialect::fanuc) return present;
  task.out.report(Code::SC2005, task.word.pos, code_name(task.code) + " needs the axes that go");
  return {};
}

/// In coordinates of the program, where a rotated work system turns the axes.
AxisVector reached(const Task& task, const AxisVector& home, LetterSet axes) {
  const Coordinates& coordinates = task.modal.coordinates;
  const bool turned = coordinates.rotated();
  const AxisVector& position = task.modal.position;
  const AxisVector there = turned ? coordinates.to_program(home) : home;
  AxisVector end = turned ? coordinates.to_program(position) : position;
  for (int i = 0; i < kAxes; ++i)
    if (axes.has(axis_letter(i))) end[i] = there[i];
  return turned ? coordinates.to_machine(end) : end;
}

}  // namespace

/// By way of the point that the axis words name, both moves being rapids.
void go_home(Task& task) {
  Modal& modal = task.modal;
  const LetterSet axes = going(task);
  if (!check_point(task) || axes.empty()) return;
  if (modal.beside && !task.values.letters().has_any(kAxisWords)) {
    modal.position = modal.beside->tool;
    modal.beside.reset();
  }
  const AxisVector between = end_point(task);
  const AxisVector& home = task.code.number == kG28 ? modal.state.home : modal.state.second_home;
  move_straight(task, between, true);
  move_straight(task, reached(task, home, axes), true);
}

void keep_home(Task& task) {
  AxisVector& home =
      task.code.number == kG281 ? task.modal.state.home : task.modal.state.second_home;
  keep_offset(task, home, task.modal.machine_position());
}

}  // namespace softcnc::ipr
