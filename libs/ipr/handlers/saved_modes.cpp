// SPDX-License-Identifier: MIT
// M70 to M73: modes are saved and restored; after M73 the end of the subprogram restores them.
#include "ipr/handlers/saved_modes.hpp"

#include <utility>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

/// rpm, positive clockwise.
double turning(const Modes& modes) {
  return modes.spindle_direction * modes.spindle_speed.value_or(0);
}

void restore(Modal& modal, const SavedModes& saved) {
  constexpr Unknown kNotSaved =
      kPosition | Unknown{Part::motion,      Part::tool,    Part::shift, Part::tool_data,
                          Part::cycle_words, Part::tangent, Part::end};
  constexpr Unknown kSaved = kEverything.without(kNotSaved);
  const Unknown unknown = saved.unknown.without(kNotSaved) | modal.unknown.without(kSaved);
  static_cast<Modes&>(modal) = saved.modes;
  modal.state.active = saved.work_system;
  modal.state.shift_on = saved.shift_on;
  modal.unknown = unknown;
  modal.update_coordinates();
}

void follow_spindle(const Modes& before, const Modal& modal, Output& out, const SourcePos& source) {
  constexpr int kClockwise = 3, kCounterClockwise = 4, kOff = 5, kSpeedAlone = 0;
  if (turning(modal) == turning(before)) return;
  const int direction = modal.spindle_direction;
  int code = direction > 0 ? kClockwise : direction < 0 ? kCounterClockwise : kOff;
  if (direction == before.spindle_direction) code = kSpeedAlone;
  out.emit(Action{Action::Kind::spindle, code, turning(modal)}, source);
}

void follow_coolant(const Modes& before, const Modal& modal, Output& out, const SourcePos& source) {
  constexpr int kMist = 7, kFlood = 8, kOff = 9;
  if (before.mist == modal.mist && before.flood == modal.flood) return;
  const auto emit_coolant = [&](int code) {
    out.emit(Action{Action::Kind::coolant, code, 0}, source);
  };
  const bool off = (before.mist && !modal.mist) || (before.flood && !modal.flood);
  if (off) emit_coolant(kOff);
  if (modal.mist && (off || !before.mist)) emit_coolant(kMist);
  if (modal.flood && (off || !before.flood)) emit_coolant(kFlood);
}

/// What M70 saves.
SavedModes modes_of(const Modal& modal) {
  SavedModes saved;
  saved.modes = modal;
  saved.work_system = modal.state.active;
  saved.shift_on = modal.state.shift_on;
  saved.unknown = modal.unknown;
  return saved;
}

/// Whether a mirror changes the side of a contour in this plane.
bool changes_side(const Modes& modes, Plane plane) {
  const PlaneAxes axes = plane_axes(plane);
  return modes.transformation.factor(axes.first) * modes.transformation.factor(axes.second) < 0;
}

bool has_same_cutter(const Modes& before, const Modal& modal) {
  if (before.cutter != modal.cutter || !modal.cutter) return before.cutter == modal.cutter;
  const Plane plane = modal.cutter->plane;
  return changes_side(before, plane) == changes_side(modal, plane);
}

/// As G40, and as the G41 or G42 that was in force.
void follow_cutter(const Modes& before, Modal& modal, Output& out) {
  if (has_same_cutter(before, modal)) return;
  if (const auto tool = out.stop_compensation())
    modal.beside = Beside{modal.unplaced(*tool), before.cutter->plane};
  if (modal.cutter) out.start_compensation(placed_cutter(modal));
}

}  // namespace

void follow_restored(const Modes& before, Modal& modal, Output& out, const SourcePos& source) {
  follow_cutter(before, modal, out);
  follow_spindle(before, modal, out, source);
  follow_coolant(before, modal, out, source);
}

void SavedLevels::end_call(const SourcePos& pos) {
  const std::optional<SavedModes> ended = std::move(modal_.saved.back());
  modal_.saved.pop_back();
  if (!ended || !ended->automatic) return;
  if (!modal_.restored) modal_.restored = Restored{modal_, pos, modal_.placement};
  restore(modal_, *ended);
}

void SavedLevels::miss_call() {
  modal_.curve.reset();
  modal_.points.reset();
  modal_.unknown = kEverything;
}

/// M70, M73.
void save_modes(Task& task) {
  SavedModes& saved = task.modal.saved.back().emplace(modes_of(task.modal));
  saved.automatic = task.code.number == kM73;
}

/// M71
void forget_modes(Task& task) { task.modal.saved.back().reset(); }

/// M72
void restore_modes(Task& task) {
  Modal& modal = task.modal;
  if (const std::optional<SavedModes>& saved = modal.saved.back()) {
    const Modes before = modal;
    restore(modal, *saved);
    return follow_restored(before, modal, task.out, task.out.source());
  }
  task.out.report(Code::SC2115, task.word.pos,
                  "M72 restores modes, and no M70 or M73 has saved any at this level of calls");
}

}  // namespace softcnc::ipr
