// SPDX-License-Identifier: MIT
// What the handlers share: coordinates, feed, whole numbers, places.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kSameStart = 0.001;         // mm
constexpr double kLargestWhole = 999999999;  // as many digits as a number may have

}  // namespace

namespace {

/// Such a place that a transformation leads from it to the one that the words name.
AxisVector end_in_machine(const Task& task) {
  AxisVector end = task.modal.machine_position();
  for (int i = 0; i < kAxes; ++i) {
    const char letter = axis_letter(i);
    if (!task.values.has(letter)) continue;
    end[i] = task.values[letter] * task.modal.mm_per_unit;
  }
  return task.modal.unplaced(end);
}

}  // namespace

namespace {

PathMode path_mode_of(const Modal& modal) {
  return modal.stops_once ? PathMode::stop : modal.path_mode;
}
bool is_exact(const Modal& modal) { return modal.stops_once || modal.exact_path; }
std::int16_t system_of_place(const Modal& modal) {
  return modal.machine_coordinates ? kNoSystem : static_cast<std::int16_t>(modal.state.active);
}

/// F was 0: reported at it, if it stands on the line. Returns false.
[[gnu::cold]] bool report_zero_feed(Task& task) {
  const bool here = task.command.has(Group::feed);
  task.out.report(Code::SC2102, here ? task.command.find_word(Group::feed).pos : task.word.pos,
                  code_name(task.code) + " needs a feed above 0, and F is 0");
  return false;
}

[[gnu::cold]] void report_no_feed(Task& task) {
  task.out.report(Code::SC2102, task.word.pos,
                  code_name(task.code) + " needs a feed, and F is not set");
}

/// Only moves whose length is known on their line have a time of their own.
bool has_inverse_time(Task& task) {
  const int number = task.code.number;
  if (number != kG01 && number != kG02 && number != kG03) {
    task.out.report(Code::SC2220, task.word.pos,
                    code_name(task.code) + " while G93 is in force: F cannot be its time");
    return false;
  }
  if (task.command.has(Group::feed)) {
    if (task.modal.feed_word > 0) return true;
    if (task.modal.zero_feed) return report_zero_feed(task);
  }
  task.out.report(Code::SC2102, task.word.pos,
                  code_name(task.code) + " needs F on its own line while G93 is in force");
  return false;
}

bool sets_feed_per_turn(Task& task) {
  Modal& modal = task.modal;
  const double speed = modal.spindle_direction == 0 ? 0 : modal.spindle_speed.value_or(0);
  modal.feed = speed > 0 ? held_feed(task, mm_s_from_mm_min(modal.feed_word * speed)) : 0;
  if (speed > 0) return true;
  task.out.report(Code::SC2222, task.word.pos,
                  code_name(task.code) + " by G95 needs a spindle that turns");
  modal.unknown |= {Part::speed, Part::spindle};
  return false;
}

}  // namespace

void compare_offsets(const Task& task) {
  if (!task.modal.coordinates_there) return;
  const Coordinates &here = task.modal.coordinates, &there = *task.modal.coordinates_there;
  const bool turned = here.rotated() || there.rotated();
  for (int i = 0; i < kAxes; ++i) {
    const char letter = axis_letter(i);
    if (!task.values.has(letter) || (!turned && here.sum()[i] == there.sum()[i])) continue;
    return task.out.note_difference(DialectDifference::assigned_offset,
                                    task.values.word(letter).pos);
  }
}

namespace {

AxisVector end_in_program(const Task& task) {
  if (!task.modal.incremental) compare_offsets(task);
  const Coordinates& coordinates = task.modal.coordinates;
  const AxisVector& position = task.modal.position;
  AxisVector end = coordinates.rotated() ? coordinates.to_program(position) : position;
  const AxisVector zero = coordinates.rotated() ? AxisVector::Zero() : coordinates.sum();
  bool named = false;
  for (int i = 0; i < kAxes; ++i) {
    const char letter = axis_letter(i);
    if (!task.values.has(letter)) continue;
    const double value = task.values[letter] * task.modal.mm_per_unit;
    end[i] = task.modal.incremental ? end[i] + value : zero[i] + value;
    named = true;
  }
  if (!coordinates.rotated()) return end;
  return named ? coordinates.to_machine(end) : position;
}

}  // namespace

bool has_word(Task& task, char letter, std::string_view what) {
  if (task.values.has(letter)) return true;
  task.out.report(Code::SC2005, task.word.pos,
                  code_name(task.code) + " needs " + letter + ", " + std::string(what));
  return false;
}

bool has_point(const Task& task, const Word& word) {
  const auto column = static_cast<std::size_t>(word.pos.column) - 1;
  const auto length = static_cast<std::size_t>(word.pos.length);
  return task.out.text().substr(column, length).find('.') != std::string_view::npos;
}

bool counts_milliseconds(const Task& task, const Word& dwell) {
  if (dwell.letter != 'P' || !is_fanuc(task)) return false;
  return !is_haas(task) || !has_point(task, dwell);
}

SourcePos place_of(const Task& task, char letter) {
  return task.values.has(letter) ? task.values.word(letter).pos : task.word.pos;
}

[[gnu::hot]] AxisVector end_point(const Task& task) {
  return near_place(task,
                    task.modal.machine_coordinates ? end_in_machine(task) : end_in_program(task));
}

[[gnu::hot]] void emit_move(Task& task, Path&& path, bool rapid) {
  Modal& modal = task.modal;
  modal.beside.reset();
  if (modal.placement &&
      !place_path(modal, task.out, {task.word.pos, {}, code_name(task.code)}, path))
    return;
  if (!task.machine.contacts.empty()) warn_of_contact(task, path);
  if (!rapid && modal.feed_mode == FeedMode::inverse_time)
    modal.feed = held_feed(task, mm_s_from_mm_min(length(path) * modal.feed_word));
  if (!rapid) {
    if (!has_surface_speed(modal, task.out, task.word.pos, task.out.text())) return;
    return task.out.emit(cutting_move(modal, std::move(path), modal.feed));
  }
  task.out.emit(Move{std::move(path), true, 0, path_mode_of(modal), modal.corner_tolerance,
                     modal.chord_tolerance, modal.feed_override, std::nullopt, is_exact(modal),
                     modal.speed_override, system_of_place(modal)});
}

[[gnu::hot]] Move cutting_move(const Modal& modal, Path&& path, double feed) {
  return {std::move(path),
          false,
          feed * modal.adaptive_feed,
          path_mode_of(modal),
          modal.corner_tolerance,
          modal.chord_tolerance,
          modal.feed_override,
          surface_at_speed(modal),
          is_exact(modal),
          modal.speed_override,
          system_of_place(modal)};
}

[[gnu::hot]] bool has_feed(Task& task) {
  Modal& modal = task.modal;
  if (modal.feed_mode == FeedMode::inverse_time) return has_inverse_time(task);
  if (modal.feed_mode == FeedMode::per_turn && modal.feed_word > 0) return sets_feed_per_turn(task);
  if (modal.feed > 0) return true;
  modal.zero_feed ? static_cast<void>(report_zero_feed(task)) : report_no_feed(task);
  modal.unknown.add(Part::feed);
  return false;
}

bool has_plane_axes(Task& task, const PlaneAxes& axes) {
  for (const int axis : {axes.first, axes.second}) {
    const auto index = static_cast<std::size_t>(axis);
    if (task.machine.axes[index].present) continue;
    task.out.report(Code::SC2008, task.word.pos,
                    code_name(task.code) + " needs axis " + kAxisLetters[index] +
                        ", which the machine does not have");
    return false;
  }
  return true;
}

CurveHead curve_head(Task& task) {
  has_feed(task);
  return {task.modal.feed, task.out.source(), task.word.pos, std::string(task.out.text())};
}

void report_too_many(Task& task) {
  task.out.report(Code::SC3120, span_of(task.values, "XYZ"),
                  "a curve has " + std::to_string(kMostCurvePoints) + " control points at most");
}

double start_tolerance(const Machine& machine) {
  double tolerance = kSameStart;
  for (const Axis& axis : machine.axes)
    if (axis.present) tolerance = std::max(tolerance, axis.blu);
  return tolerance;
}

bool ends_curve(const Command& command, const GCode& curve) noexcept {
  if (command.has(Group::cycle) || command.has(Group::stopping)) return true;
  const auto is_other = [&](const Command::CodeWord& code) {
    return code.code->group == Group::motion && code.code != &curve;
  };
  return std::any_of(command.codes().begin(), command.codes().end(), is_other);
}

void begin_motion(Task& task) {
  task.modal.motion = &task.code;
  if (!is_canned_cycle(task.code))
    task.modal.motion_below = is_line_or_arc(task.code) ? &task.code : nullptr;
}

bool fanuc_goes_home(const Command& command, Dialect dialect) noexcept {
  const GCode* code = command.find(Group::non_modal);
  if (!is_fanuc_like(dialect) || code == nullptr) return false;
  return code->number == kG28 || code->number == kG30;
}

std::optional<int> whole_from(double least, double value) noexcept {
  const bool whole = value >= least && value <= kLargestWhole && value == std::floor(value);
  return whole ? std::optional(static_cast<int>(value)) : std::nullopt;
}

namespace {

std::string takes_whole_number(const Word& word) {
  return std::string(1, word.letter) + " takes a whole number " +
         (word.value > kLargestWhole ? "up to 999999999" : "from 0");
}

}  // namespace

std::optional<int> whole_number(Output& out, const Word& word) {
  const auto number = whole_from(0, word.value);
  if (!number) out.report(Code::SC2007, word.pos, takes_whole_number(word));
  return number;
}

std::optional<int> whole_number(Task& task, const Word& word) {
  const auto number = whole_from(0, word.value);
  if (!number) report_word(task, word.letter, Code::SC2007, takes_whole_number(word));
  return number;
}

bool is_not_negative(Output& out, const Word& word) {
  if (word.value >= 0) return true;
  out.report(Code::SC2007, word.pos, std::string(1, word.letter) + " must not be negative");
  return false;
}

void report_word(const Task& task, char letter, Code code, std::string message) {
  task.out.report(code, place_of(task, letter), std::move(message));
}

SourcePos span_of(const Values& values, std::string_view letters) noexcept {
  SourcePos span;
  int end = 0;
  for (const char letter : letters) {
    if (!values.has(letter)) continue;
    const SourcePos& pos = values.word(letter).pos;
    span.column = span.line == 0 ? pos.column : std::min(span.column, pos.column);
    span.line = pos.line;
    span.file = pos.file;
    end = std::max(end, pos.column + pos.length);
  }
  span.length = std::max(1, end - span.column);
  return span;
}

std::string above_limit(const std::string& feed, double limit) {
  const std::string most = number_text(mm_min_from_mm_s(limit));
  return feed + " exceeds the machine's " + most + " mm/min; " + most + " is used from here on";
}

}  // namespace softcnc::ipr
