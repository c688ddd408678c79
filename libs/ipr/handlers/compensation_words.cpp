// SPDX-License-Identifier: MIT
// G40, G41 and G42: whose radius counts, and what cannot be done meanwhile.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

bool is_dynamic(const GCode& code) { return code.number == kG411 || code.number == kG421; }

std::optional<double> radius_of_loaded_tool(Task& task) {
  const std::optional<int>& tool = task.modal.state.loaded_tool;
  const std::optional<double> radius = tool ? tools_of(task).radius(*tool) : std::nullopt;
  if (!radius)
    task.out.report(Code::SC2148, task.word.pos,
                    code_name(task.code) + " without D: " +
                        (tool ? "tool " + std::to_string(*tool) + " has no radius"
                              : std::string("no tool is in the spindle")) +
                        "; moves stay as they are");
  return radius.value_or(0);
}

std::nullopt_t report_no_radius(Task& task, int tool) {
  report_word(task, 'D', Code::SC2142,
              "the radius of tool " + std::to_string(tool) + " is not known");
  return std::nullopt;
}

/// Of no tool, and of none that has one, it is 0.
double radius_of(Task& task, const std::optional<int>& tool) {
  return tool.value_or(0) == 0 ? 0 : tools_of(task).radius(*tool).value_or(0);
}

/// FANUC: D is modal; 0, which is none before, is no radius.
std::optional<double> radius_of_last_number(Task& task) {
  const std::optional<int>& number = task.modal.radius_number;
  if (!number && !task.modal.cutter)
    task.out.report(Code::SC2148, task.word.pos,
                    code_name(task.code) + " without D, and none before; moves stay as they are");
  if (number.value_or(0) == 0) return 0;
  if (const auto radius = tools_of(task).radius(*number)) return radius;
  return report_no_radius(task, *number);
}

/// G41 alone.
std::optional<double> radius_without_number(Task& task) {
  const Modal& modal = task.modal;
  if (!modal.cutter &&
      radius_of(task, modal.state.loaded_tool) != radius_of(task, modal.radius_number))
    task.out.note_difference(DialectDifference::radius_number, task.word.pos);
  return is_fanuc(task) ? radius_of_last_number(task) : radius_of_loaded_tool(task);
}

void keep_number(Task& task, int number) { task.modal.radius_number = number; }

/// G41 D: the number of a tool.
std::optional<double> radius_by_number(Task& task) {
  const Word& word = task.values.word('D');
  const auto tool = whole_number(task, word);
  if (!tool) return std::nullopt;
  keep_number(task, *tool);
  if (*tool == 0) {
    const std::optional<int>& loaded = task.modal.state.loaded_tool;
    if (loaded && tools_of(task).radius(*loaded).value_or(0) != 0)
      task.out.note_difference(DialectDifference::zero_radius, word.pos);
    return is_fanuc(task) ? 0 : radius_of_loaded_tool(task);
  }
  if (const auto radius = tools_of(task).radius(*tool)) return radius;
  return report_no_radius(task, *tool);
}

std::optional<double> radius_by_diameter(Task& task) {
  double radius = 0;
  const double given = task.values['D'] * task.modal.mm_per_unit / 2;
  return keep_offset(task, 'D', radius, given) ? std::optional(radius) : std::nullopt;
}

std::optional<double> tool_radius(Task& task) {
  if (!is_dynamic(task.code))
    return task.values.has('D') ? radius_by_number(task) : radius_without_number(task);
  if (task.values.has('D')) return radius_by_diameter(task);
  task.out.report(Code::SC2005, task.word.pos,
                  code_name(task.code) + " needs D, the diameter of the tool");
  return std::nullopt;
}

bool may_start(Task& task) {
  const Modal& modal = task.modal;
  if (task.values.has('L') && task.values['L'] != 0) {
    report_word(task, 'L', Code::SC2007, "L, the orientation of a lathe tool, can be 0 only");
  } else if (modal.plane != Plane::xy && modal.coordinates.rotated()) {
    task.out.report(
        Code::SC2140, task.word.pos,
        code_name(task.code) + " in a plane that the rotation of the work system tilts");
  } else {
    return true;
  }
  return false;
}

/// Codes that would move the contour or the tool under it.
constexpr std::array kNever{50,  51,  52,  60,  61,  62,  73,  120, 130, 280, 281,
                            300, 301, 310, 382, 383, 384, 385, 430, 431, 432, 490,
                            520, 530, 700, 710, 720, 730, 740, 760, 810, 820, 830,
                            840, 850, 860, 870, 880, 890, 920, 921, 922, 923};
/// LinuxCNC refuses these too, though the contour stays what it is.
constexpr std::array kNotInLinuxcnc{610, 611, 640, 980, 990};

template <typename Numbers>
bool among(int number, const Numbers& numbers) {
  return std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

bool changes_plane(const Task& task) {
  const int number = task.code.number;
  return number >= kG17 && number <= kG19 && selected_plane(task.code) != task.modal.plane;
}

/// G10 of the work system in force.
bool moves_work_system(const Task& task) {
  if (task.code.number != kG10) return false;
  const double what = task.values.value_or('L', 0), which = task.values.value_or('P', 0);
  if (what == 20 && is_fanuc(task)) return kWorkSystems + which == task.modal.state.active + 1;
  return (what == 2 || what == 20) && (which == 0 || which == task.modal.state.active + 1);
}

/// A mirror would change the side of the contour; FANUC's manual allows G68 unless scales are in
/// force.
bool changes_scales(const Task& task) {
  const Transformation& now = task.modal.transformation;
  const int number = task.code.number;
  if (number == kG50 || number == kG68) return now.scaling.has_value();
  return number == kG51 || number == kG511 || (number == kG501 && now.mirrors());
}

bool is_refused_beside_contour(const Task& task) {
  const int number = task.code.number;
  if (task.code.letter != 'G')
    return task.code.group == Group::tool_change || task.code.group == Group::length_number;
  if (task.code.group == Group::work_offset || changes_scales(task)) return true;
  if (among(number, kNever) || changes_plane(task) || moves_work_system(task)) return true;
  return !is_fanuc(task) && among(number, kNotInLinuxcnc);
}

/// To 0.0001, so that a message shows no rounding.
double round_shown(double value) {
  constexpr double kDigits = 1e4;
  return std::round(value * kDigits) / kDigits + 0.0;
}

bool leads_along_curve(const Task& task) {
  constexpr std::array kCurves{20, 30, 50, 51, 52, 61, 62, 120, 130};
  return task.code.letter == 'G' && among(task.code.number, kCurves) &&
         task.values.letters().has_any(task.code.words);
}

/// The move after G40 begins beside the contour, where no arc or curve was meant to begin: not
/// even where G41 or G42 follows.
void report_beside(Task& task) {
  const Beside& beside = *task.modal.beside;
  const AxisVector at = task.modal.coordinates.to_program(beside.tool) / task.modal.mm_per_unit;
  const PlaneAxes axes = plane_axes(beside.plane);
  std::string place;
  for (const int axis : {axes.first, axes.second})
    place += std::string(" ") + axis_letter(axis) + number_text(round_shown(at[axis]));
  task.out.report(Code::SC2149, task.word.pos,
                  code_name(task.code) +
                      " after G40, which leaves the tool beside the contour, at" + place +
                      "; the first move in the plane leads away on a line");
  task.modal.beside.reset();
}

void report_twice(Task& task) {
  task.out.report(Code::SC2141, task.word.pos,
                  code_name(task.code) + ", and cutter compensation is on already");
}

/// What does not follow a contour shows that G40 is missing.
bool end_contour(Task& task) {
  task.out.stop_compensation();
  task.modal.cutter.reset();
  return true;
}

/// Old controls have one table for lengths and radii, so that H selects a radius there.
bool refuse_length_number(Task& task) {
  const Values& values = task.values;
  const bool length = !values.has('H') || task.command.has(Group::tool_length);
  if (!is_fanuc(task) || values.has('D') || length) return false;
  report_word(task, 'H', Code::SC2231,
              "H" + number_text(values['H']) + " beside " + code_name(task.code) +
                  " is the number of a length; the radius is that of D: D" +
                  number_text(values['H']));
  return true;
}

}  // namespace

void compensate(Task& task) {
  const bool on = task.out.compensating();
  if (refuse_length_number(task)) return;
  if (on && !is_fanuc(task)) return report_twice(task);
  if (!may_start(task)) return;
  const std::optional<double> radius = tool_radius(task);
  if (!radius) return;
  const bool right = task.code.number == kG42 || task.code.number == kG421;
  const int side = right == (*radius < 0) ? 1 : -1;
  const CutterSide wanted{side, std::abs(*radius), task.modal.plane, is_fanuc(task)};
  if (on && task.modal.cutter == wanted) return;
  if (on) return report_twice(task);
  task.modal.cutter = wanted;
  task.out.start_compensation(placed_cutter(task.modal));
}

/// Without D the last one counts, even after G40, as Haas has it.
std::optional<double> radius_of_pocket_tool(Task& task) {
  if (!task.values.has('D')) return radius_of_last_number(task);
  if (task.values['D'] != 0) return radius_by_number(task);
  keep_number(task, 0);
  return 0;
}

/// D beside no code that takes it, in the fanuc dialect.
void select_radius(Task& task) {
  const auto number = whole_number(task, task.word);
  if (!number) return;
  if (task.out.compensating() && number != task.modal.radius_number) return report_twice(task);
  keep_number(task, *number);
}

void end_compensation(Task& task) {
  const auto tool = task.out.stop_compensation();
  if (tool) task.modal.beside = Beside{task.modal.unplaced(*tool), task.modal.plane};
  task.modal.cutter.reset();
}

bool may_act(Task& task) {
  const bool leaves_on_curve = task.modal.beside && leads_along_curve(task);
  if (leaves_on_curve) report_beside(task);
  if (!task.out.compensating() || !is_refused_beside_contour(task) || task.modal.curve ||
      task.modal.points)
    return true;
  if (!leaves_on_curve)
    task.out.report(Code::SC2140, task.word.pos,
                    code_name(task.code) + " while cutter compensation is on");
  return end_contour(task);
}

}  // namespace softcnc::ipr
