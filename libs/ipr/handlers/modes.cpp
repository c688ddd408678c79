// SPDX-License-Identifier: MIT
// Codes that change how later words are read: plane, units, distance, path control, feed.
#include <string>
#include <utility>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

void set_path_mode(Modal& modal, PathMode mode, double corner, double chord, bool exact) {
  modal.path_mode = mode;
  modal.corner_tolerance = corner;
  modal.chord_tolerance = chord;
  modal.exact_path = exact;
}

/// A tolerance in mm, of G64 or G187.
double tolerance(Task& task, char letter, double otherwise) {
  if (!task.values.has(letter)) return otherwise;
  const Word& word = task.values.word(letter);
  const double given = word.value * task.modal.mm_per_unit;
  if (given >= 0 && is_near(given)) return given;
  task.out.report(Code::SC2007, word.pos,
                  std::string(1, letter) + ", a tolerance of " + code_name(task.code) + ", must " +
                      (given < 0 ? "not be negative" : "be 1000000 mm at most"));
  return otherwise;
}

/// R, which programs for versions of LinuxCNC after 2.9 may have; it may be of a motion beside G64.
void note_corner_radius(Task& task) {
  if (!task.values.has('R') || task.modal.corner_radius_reported) return;
  for (const auto& [code, word] : task.command.codes())
    if (code != &task.code && LetterSet(code->words).has('R')) return;
  task.modal.corner_radius_reported = true;
  task.out.report(Code::SC2170, task.values.word('R').pos,
                  "R of G64 has no effect: P and Q alone say how far the path may deviate");
}

/// False, after a report, if no machine could keep it.
bool is_possible_feed(Task& task, double feed) {
  constexpr double kLeast = 1e-6, kMost = 1e9;  // mm/min
  const double per_minute = mm_min_from_mm_s(feed);
  if (feed == 0 || (per_minute >= kLeast && per_minute <= kMost)) return true;
  const bool given = task.command.has(Group::feed);
  task.out.report(Code::SC2007, given ? task.command.find_word(Group::feed).pos : task.word.pos,
                  std::string("a feed ") +
                      (per_minute < kLeast ? "below 0.000001" : "above 1000000000") + " mm/min");
  return false;
}

}  // namespace

void select_plane(Task& task) { task.modal.plane = selected_plane(task.code); }

void use_inches(Task& task) { task.modal.mm_per_unit = kMmPerInch; }
void use_millimetres(Task& task) { task.modal.mm_per_unit = 1; }

void use_absolute(Task& task) { task.modal.incremental = false; }
void use_incremental(Task& task) { task.modal.incremental = true; }

void use_absolute_centres(Task& task) { task.modal.absolute_centres = true; }
void use_incremental_centres(Task& task) { task.modal.absolute_centres = false; }

/// G61: FANUC's is G09 in every block.
void follow_exactly(Task& task) {
  task.out.note_difference(DialectDifference::exact_stop, task.word.pos);
  const bool fanuc = is_fanuc(task);
  set_path_mode(task.modal, fanuc ? PathMode::stop : PathMode::follow, 0, 0, true);
}

void stop_exactly(Task& task) { set_path_mode(task.modal, PathMode::stop, 0, 0, true); }

/// G09.
void stop_once(Task& task) { task.modal.stops_once = true; }

/// G64 P Q; Q is P where it is missing, whether P is written or the machine's.
void follow_path_within(Task& task) {
  note_corner_radius(task);
  const double corner = tolerance(task, 'P', task.machine.control.corner_tolerance);
  const double chord = tolerance(task, 'Q', corner);
  set_path_mode(task.modal, PathMode::follow, corner, chord, false);
}

/// The tolerance of the machine for smoothing, or that for corners; not where a path is followed
/// exactly.
void switch_smoothing(Task& task, bool on) {
  Modal& modal = task.modal;
  const Control& control = task.machine.control;
  const double tolerance = on ? control.smoothing_tolerance : control.corner_tolerance;
  if (modal.exact_path || modal.path_mode == PathMode::stop) return;
  set_path_mode(modal, PathMode::follow, tolerance, tolerance, false);
}

/// G187: E is the tolerance, P alone asks for that of the machine, and without both it is that for
/// corners again.
void smooth_path(Task& task) {
  const Control& control = task.machine.control;
  const Values& values = task.values;
  if (const double level = values.value_or('P', 1); level != 1 && level != 2 && level != 3)
    return task.out.report(Code::SC2007, values.word('P').pos, "G187 takes P1, P2 or P3");
  if (values.has('P') && !values.has('E') && control.smoothing_tolerance == 0)
    return pass_over(task);
  if (!values.has('E')) return switch_smoothing(task, values.has('P'));
  const double within = tolerance(task, 'E', control.corner_tolerance);
  Modal& modal = task.modal;
  if (modal.exact_path || modal.path_mode == PathMode::stop) return;
  set_path_mode(modal, PathMode::follow, within, within, false);
}

/// M48 on, M49 off; M50 P of the feed, M51 P of the spindle alone.
void switch_override(Task& task) {
  const int number = task.code.number;
  const bool on = number == kM48 || (number != kM49 && task.values.value_or('P', 1) != 0);
  if (number != kM51) task.modal.feed_override = on;
  if (number != kM50) task.modal.speed_override = on;
}

/// A change of mode leaves F unset.
void select_feed_mode(Task& task) {
  const FeedMode mode = task.code.number == kG93   ? FeedMode::inverse_time
                        : task.code.number == kG95 ? FeedMode::per_turn
                                                   : FeedMode::per_minute;
  if (mode == std::exchange(task.modal.feed_mode, mode)) return;
  task.modal.feed = task.modal.feed_word = 0;
  task.modal.zero_feed = false;
}

void refuse_surface_speed(Task& task) {
  task.out.report(Code::SC2221, task.word.pos,
                  "G96 needs work that turns: on a mill no radius is known");
}

/// A feed in mm/s: the word, and what it stands for where that is another number of mm/min.
std::string feed_text(const Task& task, double feed) {
  const double asked = mm_min_from_mm_s(feed);
  const std::string in_mm_min = number_text(asked) + " mm/min";
  if (task.word.letter != 'F' || task.modal.feed_mode != FeedMode::per_minute)
    return "a feed of " + in_mm_min;
  return "F" + number_text(task.word.value) +
         (task.modal.mm_per_unit == 1 ? "" : ", " + in_mm_min + ",");
}

/// mm/s, held at the machine's limit.
[[gnu::hot]] double held_feed(Task& task, double feed) {
  const double limit = task.machine.limits.feed;
  if (limit <= 0 || feed <= limit) return is_possible_feed(task, feed) ? feed : 0;
  if (!task.modal.feed_warned)
    task.out.report(Code::SC2201, task.word.pos, above_limit(feed_text(task, feed), limit));
  task.modal.feed_warned = true;
  return limit;
}

void set_feed(Task& task) {
  Modal& modal = task.modal;
  modal.feed = modal.feed_word = 0;
  if (!is_not_negative(task.out, task.word)) return;
  if (task.word.value == 0) modal.zero_feed = true;
  const double length = task.word.value * modal.mm_per_unit;
  if (modal.feed_mode == FeedMode::per_minute)
    modal.feed = held_feed(task, mm_s_from_mm_min(length));
  else
    modal.feed_word = modal.feed_mode == FeedMode::per_turn ? length : task.word.value;
}

}  // namespace softcnc::ipr
