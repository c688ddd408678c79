// SPDX-License-Identifier: MIT
// Codes that do something at rest: dwell, tool, spindle, coolant, stop, end.
#include <algorithm>
#include <string>
#include <utility>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

int m_number(const Task& task) { return task.code.number / kCodesPerNumber; }

void emit_action(Task& task, Action::Kind kind, double value = 0) {
  task.out.emit(Action{kind, m_number(task), value});
}

void stop_spindle(Task& task) {
  if (std::exchange(task.modal.spindle_direction, 0) != 0) emit_action(task, Action::Kind::spindle);
}

std::optional<int> known_tool(Task& task, const Word& word) {
  const auto number = word.letter == 'T' ? whole_number(task.out, word) : whole_number(task, word);
  if (!number || tools_of(task).find(*number)) return number;
  report_unknown_tool(task, *number, word.pos);
  return std::nullopt;
}

/// The time of G04 in seconds. The fanuc dialect: X or U in seconds, or P in milliseconds.
double dwell_time(const Task& task, const Word& word) {
  return counts_milliseconds(task, word) ? s_from_ms(word.value) : word.value;
}

const Word* dwell_word(const Task& task) {
  for (const char letter : {'P', 'X', 'U'}) {
    const bool taken = letter == 'P' || is_fanuc(task);
    if (taken && task.values.has(letter)) return &task.values.word(letter);
  }
  return nullptr;
}

/// Seconds where milliseconds count, or the other way round, by the looks of the number.
bool looks_like_other_unit(const Task& task, const Word& word) {
  constexpr double kLongSeconds = 200, kShortMilliseconds = 10;
  const bool point = has_point(task, word);
  return counts_milliseconds(task, word) ? point && word.value < kShortMilliseconds
                                         : !point && word.value >= kLongSeconds;
}

void check_dwell_unit(Task& task, const Word& word) {
  if (task.modal.dwell_warned || !looks_like_other_unit(task, word)) {
    if (word.letter != 'P') return;
    const bool by_point = is_fanuc(task) && !counts_milliseconds(task, word);
    return task.out.note_difference(
        by_point ? DialectDifference::dwell_with_point : DialectDifference::dwell, word.pos);
  }
  const std::string letter(1, word.letter), number = number_text(word.value);
  task.out.report(Code::SC2210, word.pos,
                  counts_milliseconds(task, word)
                      ? "G04 " + letter + " counts milliseconds here: " + number + " ms; " +
                            number + " s are " + letter + number_text(word.value * 1000)
                      : "G04 " + letter + " counts seconds here: " + number + " s; " + number +
                            " ms are " + letter + number_text(s_from_ms(word.value)));
  task.modal.dwell_warned = true;
}

}  // namespace

void dwell(Task& task) {
  const bool fanuc = is_fanuc(task);
  const Word* time = dwell_word(task);
  if (time == nullptr)
    return task.out.report(
        Code::SC2005, task.word.pos,
        fanuc ? "G04 needs P, the time in milliseconds, or X or U, the time in seconds"
              : "G04 needs P, the time in seconds");
  if (time->value < 0)
    return task.out.report(
        Code::SC2007, time->pos,
        std::string(1, time->letter) + ", the time of G04, must not be negative");
  if (time->value == 0) return;
  if (dwell_time(task, *time) > kLongestDwell)
    return task.out.report(
        Code::SC2007, time->pos,
        std::string(1, time->letter) + ", the time of G04, must be 1000000000 s at most");
  check_dwell_unit(task, *time);
  task.out.emit(Dwell{dwell_time(task, *time)});
}

void set_speed(Task& task) {
  const double speed = task.word.value;
  if (!is_not_negative(task.out, task.word)) return;
  const Spindle& spindle = task.machine.spindle;
  const double reached = speed == 0 ? 0 : std::clamp(speed, spindle.min_rpm, spindle.max_rpm);
  if (reached != speed && !task.modal.spindle_warned) {
    task.out.report(Code::SC2202, task.word.pos,
                    "S" + number_text(speed) + " is outside the spindle's " +
                        number_text(spindle.min_rpm) + " to " + number_text(spindle.max_rpm) +
                        " rpm; from here on S is held within them");
    task.modal.spindle_warned = true;
  }
  task.modal.spindle_speed = reached;
  if (task.modal.spindle_direction != 0 && !task.command.has(Group::spindle))
    task.out.emit(Action{Action::Kind::spindle, 0, task.modal.spindle_direction * reached});
}

void select_tool(Task& task) {
  if (const auto number = known_tool(task, task.word)) task.modal.tool = number;
}

/// M06 stops the spindle before the tool is changed, as on LinuxCNC.
void change_tool(Task& task) {
  task.modal.surface.reset();
  if (task.modal.tool) {
    stop_spindle(task);
    task.modal.state.loaded_tool = task.modal.tool;
    return emit_action(task, Action::Kind::tool, *task.modal.tool);
  }
  task.out.report(Code::SC2204, task.word.pos, "M06 without a tool: T is not set");
}

/// M61 Q: the tool that is in the spindle.
void name_tool(Task& task) {
  if (!task.values.has('Q'))
    return task.out.report(Code::SC2005, task.word.pos, "M61 needs Q, the tool in the spindle");
  const auto number = known_tool(task, task.values.word('Q'));
  if (!number) return;
  task.modal.state.loaded_tool = *number;
  task.modal.tool = number;
  emit_action(task, Action::Kind::tool, *number);
}

void turn_spindle(Task& task) { turn_spindle_as(task, m_number(task)); }

void turn_spindle_as(Task& task, int number) {
  task.modal.spindle_direction = number == kSpindleCw ? 1 : (number == kSpindleCcw ? -1 : 0);
  const bool on = task.modal.spindle_direction != 0;
  if (on && !task.modal.spindle_speed)
    task.out.report(Code::SC2203, task.word.pos,
                    code_name(task.code) + " without S: the spindle does not turn");
  const double speed = task.modal.spindle_speed.value_or(0);
  emit_action(task, Action::Kind::spindle, on ? task.modal.spindle_direction * speed : 0);
}

void switch_coolant(Task& task) { switch_coolant_as(task, m_number(task)); }

void switch_coolant_as(Task& task, int number) {
  task.modal.mist = number == kMist || (number == kFlood && task.modal.mist);
  task.modal.flood = number == kFlood || (number == kMist && task.modal.flood);
  const bool own = m_number(task) == number;
  emit_action(task, Action::Kind::coolant, own ? 0 : number);
}

void stop_program(Task& task) { emit_action(task, Action::Kind::stop); }

void stop_optionally(Task& task) {
  if (task.options.optional_stop) emit_action(task, Action::Kind::stop);
}

void end_program(Task& task) {
  task.out.stop_compensation();
  emit_action(task, Action::Kind::end);
  task.modal.state.active = 0;
  task.modal.ended = true;
}

}  // namespace softcnc::ipr
