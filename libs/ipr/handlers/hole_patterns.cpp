// SPDX-License-Identifier: MIT
// G70, G71 and G72: the canned cycle in force along a circle, an arc or a line. Haas' mill
// operator's manual, "G70 Bolt Hole Circle", "G71 Bolt Hole Arc", "G72 Bolt Holes Along an Angle".
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/codes/transformation.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kMostHoles = 10000;  // of one line, as of a cycle

bool has_pattern_words(Task& task) {
  const std::string_view of_i =
      task.code.number == kG72 ? "the distance between holes" : "the radius";
  if (!has_word(task, 'I', of_i)) return false;
  if (!has_word(task, 'L', "the number of holes")) return false;
  if (task.values['I'] == 0) {
    report_word(task, 'I', Code::SC2007, "I, " + std::string(of_i) + ", must not be 0");
    return false;
  }
  return task.code.number != kG71 || has_word(task, 'K', "the angle between holes");
}

bool has_cycle(Task& task) {
  if (task.modal.motion != nullptr && is_canned_cycle(*task.modal.motion)) return true;
  task.out.report(Code::SC2101, task.word.pos,
                  code_name(task.code) + " with no canned cycle in force");
  return false;
}

/// X Y and the pattern are lengths along the axes.
bool is_cartesian(Task& task) {
  if (!task.modal.polar && !task.command.has_polar_words()) return true;
  task.out.report(Code::SC2251, task.word.pos,
                  code_name(task.code) + " while G16 is in force or beside @ and ^");
  return false;
}

/// Beside a cycle the word across the plane is the bottom of its holes.
bool pattern_lies_in_plane(Task& task, char across) {
  if (!task.values.has(across) || task.command.has(Group::motion)) return true;
  report_word(task, across, Code::SC2004, std::string("unused word ") + across);
  return false;
}

std::optional<int> number_of_holes(Task& task) {
  const auto count = whole_number(task, task.values.word('L'));
  if (!count || (*count >= 1 && *count <= kMostHoles)) return count;
  report_word(task, 'L', Code::SC2007, "L, the number of holes, must be from 1 to 10000");
  return std::nullopt;
}

/// X Y, or where the tool is.
AxisVector origin_of(const Task& task) {
  AxisVector origin = task.modal.coordinates.to_program(task.modal.position);
  for_named_axes(task, [&](int axis, double value) {
    origin[axis] = task.modal.incremental ? origin[axis] + value : value;
  });
  return origin;
}

/// Degrees from one hole to the next: a negative radius runs clockwise.
double turn_of(const Task& task, int count) {
  const double turn = task.code.number == kG71 ? task.values['K'] : kFullTurn / count;
  return std::copysign(1.0, task.values['I']) * turn;
}

std::vector<AxisVector> places_of(const Task& task, int count) {
  const PlaneAxes axes = plane_axes(task.modal.plane);
  const AxisVector origin = origin_of(task);
  const bool line = task.code.number == kG72;
  const double length = task.values['I'] * task.modal.mm_per_unit;
  const double begin = task.values.value_or('J', 0), turn = line ? 0 : turn_of(task, count);
  std::vector<AxisVector> places;
  places.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d direction = direction_of(begin + i * turn);
    const double distance = line ? i * length : std::abs(length);
    AxisVector& place = places.emplace_back(origin);
    place[axes.first] += distance * direction.x();
    place[axes.second] += distance * direction.y();
  }
  return places;
}

}  // namespace

bool has_hole_pattern(const Command& command) noexcept {
  const GCode* code = command.find(Group::non_modal);
  return code != nullptr && is_hole_pattern(*code);
}

/// About the centre, or from the first hole on.
void drill_pattern(Task& task) {
  if (!has_cycle(task) || !has_pattern_words(task) || !is_cartesian(task)) return;
  const PlaneAxes axes = plane_axes(task.modal.plane);
  if (!has_plane_axes(task, axes) || !pattern_lies_in_plane(task, axis_letter(axes.across))) return;
  if (const auto count = number_of_holes(task)) drill_at(task, places_of(task, *count));
}

}  // namespace softcnc::ipr
