// SPDX-License-Identifier: MIT
// G10: writes into the tables of work systems and tools.
#include <cmath>
#include <string>

#include "ipr/handlers/handlers.hpp"
#include "ipr/state/offset_variables.hpp"

namespace softcnc::ipr {
namespace {

constexpr int kFanucSystems = 6;  // G54 to G59
constexpr std::size_t kSystemOfG593 = kWorkSystems - 1;

std::string form(const Task& task) { return "G10 L" + number_text(task.values['L']); }

bool needs(Task& task, LetterSet letters, std::string_view text) {
  if (task.values.letters().has_any(letters)) return true;
  task.out.report(Code::SC2005, task.word.pos, form(task) + " needs " + std::string(text));
  return false;
}

/// Words that G10 takes in another form only.
bool lacks(Task& task, LetterSet letters) {
  bool good = true;
  for (const char letter : {'X', 'Y', 'Z', 'R'}) {
    if (!letters.has(letter) || !task.values.has(letter)) continue;
    task.out.report(Code::SC2004, task.values.word(letter).pos,
                    std::string(1, letter) + " is not used by " + form(task));
    good = false;
  }
  return good;
}

/// P as a number from `first` to `last`.
std::optional<int> read_p(Task& task, int first, int last, std::string_view what) {
  if (!needs(task, "P", "P, " + std::string(what))) return std::nullopt;
  const auto number = whole_number(task, task.values.word('P'));
  if (!number || (*number >= first && *number <= last)) return number;
  task.out.report(Code::SC2007, task.values.word('P').pos,
                  form(task) + " takes P from " + std::to_string(first) + " to " +
                      std::to_string(last) + ", " + std::string(what));
  return std::nullopt;
}

/// The index of the work system that P names.
std::optional<int> read_system(Task& task) {
  const auto number = is_fanuc(task) ? read_p(task, 1, kFanucSystems, "the work system (1 is G54)")
                                     : read_p(task, 0, kWorkSystems, "the work system (1 is G54)");
  if (!number) return std::nullopt;
  return *number == 0 ? task.modal.state.active : *number - 1;
}

/// In G91 the fanuc dialect adds what its form of G10 L2 gives; R and other systems it refuses.
void compare_system(Task& task, int system) {
  const bool fanuc_form = task.values['P'] != 0 && system < kFanucSystems && !task.values.has('R');
  if (task.modal.incremental && fanuc_form && task.values.letters().has_any(kAxisWords))
    task.out.note_difference(DialectDifference::work_system_in_g91, task.word.pos);
}

bool adds(const Task& task) { return is_fanuc(task) && task.modal.incremental; }

bool set_rotation(Task& task, double& rotation) {
  if (!task.values.has('R')) return true;
  const Word& word = task.values.word('R');
  if (std::abs(word.value) <= kMostTurned) {
    rotation = word.value * kRadPerDegree;
    return true;
  }
  report_word(task, 'R', Code::SC3008,
              "R turns the work system by more than " + number_text(kMostTurned) + " degrees");
  return false;
}

AxisVector given_origin(const Task& task, AxisVector origin) {
  for_named_axes(task, [&](int axis, double value) {
    origin[axis] = adds(task) ? origin[axis] + value : value;
  });
  return origin;
}

/// L2 P0 of Haas: the shift of G52.
bool set_local_shift_by_table(Task& task) {
  if (!lacks(task, "R")) return false;
  AxisVector& shift = task.modal.local_shift;
  return keep_offset(task, shift, given_origin(task, shift));
}

/// L2: origin and rotation as given.
bool set_system(Task& task) {
  const bool haas = is_haas(task);
  if (haas && task.values.has('P') && task.values['P'] == 0) return set_local_shift_by_table(task);
  const auto system = read_system(task);
  if (!system || (is_fanuc(task) && !lacks(task, "R"))) return false;
  compare_system(task, *system);
  WorkOffset& work = task.modal.state.work_system_entry(*system);
  const AxisVector origin = given_origin(task, work.origin);
  return set_rotation(task, work.rotation) && keep_offset(task, work.origin, origin);
}

/// L20 of both dialects: systems of another kind.
void compare_further_system(Task& task) {
  const double number = task.values.value_or('P', 0);
  const bool common = number >= 1 && number <= kWorkSystems && !task.values.has('R');
  if (common && task.values.letters().has_any(kAxisWords))
    task.out.note_difference(DialectDifference::further_system, task.word.pos);
}

/// L20 of the fanuc dialect: the origin of a further system as given.
bool set_further_system(Task& task) {
  const auto number = read_p(task, 1, kFurtherSystems, "the work system (1 is G54.1 P1)");
  if (!number || !lacks(task, "R")) return false;
  AxisVector& origin = task.modal.state.work_system_entry(kWorkSystems + *number - 1).origin;
  return keep_offset(task, origin, given_origin(task, origin));
}

/// Moves what is subtracted from the position, as `with` takes it, so that the axes named get the
/// coordinates given, and the others keep theirs.
template <typename With>
bool rename_position(Task& task, AxisVector& offset, With&& with) {
  const Coordinates before = with(offset);
  const AxisVector& position = task.modal.position;
  AxisVector wanted = before.to_program(position);
  for_named_axes(task, [&](int axis, double value) { wanted[axis] = value; });
  const AxisVector moved = position - with(AxisVector::Zero()).to_machine(wanted);
  if (before.rotated()) return keep_offset(task, offset, moved);
  AxisVector renamed = offset;
  for_named_axes(task, [&](int axis, double) { renamed[axis] = moved[axis]; });
  return keep_offset(task, offset, renamed);
}

/// L20: such an origin that the position has the coordinates given.
bool set_system_by_position(Task& task) {
  const auto system = read_system(task);
  if (!system || !lacks(task, "R")) return false;
  const Modal& modal = task.modal;
  WorkOffset& work = task.modal.state.work_system_entry(*system);
  return rename_position(task, work.origin, [&](const AxisVector& origin) {
    return Coordinates({origin, work.rotation}, modal.shift(), modal.tool_offset);
  });
}

std::optional<int> read_tool(Task& task) { return read_p(task, 1, kLastTool, "the tool number"); }

bool set_radius(Task& task, ToolOffset& tool) {
  return !task.values.has('R') ||
         keep_offset(task, 'R', tool.radius, task.values['R'] * task.modal.mm_per_unit);
}

/// L1: lengths and radius as given.
bool set_tool(Task& task) {
  const auto number = read_tool(task);
  if (!number || !needs(task, "XYZR", "X, Y, Z or R")) return false;
  ToolOffset& tool = tools_of(task).row(*number);
  AxisVector length = tool.length;
  for_named_axes(task, [&](int axis, double value) { length[axis] = value; });
  return keep_offset(task, tool.length, length) && set_radius(task, tool);
}

/// L10, and L11 by way of G59.3: such lengths that the position has the coordinates given.
bool set_tool_by_position(Task& task, bool fixture) {
  const auto number = read_tool(task);
  if (!number || !needs(task, "XYZR", "X, Y, Z or R")) return false;
  const Modal& modal = task.modal;
  ToolOffset& tool = tools_of(task).row(*number);
  const WorkOffset work = fixture ? modal.state.work[kSystemOfG593] : modal.work();
  const AxisVector shift = fixture ? AxisVector::Zero() : modal.shift();
  return rename_position(
             task, tool.length,
             [&](const AxisVector& length) { return Coordinates(work, shift, length); }) &&
         set_radius(task, tool);
}

/// The fanuc dialect: one value of the tables of H and D. R is that times `unit`.
bool set_compensation(Task& task, double& value, double unit = 1) {
  if (!lacks(task, "XYZ") || !needs(task, "R", "R, the value")) return false;
  const double given = task.values['R'] * task.modal.mm_per_unit / unit;
  return keep_offset(task, 'R', value, adds(task) ? value + given : given);
}

/// L12 and L13: Haas' controls take diameters, unless setting 40 says otherwise.
bool set_cutter_offset(Task& task, double& value) {
  const CutterOffset meaning = task.machine.program.cutter_offsets;
  if (task.options.dialect == Dialect::fanuc && task.values.has('R'))
    task.out.note_difference(DialectDifference::cutter_offset, task.word.pos);
  if (!is_haas(task) || meaning == CutterOffset::radius) return set_compensation(task, value);
  if (meaning == CutterOffset::unstated && task.values.has('R') && !task.modal.diameter_warned) {
    report_word(task, 'R', Code::SC2386,
                "R of " + form(task) +
                    " counts the diameter of a tool, as Haas' setting 40 has it unless it says "
                    "radius");
    task.modal.diameter_warned = true;
  }
  constexpr double kPerRadius = 2;
  return set_compensation(task, value, kPerRadius);
}

bool write_compensation(Task& task, int table) {
  const auto number = read_p(task, 1, kLastTool, "the offset number");
  if (!number) return false;
  ToolOffset& tool = tools_of(task).row(*number);
  switch (table) {
    case 10:
      return set_compensation(task, tool.length[2]);
    case 12:
      return set_cutter_offset(task, tool.radius);
    case 13:
      return set_cutter_offset(task, tool.radius_wear);
    default:
      return set_compensation(task, tool.length_wear);
  }
}

bool refuse_form(Task& task) {
  task.out.report(Code::SC2007, task.values.word('L').pos,
                  is_fanuc(task) ? "G10 takes L1, L2, L10, L11, L12, L13 or L20"
                                 : "G10 takes L1, L2, L10, L11 or L20");
  return false;
}

/// R alone is what both dialects take, each for another value.
void compare_tool_value(Task& task, int table) {
  const bool common = table == 1 || table == 10 || table == 11;
  if (common && task.values.has('R') && !task.values.letters().has_any(kAxisWords))
    task.out.note_difference(DialectDifference::tool_value, task.values.word('R').pos);
}

bool write_fanuc(Task& task, int table) {
  if (table == 2) return set_system(task);
  if (table == 20) return set_further_system(task);
  const bool known = table == 1 || (table >= 10 && table <= 13);
  return known ? write_compensation(task, table) : refuse_form(task);
}

bool write_table(Task& task) {
  if (!task.values.has('L')) {
    task.out.report(Code::SC2005, task.word.pos, "G10 needs L, the table");
    return false;
  }
  const auto table = whole_number(task, task.values.word('L'));
  if (!table) return false;
  compare_tool_value(task, *table);
  if (*table == 20) compare_further_system(task);
  if (is_fanuc(task)) return write_fanuc(task, *table);
  switch (*table) {
    case 1:
      return set_tool(task);
    case 2:
      return set_system(task);
    case 10:
    case 11:
      return set_tool_by_position(task, *table == 11);
    case 20:
      return set_system_by_position(task);
    default:
      return refuse_form(task);
  }
}

}  // namespace

void set_offsets(Task& task) {
  write_table(task);
  task.modal.update_coordinates();
}

}  // namespace softcnc::ipr
