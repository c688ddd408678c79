// SPDX-License-Identifier: MIT
// Straight moves: G00, G01, and G80, which ends motion.
#include <cmath>

#include "ipr/handlers/handlers.hpp"
#include "ipr/state/nearness.hpp"

namespace softcnc::ipr {
namespace {

/// After G40, a move across the plane alone: the tool stays beside the contour.
bool stays_beside(const Task& task) {
  if (!task.modal.beside) return false;
  return !task.values.letters().has_any(plane_letters(plane_axes(task.modal.beside->plane)));
}

void move_beside(Task& task, const AxisVector& programmed, bool rapid) {
  Beside beside = *task.modal.beside;
  const int across = plane_axes(beside.plane).across;
  AxisVector to = beside.tool;
  to[across] = programmed[across];
  if (std::abs(to[across] - beside.tool[across]) >= kShortestMove)
    emit_move(task, softcnc::Line(beside.tool, to), rapid);
  beside.tool = to;
  task.modal.beside = beside;
}

void line(Task& task, bool rapid) {
  begin_motion(task);
  if (!task.values.letters().has_any(kAxisWords)) return;
  if (fanuc_goes_home(task.command, task.options.dialect)) return;
  const AxisVector to = end_point(task);
  if (task.modal.machine_coordinates && !rapid) {
    task.out.note_difference(DialectDifference::machine_point,
                             task.command.find_word(Group::non_modal).pos);
    rapid = is_fanuc(task);
  }
  if (!rapid) has_feed(task);
  move_straight(task, to, rapid);
}

/// Whether it is known where a word leads along its axis.
bool is_known(const Command& command, const Modal& modal, int axis) {
  Unknown needed{Part::units, Part::distance, Part::polar};
  if (modal.incremental) needed.add(position_part(axis));
  if (!modal.machine_coordinates) needed |= kOffsets;
  if (modal.polar || command.has_polar_words()) return false;
  if (modal.placement && modal.machine_coordinates) return false;
  return !modal.unknown.has_any(needed) && !modal.coordinates.rotated() &&
         !command.unread().has(axis_letter(axis));
}

double place_along(const Command& command, const Modal& modal, int axis) {
  const double value = command.values()[axis_letter(axis)] * modal.mm_per_unit;
  if (modal.incremental) return modal.position[axis] + value;
  return (modal.machine_coordinates ? 0 : modal.coordinates.sum()[axis]) + value;
}

}  // namespace

void follow_axes(const Command& command, Modal& modal, LetterSet letters) {
  for (int axis = 0; axis < kAxes; ++axis) {
    if (!letters.has(axis_letter(axis))) continue;
    const bool known = is_known(command, modal, axis);
    const double place = known ? place_along(command, modal, axis) : kFarthest;
    if (std::abs(place) < kFarthest) {
      modal.position[axis] = place;
      modal.unknown.remove(position_part(axis));
    } else {
      modal.unknown.add(position_part(axis));
    }
  }
}

bool follow_unmade_move(Task& task) {
  const bool cycle = is_canned_cycle(task.code);
  if (is_refused(task.code) || is_curve_of_lines(task.code)) return false;
  task.out.fail();
  LetterSet named = task.values.letters();
  named |= task.command.unread();
  const char across = axis_letter(plane_axes(task.modal.plane).across);
  if (cycle) named.remove(across);
  follow_axes(task.command, task.modal, named);
  return true;
}

[[gnu::hot]] void move_straight(Task& task, const AxisVector& to, bool rapid) {
  if (stays_beside(task)) {
    move_beside(task, to, rapid);
    task.modal.position = to;
    return;
  }
  const AxisVector from = task.modal.beside ? task.modal.beside->tool : task.modal.position;
  if ((to - from).lpNorm<Eigen::Infinity>() < kShortestMove) return;
  task.modal.position = to;
  emit_move(task, softcnc::Line(from, to), rapid);
}

void rapid(Task& task) { line(task, true); }
[[gnu::hot]] void feed_line(Task& task) { line(task, false); }

/// In the fanuc dialect G80 ends cycles only.
void cancel_motion(Task& task) {
  const bool fanuc = is_fanuc(task);
  task.modal.motion = fanuc ? task.modal.motion_below : nullptr;
}

}  // namespace softcnc::ipr
