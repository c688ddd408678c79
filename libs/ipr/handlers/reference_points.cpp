// SPDX-License-Identifier: MIT
// G28 and G30: to a place kept in machine coordinates; G28.1 and G30.1 keep one.
#include <cstddef>
#include <optional>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kSecond = 2, kThird = 3, kFourth = 4;  // of G30 P

/// P3 and P4 of G30 are parameters of a FANUC control, which no code sets.
std::optional<AxisVector> further_home(Task& task, double number) {
  const auto& places = task.modal.state.further_homes;
  const auto& place = places[static_cast<std::size_t>(number) - kThird];
  if (!place)
    report_word(task, 'P', Code::SC2260,
                "G30 P" + number_text(number) + ": the " + (number == kThird ? "third" : "fourth") +
                    " reference point is not known");
  return place;
}

/// The reference point; nothing, after a report, if there is none.
std::optional<AxisVector> home_of(Task& task) {
  const MachineState& state = task.modal.state;
  const bool second = task.code.number != kG28;
  if (!task.values.has('P')) return second ? state.second_home : state.home;
  const Word& word = task.values.word('P');
  if (!second || !is_fanuc(task)) {
    task.out.report(Code::SC2004, word.pos, "P is not used by " + code_name(task.code));
  } else if (word.value == kSecond) {
    return state.second_home;
  } else if (word.value == kThird || word.value == kFourth) {
    return further_home(task, word.value);
  } else {
    report_word(task, 'P', Code::SC2007, "G30 takes P2, P3 or P4, the reference point");
  }
  return std::nullopt;
}

/// The axes that go: those named; all of them where none is.
LetterSet going(const Task& task) {
  LetterSet named, present;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const char letter = kAxisLetters[i];
    if (task.values.has(letter)) named.add(letter);
    if (task.machine.axes[i].present) present.add(letter);
  }
  return named.empty() ? present : named;
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

/// G28 Z0 in G90 goes to Z0 of the work first, and few mean that.
void warn_of_zero_first(Task& task) {
  Modal& modal = task.modal;
  if (modal.incremental || modal.machine_coordinates || modal.zero_reported) return;
  for (std::size_t i = 0; i < kAxes; ++i) {
    const char letter = kAxisLetters[i];
    if (!task.values.has(letter) || task.values[letter] != 0) continue;
    modal.zero_reported = true;
    const std::string word = std::string(1, letter) + "0";
    return report_word(task, letter, Code::SC2116,
                       code_name(task.code) + " " + word + " goes to " + word +
                           " of the work system first; behind G91 it goes straight");
  }
}

}  // namespace

/// By way of the point that the axis words name, both moves being rapids.
void go_home(Task& task) {
  Modal& modal = task.modal;
  const LetterSet axes = going(task);
  const auto home = home_of(task);
  if (!home) return;
  if (modal.beside && !task.values.letters().has_any(kAxisWords)) {
    modal.position = modal.beside->tool;
    modal.beside.reset();
  }
  const AxisVector between = end_point(task);
  if (between != modal.position) warn_of_zero_first(task);
  move_straight(task, between, true);
  modal.machine_coordinates = true;
  move_straight(task, reached(task, *home, axes), true);
}

void keep_home(Task& task) {
  AxisVector& home =
      task.code.number == kG281 ? task.modal.state.home : task.modal.state.second_home;
  keep_offset(task, home, task.modal.machine_position());
}

}  // namespace softcnc::ipr
