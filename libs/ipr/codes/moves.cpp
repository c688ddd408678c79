// SPDX-License-Identifier: MIT
// Straight moves: G00, G01, and G80, which ends motion.
#include <cmath>

#include "ipr/codes/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kShortest = 1e-9;  // mm: a shorter way is none

/// Behind G40, a move across the plane alone: the tool stays beside the contour.
bool stays_beside(const Task& task) {
  if (!task.modal.beside) return false;
  return !task.values.letters().has_any(plane_letters(plane_axes(task.modal.beside->plane)));
}

void move_beside(Task& task, const AxisVector& programmed, bool rapid) {
  Beside beside = *task.modal.beside;
  const int across = plane_axes(beside.plane).across;
  AxisVector to = beside.tool;
  to[across] = programmed[across];
  if (std::abs(to[across] - beside.tool[across]) >= kShortest)
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
    task.out.contradict(Contradiction::machine_point, task.command.find_word(Group::non_modal).pos);
    rapid = task.options.dialect == Dialect::fanuc;
  }
  if (!rapid) has_feed(task);
  move_straight(task, to, rapid);
}

}  // namespace

[[gnu::hot]] void move_straight(Task& task, const AxisVector& to, bool rapid) {
  if (stays_beside(task)) {
    move_beside(task, to, rapid);
    task.modal.position = to;
    return;
  }
  const AxisVector from = task.modal.beside ? task.modal.beside->tool : task.modal.position;
  if ((to - from).lpNorm<Eigen::Infinity>() < kShortest) return;
  task.modal.position = to;
  emit_move(task, softcnc::Line(from, to), rapid);
}

void rapid(Task& task) { line(task, true); }
[[gnu::hot]] void feed_line(Task& task) { line(task, false); }

/// In the fanuc dialect G80 ends cycles only.
void cancel_motion(Task& task) {
  const bool fanuc = task.options.dialect == Dialect::fanuc;
  task.modal.motion = fanuc ? task.modal.motion_below : nullptr;
  const bool known = !task.out.failed() && (!fanuc || task.modal.motion != nullptr);
  if (known) task.modal.uncertain.remove('G');
}

}  // namespace softcnc::ipr
