// SPDX-License-Identifier: MIT
// Codes that change how later words are read: plane, units, distance, path control, feed.
#include <string>

#include "ipr/handlers.hpp"
#include "motion/units.hpp"

namespace softcnc::ipr {

void select_plane(Task& task) {
  constexpr int kG17 = 170, kG18 = 180;
  task.modal.plane = task.code.number == kG17   ? Plane::xy
                     : task.code.number == kG18 ? Plane::zx
                                                : Plane::yz;
}

void use_inches(Task& task) { task.modal.mm_per_unit = kMmPerInch; }
void use_millimetres(Task& task) { task.modal.mm_per_unit = 1; }

void use_absolute(Task& task) { task.modal.incremental = false; }
void use_incremental(Task& task) { task.modal.incremental = true; }

void follow_path(Task& task) { task.modal.join = Join::follow; }
void stop_exactly(Task& task) { task.modal.join = Join::stop; }

/// G64, with a tolerance of 0 at most.
void follow_path_within(Task& task) {
  if (task.values.value_or('P', 0) != 0)
    task.out.report(
        Code::SC2007, task.values.word('P').pos,
        "G64 with a tolerance is not supported; without P the path is followed exactly");
  follow_path(task);
}

void set_feed(Task& task) {
  const double feed = mm_s_from_mm_min(task.word.value * task.modal.mm_per_unit);
  task.modal.uncertain.remove('F');
  task.modal.feed = feed;
  if (feed < 0) {
    task.out.report(Code::SC2007, task.word.pos, "F must not be negative");
    task.modal.uncertain.add('F');
    return;
  }
  const double limit = task.machine.limits.feed;
  if (limit <= 0 || feed <= limit) return;
  task.modal.feed = limit;
  if (!task.modal.feed_warned)
    task.out.report(Code::SC2201, task.word.pos,
                    "F is above the machine's " + number_text(mm_min_from_mm_s(limit)) +
                        " mm/min, which are used here and below");
  task.modal.feed_warned = true;
}

}  // namespace softcnc::ipr
