// SPDX-License-Identifier: MIT
// Straight moves: G00, G01, and G80, which ends motion.
#include "ipr/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kShortest = 1e-9;  // mm: a shorter way is none

void line(Task& task, bool rapid) {
  begin_motion(task);
  if (!task.values.letters().has_any(kAxisWords)) return;
  const AxisVector from = task.modal.position;
  const AxisVector to = end_point(task);
  if (!rapid && !has_feed(task)) {
    task.modal.position = to;
    return;
  }
  if ((to - from).lpNorm<Eigen::Infinity>() < kShortest) return;
  task.modal.position = to;
  emit_move(task, softcnc::Line(from, to), rapid);
}

}  // namespace

void rapid(Task& task) { line(task, true); }
void feed_line(Task& task) { line(task, false); }

void cancel_motion(Task& task) {
  task.modal.motion = nullptr;
  task.modal.uncertain.remove('G');
}

}  // namespace softcnc::ipr
