// SPDX-License-Identifier: MIT
// Arcs and helices: G02 and G03, by centre or by radius.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "ipr/dialects/grbl_reading.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/lines/beyond_grbl.hpp"
#include "ipr/state/nearness.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kMostTurns = 10'000;
constexpr double kShortfall = 0.00127;  // mm (0.00005 inch): how much R may fall short, as in RS274

/// mm. As LinuxCNC, which allows for the fewer decimals of inches.
double radius_tolerance(const Modal& modal) {
  constexpr double kInInches = 0.002 * std::numbers::sqrt2 * kMmPerInch;
  return modal.mm_per_unit == 1 ? kRadiusTolerance : kInInches;
}

/// A 0 across the plane changes nothing, beside a letter of the centre.
bool may_pass_over(const Task& task, char across) {
  const LetterSet centre{kOffsetLetters};
  return task.values[across] == 0 &&
         task.values.letters().has_any(centre.without(std::string_view(&across, 1)));
}

/// Once a file.
void note_across(Task& task, char across) {
  if (is_fanuc(task) || std::exchange(task.modal.across_reported, true)) return;
  task.out.report(
      Code::SC2171, task.values.word(across).pos,
      std::string(1, across) + "0 lies across the plane of the arc and changes nothing");
}

/// Reports a centre beside a radius, or one off the plane.
bool is_well_given(Task& task, const PlaneAxes& axes) {
  const Values& values = task.values;
  const bool radius = values.has('R');
  if (radius && is_fanuc(task)) return true;
  if (radius && values.letters().has_any(kOffsetLetters)) {
    task.out.report(Code::SC2106, span_of(values, "IJKR"),
                    code_name(task.code) + " takes R or a centre, not both");
  } else if (const char across = offset_letter(axes.across);
             values.has(across) && !may_pass_over(task, across)) {
    task.out.report(Code::SC2105, values.word(across).pos,
                    std::string(1, across) + " lies across the plane of the arc");
  } else {
    if (values.has(across)) note_across(task, across);
    return true;
  }
  return false;
}

bool has_centre_or_radius(Task& task) {
  if (task.values.has('R') || task.values.letters().has_any(kOffsetLetters)) return true;
  task.out.report(Code::SC2107, span_of(task.values, "XYZP"),
                  code_name(task.code) + " needs a centre or R");
  return false;
}

bool has_both_letters(const Task& task, const PlaneAxes& axes) {
  return task.values.has(offset_letter(axes.first)) && task.values.has(offset_letter(axes.second));
}

/// G90.1: the centre as a place, which takes both its letters.
std::optional<AxisVector> center_by_place(Task& task, const PlaneAxes& axes) {
  const Coordinates& coordinates = task.modal.coordinates;
  AxisVector center = coordinates.to_program(task.modal.position);
  for (const int axis : {axes.first, axes.second}) {
    const char letter = offset_letter(axis);
    if (!task.values.has(letter)) {
      task.out.report(Code::SC2005, task.word.pos,
                      std::string("a centre in G90.1 needs ") + letter);
      return std::nullopt;
    }
    center[axis] = task.values[letter] * task.modal.mm_per_unit;
  }
  return coordinates.to_machine(center);
}

/// G91.1: the centre as a distance from the start.
AxisVector center_by_distance(const Task& task, const PlaneAxes& axes) {
  AxisVector offset = AxisVector::Zero();
  for (const int axis : {axes.first, axes.second})
    offset[axis] = task.values.value_or(offset_letter(axis), 0) * task.modal.mm_per_unit;
  return task.modal.position + task.modal.coordinates.direction(offset);
}

std::optional<AxisVector> center_by_offsets(Task& task, const PlaneAxes& axes) {
  if (task.modal.absolute_centres) return center_by_place(task, axes);
  return center_by_distance(task, axes);
}

/// Of an arc whose ends are not equally far from its centre: whether they are from the one that the
/// same letters name in the other of the modes G90.1 and G91.1.
std::string mode_that_fits(Task& task, ArcSpec spec, const PlaneAxes& axes) {
  const bool place = !task.modal.absolute_centres;
  if (task.values.has('R') || (place && !has_both_letters(task, axes))) return {};
  spec.center = place ? *center_by_place(task, axes) : center_by_distance(task, axes);
  if (!Arc::make(spec)) return {};
  return place ? "; its centre fits with G90.1, as a place"
               : "; its centre fits with G91.1, as a distance from the start";
}

/// The centre left of the chord for a short arc counter-clockwise, right of it for a long one; for
/// an arc clockwise the other way round. A negative R asks for the long arc.
std::optional<AxisVector> center_by_radius(Task& task, const PlaneAxes& axes, const AxisVector& to,
                                           bool ccw) {
  const AxisVector& from = task.modal.position;
  const double radius = task.values['R'] * task.modal.mm_per_unit;
  const double across = to[axes.first] - from[axes.first];
  const double up = to[axes.second] - from[axes.second];
  const double chord = std::hypot(across, up);
  const SourcePos pos = task.values.word('R').pos;
  if (chord <= kSamePoint) {
    task.out.report(Code::SC2108, pos,
                    code_name(task.code) + " ends where it starts; R does not define a centre");
    return std::nullopt;
  }
  if (chord / 2 > std::abs(radius) + kShortfall) {
    task.out.report(Code::SC2109, pos,
                    "a radius of " + number_text(std::abs(radius)) + " mm does not reach an end " +
                        number_text(chord) + " mm away");
    return std::nullopt;
  }
  const double height_squared = radius * radius - chord * chord / 4;
  const double height = height_squared > 0 ? std::sqrt(height_squared) : 0;
  const double left = (ccw == (radius > 0) ? height : -height) / chord;
  AxisVector center = from;
  center[axes.first] += across / 2 - left * up;
  center[axes.second] += up / 2 + left * across;
  return center;
}

/// Of an arc by its centre, which softcnc runs.
void note_ends_beyond_grbl(Task& task, const Arc& arc) {
  const PlaneAxes axes = plane_axes(arc.plane());
  const double end = std::hypot(arc.to()[axes.first] - arc.center()[axes.first],
                                arc.to()[axes.second] - arc.center()[axes.second]);
  if (!takes_grbl_radii(arc.radius(), end))
    note_beyond_grbl(task.out, span_of(task.values, "XYZIJK"), "ends of an arc",
                     "an arc whose radii differ by " + number_text(std::abs(end - arc.radius())) +
                         " mm, more than 0.005 mm and 0.1 % of the radius, or than 0.5 mm");
}

void emit_arc(Task& task, const ArcSpec& spec) {
  Result<Arc> made = Arc::make(spec);
  const bool by_radius = task.values.has('R');
  if (made && !by_radius && task.options.dialect == Dialect::grbl)
    note_ends_beyond_grbl(task, *made);
  if (made) return emit_move(task, std::move(*made));
  if (made.error().code == Code::SC2103)
    made.error().message += mode_that_fits(task, spec, plane_axes(spec.plane));
  task.out.report(made.error().code,
                  by_radius ? task.values.word('R').pos : span_of(task.values, "XYZIJK"),
                  std::move(made.error().message));
}

/// P, less the first pass; 0, after a report, if it is no number of turns.
int further_turns(Task& task) {
  if (!task.values.has('P')) return 0;
  const Word& word = task.values.word('P');
  if (task.options.dialect == Dialect::grbl)
    note_beyond_grbl(task.out, word.pos, "turns of an arc", "P, the turns of an arc");
  if (word.value >= 1 && word.value <= kMostTurns && word.value == std::floor(word.value))
    return static_cast<int>(word.value) - 1;
  task.out.report(
      Code::SC2007, word.pos,
      "P, the turns of an arc, is a whole number from 1 to " + std::to_string(kMostTurns));
  return 0;
}

/// A work system that is rotated about Z tilts the planes that hold Z.
bool arc_lies_in_plane(Task& task) {
  if (task.modal.plane == Plane::xy || !task.modal.coordinates.rotated()) return true;
  task.out.report(Code::SC2113, task.word.pos,
                  code_name(task.code) + " in a plane that the rotation of the work system tilts");
  return false;
}

void arc(Task& task, bool ccw) {
  begin_motion(task);
  if (!task.values.letters().has_any(task.code.words)) return;
  const PlaneAxes axes = plane_axes(task.modal.plane);
  const AxisVector to = end_point(task);
  const int turns = further_turns(task);
  const bool well_given = is_well_given(task, axes);
  has_feed(task);
  if (has_plane_axes(task, axes) && well_given && has_centre_or_radius(task) &&
      has_near_lengths(task, "IJKR") && arc_lies_in_plane(task)) {
    const auto center = task.values.has('R') ? center_by_radius(task, axes, to, ccw)
                                             : center_by_offsets(task, axes);
    if (center)
      emit_arc(task, {task.modal.position, to, *center, task.modal.plane, ccw, turns,
                      radius_tolerance(task.modal)});
  }
  task.modal.position = to;
}

}  // namespace

void arc_clockwise(Task& task) { arc(task, false); }
void arc_counterclockwise(Task& task) { arc(task, true); }

}  // namespace softcnc::ipr
