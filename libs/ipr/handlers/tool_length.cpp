// SPDX-License-Identifier: MIT
// Tool length offsets: G43, G43.1, G43.2, G49; and what is known of a tool.
#include <string>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

void use_offset(Task& task, const AxisVector& offset) {
  if (keep_offset(task, task.modal.tool_offset, offset)) task.modal.update_coordinates();
}

/// The tool that H names, or the one in force without H.
std::optional<int> tool_number(Task& task) {
  if (task.values.has('H')) return whole_number(task, task.values.word('H'));
  const bool fanuc = is_fanuc(task);
  const int last = task.modal.length_number, loaded = task.modal.state.loaded_tool.value_or(0);
  if (last != loaded) task.out.note_difference(DialectDifference::length_number, task.word.pos);
  return fanuc ? last : loaded;
}

std::optional<AxisVector> length_of(Task& task, int number) {
  task.modal.length_number = number;
  const auto tool = tools_of(task).find(number);
  if (tool) return tool->length + AxisVector(0, 0, tool->length_wear);
  report_unknown_tool(task, number,
                      task.values.has('H') ? task.values.word('H').pos : task.word.pos);
  return std::nullopt;
}

std::optional<AxisVector> read_length(Task& task) {
  const auto number = tool_number(task);
  return number ? length_of(task, *number) : std::nullopt;
}

}  // namespace

ToolTable tools_of(Task& task) { return {task.modal.state, task.machine, task.options.dialect}; }

void report_unknown_tool(Task& task, int number, SourcePos pos) {
  task.out.report(Code::SC2112, pos, "the tool table has no tool " + std::to_string(number));
}

/// G43 H; without H the tool in the spindle. In the fanuc dialect H is modal.
void use_tool_length(Task& task) {
  task.modal.length_on = true;
  if (const auto length = read_length(task)) return use_offset(task, *length);
}

/// G43.1 X Y Z: the offset itself.
void use_given_length(Task& task) {
  AxisVector offset = task.modal.tool_offset;
  for_named_axes(task, [&](int axis, double value) { offset[axis] = value; });
  task.modal.length_on = true;
  use_offset(task, offset);
}

/// G43.2 H: one more.
void add_tool_length(Task& task) {
  task.modal.length_on = true;
  if (!task.values.has('H'))
    task.out.report(Code::SC2005, task.word.pos, "G43.2 needs H, the tool to add");
  const auto length = task.values.has('H') ? read_length(task) : std::nullopt;
  if (length) return use_offset(task, task.modal.tool_offset + *length);
}

/// G49
void use_no_tool_length(Task& task) {
  task.modal.length_on = false;
  task.modal.length_number = 0;
  use_offset(task, AxisVector::Zero());
}

/// H beside no code that takes it, in the fanuc dialect.
void select_length(Task& task) {
  if (task.modal.length_on) return use_tool_length(task);
  if (const auto number = whole_number(task, task.word)) task.modal.length_number = *number;
}

}  // namespace softcnc::ipr
