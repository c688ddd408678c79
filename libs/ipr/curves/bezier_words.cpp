// SPDX-License-Identifier: MIT
// G05 and G05.1 of LinuxCNC: a cubic or quadratic Bezier curve in a line, in the plane in force. To
// FANUC both are switches of the look-ahead.
#include <optional>
#include <string>
#include <vector>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

/// The letters of two words that lead along the first and the second axis of the plane.
struct Pair {
  char first, second;
};

Pair start_letters(const PlaneAxes& axes) {
  return {offset_letter(axes.first), offset_letter(axes.second)};
}

std::string names(Pair pair) { return {pair.first, ' ', 'a', 'n', 'd', ' ', pair.second}; }

bool has_both(const Values& values, Pair pair) {
  return values.has(pair.first) && values.has(pair.second);
}

/// G05 P10000, G05.1 Q1: what FANUC's switches of the look-ahead look like.
bool is_switch(const Task& task) {
  const LetterSet words = task.values.letters();
  if (words.has_any("IJK")) return false;
  if (task.code.number == kG05)
    return words.has('P') && !words.has('Q') && !words.has_any(kAxisWords);
  const bool fanuc = is_fanuc_like(task.options.dialect);
  return words.has('Q') && !(fanuc && words.has_any(kAxisWords));
}

void note_switch(Task& task) {
  if (task.modal.look_ahead_reported) return;
  task.modal.look_ahead_reported = true;
  task.out.report(
      Code::SC3115, task.word.pos,
      code_name(task.code) + " has no effect: softcnc looks ahead over the whole program anyway");
}

/// G05.1 Q1 and Q0 switch smoothing, if the machine has a tolerance for that.
void use_switch(Task& task) {
  const bool smooths = task.code.number == kG051 && task.machine.control.smoothing_tolerance > 0;
  smooths ? switch_smoothing(task, task.values.value_or('Q', 0) != 0) : note_switch(task);
}

/// No word of the line leads out of the plane, and one leads to an end.
bool is_in_plane(Task& task, const PlaneAxes& axes) {
  const Values& values = task.values;
  bool across = false;
  for (const char letter : {axis_letter(axes.across), offset_letter(axes.across)}) {
    if (!values.has(letter)) continue;
    report_word(task, letter, Code::SC3117,
                std::string(1, letter) + " lies across the plane of the curve");
    across = true;
  }
  if (across) return false;
  if (values.has(axis_letter(axes.first)) || values.has(axis_letter(axes.second))) return true;
  task.out.report(Code::SC2005, task.word.pos,
                  code_name(task.code) + " needs its end, " + axis_letter(axes.first) + " or " +
                      axis_letter(axes.second));
  return false;
}

bool needs_both(Task& task, Pair pair) {
  if (has_both(task.values, pair)) return true;
  task.out.report(Code::SC2005, task.word.pos, code_name(task.code) + " needs both " + names(pair));
  return false;
}

/// The offset that two words give, mm, in machine coordinates.
AxisVector offset_of(const Task& task, const PlaneAxes& axes, Pair pair) {
  AxisVector offset = AxisVector::Zero();
  offset[axes.first] = task.values.value_or(pair.first, 0) * task.modal.mm_per_unit;
  offset[axes.second] = task.values.value_or(pair.second, 0) * task.modal.mm_per_unit;
  return task.modal.coordinates.direction(offset);
}

void emit_bezier(Task& task, std::vector<AxisVector> control) {
  const std::size_t order = control.size();
  NurbsSpec spec;
  spec.degree = static_cast<int>(order) - 1;
  spec.weights.assign(order, 1);
  spec.knots.assign(order, 0);
  spec.knots.insert(spec.knots.end(), order, 1);
  spec.control = std::move(control);
  Result<Nurbs> made = Nurbs::make(std::move(spec));
  if (made) return emit_move(task, std::move(*made));
  task.out.report(made.error().code, task.word.pos, std::move(made.error().message));
}

/// From the position to the first control point: as written, or on from the G05 before. Nothing,
/// after a report, if neither leads anywhere.
std::optional<AxisVector> first_handle(Task& task, const PlaneAxes& axes, bool goes_on) {
  const Pair start = start_letters(axes);
  const LetterSet words = task.values.letters();
  if (words.has(start.first) || words.has(start.second)) {
    if (!needs_both(task, start)) return std::nullopt;
    return offset_of(task, axes, start);
  }
  if (goes_on) return task.modal.curve_end->handle;
  task.out.report(Code::SC3118, task.word.pos,
                  "G05 without " + names(start) + " must follow a G05");
  return std::nullopt;
}

bool follows_cubic(const Task& task) {
  const Modal& modal = task.modal;
  return modal.motion == &task.code && modal.curve_end && modal.curve_end->plane == modal.plane &&
         modal.curve_end->position == modal.position;
}

void cubic_curve(Task& task, const PlaneAxes& axes, const AxisVector& to) {
  const bool goes_on = follows_cubic(task);
  if (!needs_both(task, {'P', 'Q'})) return;
  const auto handle = first_handle(task, axes, goes_on);
  if (!handle) return;
  const AxisVector& from = task.modal.position;
  emit_bezier(task, {from, from + *handle, to + offset_of(task, axes, {'P', 'Q'}), to});
}

void quadratic_curve(Task& task, const PlaneAxes& axes, const AxisVector& to) {
  const Pair start = start_letters(axes);
  if (!needs_both(task, start)) return;
  const AxisVector& from = task.modal.position;
  emit_bezier(task, {from, from + offset_of(task, axes, start), to});
}

/// What the dialects make of it: a curve is drawn only where true is returned.
bool is_known_as_curve(Task& task) {
  const bool fanuc = is_fanuc_like(task.options.dialect);
  if (fanuc == is_switch(task)) {
    if (fanuc) use_switch(task);
    return !fanuc;
  }
  if (fanuc)
    task.out.report(Code::SC3116, task.word.pos,
                    code_name(task.code) + " as a curve is known to the linuxcnc dialect only");
  else
    task.out.report(Code::SC3119, task.word.pos,
                    code_name(task.code) + " without I and J is FANUC's switch of the look-ahead");
  return false;
}

template <typename Draw>
void draw(Task& task, Draw draw_curve) {
  const PlaneAxes axes = plane_axes(task.modal.plane);
  const AxisVector to = end_point(task);
  if (has_plane_axes(task, axes) && is_in_plane(task, axes)) {
    has_feed(task);
    if (has_near_lengths(task, "IJKPQ")) draw_curve(task, axes, to);
  }
  begin_motion(task);
  task.modal.position = to;
}

}  // namespace

/// G08 P1 and P0.
void switch_look_ahead(Task& task) {
  const double wanted = task.values.value_or('P', -1);
  if (wanted == 0 || wanted == 1) return note_switch(task);
  task.out.report(Code::SC2007, task.word.pos, "G08 takes P1 or P0");
}

void cubic(Task& task) {
  if (!is_known_as_curve(task)) return;
  draw(task, cubic_curve);
  const PlaneAxes axes = plane_axes(task.modal.plane);
  task.modal.curve_end =
      CurveEnd{task.modal.position, -offset_of(task, axes, {'P', 'Q'}), task.modal.plane};
}

void quadratic(Task& task) {
  if (!is_known_as_curve(task)) return;
  for (const char letter : {'Q', 'R'})  // of FANUC's switch
    if (task.values.has(letter))
      task.out.report(Code::SC2004, task.values.word(letter).pos,
                      std::string("unused word ") + letter);
  draw(task, quadratic_curve);
}

}  // namespace softcnc::ipr
