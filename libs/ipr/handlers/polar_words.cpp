// SPDX-License-Identifier: MIT
// Polar coordinates: G15 and G16, and LinuxCNC's words @ and ^. A move gets X and Y in their place.
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

const Word& first_polar_word(const Command& command) {
  const Word* const radius = command.polar_word('@');
  const Word* const angle = command.polar_word('^');
  if (radius == nullptr || angle == nullptr) return radius != nullptr ? *radius : *angle;
  return radius->pos.column < angle->pos.column ? *radius : *angle;
}

bool refuse(Command& command, Output& out, SourcePos pos, std::string message) {
  command.lose_polar_words();
  out.report(Code::SC2258, pos, std::move(message));
  return false;
}

/// Another code would take what the words give, or a coordinate says the same otherwise.
bool may_have_polar_words(Command& command, Output& out, const PlaneAxes& axes) {
  for (const auto& [code, word] : command.codes()) {
    const bool takes_axes = LetterSet(code->words).has_any(kAxisWords);
    if (code->group == Group::motion || (!takes_axes && code->number != kG53)) continue;
    if (code->letter != 'G') continue;
    return refuse(command, out, first_polar_word(command).pos,
                  "@ and ^ beside " + code_name(*code) + ", which takes no polar coordinates");
  }
  for (const int axis : {axes.first, axes.second}) {
    const char letter = axis_letter(axis);
    if (!command.values().has(letter)) continue;
    return refuse(command, out, command.values().word(letter).pos,
                  std::string(1, letter) + " beside @ or ^");
  }
  return true;
}

Plane plane_of(const Command& command, const Modal& modal) {
  const GCode* code = command.find(Group::plane);
  return code != nullptr ? selected_plane(*code) : modal.plane;
}

std::optional<double> value_of(const Word* word, double unit) {
  return word != nullptr ? std::optional(word->value * unit) : std::nullopt;
}

const Word* axis_word(const Task& task, int axis) {
  const char letter = axis_letter(axis);
  return task.values.has(letter) ? &task.values.word(letter) : nullptr;
}

/// The words of the line, and the one at which to report.
struct Given {
  PolarPoint point;
  const Word* word;
};

std::optional<Given> given(const Task& task) {
  const Modal& modal = task.modal;
  const PlaneAxes axes = plane_axes(modal.plane);
  const bool words = task.command.has_polar_words();
  const Word* radius = words ? task.command.polar_word('@') : axis_word(task, axes.first);
  const Word* angle = words ? task.command.polar_word('^') : axis_word(task, axes.second);
  if ((radius == nullptr && angle == nullptr) || modal.machine_coordinates) return std::nullopt;
  const PolarPoint point{words ? PolarPoint::Form::words : PolarPoint::Form::g16, axes,
                         value_of(radius, modal.mm_per_unit), value_of(angle, 1),
                         modal.incremental};
  return Given{point, radius != nullptr ? radius : angle};
}

/// FANUC: in G16 an arc is given by its radius.
bool has_centre(Task& task) {
  const bool arc = task.code.number == kG02 || task.code.number == kG03;
  if (!arc || !task.modal.polar || task.values.has('R')) return false;
  for (const char letter : kOffsetLetters) {
    if (!task.values.has(letter)) continue;
    report_word(task, letter, Code::SC2255,
                std::string(1, letter) + " while G16 is in force, where arcs take R");
    return true;
  }
  return false;
}

}  // namespace

void begin_polar_words(Command& command, Modal& modal, Output& out) {
  if (command.unread().has_any(kPolarWords)) return;
  const PlaneAxes axes = plane_axes(plane_of(command, modal));
  const bool known = command.has(Group::plane) || !modal.unknown.has(Part::plane);
  if (!known) return command.lose_polar_words();
  if (may_have_polar_words(command, out, axes)) command.replace_polar_words(axes);
}

bool resolve_polar_words(Task& task, Command& command) {
  Modal& modal = task.modal;
  if (has_centre(task)) return false;
  const auto words = given(task);
  if (!words) return true;
  const AxisVector position = modal.coordinates.to_program(modal.position);
  if (!words->point.has_direction(position)) {
    task.out.report(Code::SC2259, words->word->pos,
                    modal.incremental
                        ? "polar coordinates in G91 at the zero point, which has no direction"
                        : "@ without ^ at the zero point, which has no direction");
    return false;
  }
  modal.polar_end = words->point;
  const AxisVector end = words->point.from(position);
  for (const int axis : {words->point.axes.first, words->point.axes.second}) {
    const double distance = modal.incremental ? end[axis] - position[axis] : end[axis];
    command.set_axis(axis, distance / modal.mm_per_unit, *words->word);
  }
  return true;
}

/// G15, G16.
void switch_polar(Task& task) { task.modal.polar = task.code.number == kG16; }

}  // namespace softcnc::ipr
