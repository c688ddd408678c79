// SPDX-License-Identifier: MIT
// The pages of keys, offsets, tools, and of what a check has found.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "hal/machine/state_names.hpp"
#include "motion/core/units.hpp"
#include "operate/console.hpp"
#include "operate/views.hpp"

namespace softcnc::app {
namespace {

std::string axes_text(const AxisVector& place) {
  return fmt::format("{:12.3f}{:12.3f}{:12.3f}", place[0], place[1], place[2]);
}

/// Puts rows so that the selected one can be seen.
void put_rows(Screen& screen, int first, int end, const std::vector<std::string>& rows,
              std::size_t selection) {
  const int room = std::max(end - first, 0);
  const int selected = static_cast<int>(selection);
  const int top = std::max(selected - room + 1, 0);
  for (int i = 0; i < room && top + i < static_cast<int>(rows.size()); ++i)
    screen.put(first + i, 0, rows[static_cast<std::size_t>(top + i)],
               top + i == selected ? Emphasis::bold : Emphasis::none);
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::vector<std::string> found_lines(const ConsoleState& state) {
  const CheckedProgram* checked = state.program ? state.program->checked() : nullptr;
  if (checked == nullptr) return {" no program has been checked"};
  return checked->found.empty() ? std::vector<std::string>{" the check has found nothing"}
                                : lines_of(checked->found);
}

}  // namespace

void draw_keys(Screen& screen, int first, int end) {
  std::vector<std::string> cells{" arrows  jog X and Y: a press is a step,",
                                 "         a key that is held goes on", " PgUp Dn jog Z",
                                 " Ctrl-C  hold, whatever is shown",
                                 " Enter   go on after hold, pause, tool"};
  for (const Console::Binding& binding : Console::bindings())
    cells.push_back(fmt::format(" {:<6}  {}", binding.name, binding.help));
  constexpr int kColumn = 41;
  const int columns =
      std::max(screen.columns() / kColumn + (screen.columns() % kColumn > 38 ? 1 : 0), 1);
  const int rows = (static_cast<int>(cells.size()) + columns - 1) / columns;
  for (int i = 0; i < static_cast<int>(cells.size()); ++i)
    if (first + i % rows < end)
      screen.put(first + i % rows, i / rows * kColumn,
                 cells[static_cast<std::size_t>(i)].substr(0, kColumn));
}

void draw_work(Screen& screen, int first, int end, const ConsoleView& view) {
  const MachineState state = view.machine.control().state();
  screen.put(first, 0, fmt::format("   {:8}{:>12}{:>12}{:>12}  mm", "", "X", "Y", "Z"));
  std::vector<std::string> rows;
  for (int i = 0; i < kWorkSystems; ++i) {
    const WorkOffset work = state.work_system(i);
    rows.push_back(fmt::format(" {} {:8}{}", i == state.active ? '*' : ' ', hal::system_name(i),
                               axes_text(work.origin)));
    if (work.rotation != 0)
      rows.back() += fmt::format("  turned by {:g} deg", deg_from_rad(work.rotation));
  }
  if (state.shift_on) rows.push_back(fmt::format("   {:8}{}", "G92", axes_text(state.shift)));
  put_rows(screen, first + 1, end, rows, view.state.selection);
}

void draw_tools(Screen& screen, int first, int end, const ConsoleView& view) {
  const MachineState state = view.machine.control().state();
  const Machine& machine = view.machine.machine();
  screen.put(first, 0, fmt::format("   {:<28}{:>12}{:>12}  mm", "", "length Z", "radius"));
  std::vector<std::string> rows;
  for (const int number : known_tools(machine, state)) {
    const auto offset = state.tools.find(number);
    const ToolOffset known = offset == state.tools.end() ? ToolOffset() : offset->second;
    rows.push_back(fmt::format(" {} {:<28}{:12.3f}{:12.3f}",
                               state.loaded_tool == number ? '*' : ' ', tool_text(machine, number),
                               known.length[2], known.radius));
  }
  if (rows.empty()) rows.emplace_back("   no tools: G10 L1 P1 Z.. R.. adds one");
  put_rows(screen, first + 1, end, rows, view.state.selection);
}

void draw_found(Screen& screen, int first, int end, const ConsoleView& view) {
  put_rows(screen, first, end, found_lines(view.state), view.state.selection);
}

std::size_t last_row(const ConsoleState& state, const AttendedMachine& machine) {
  switch (state.page) {
    case Page::work:
      return kWorkSystems - 1;
    case Page::tools:
      return std::max<std::size_t>(known_tools(machine.machine(), machine.control().state()).size(),
                                   1) -
             1;
    case Page::found:
      return found_lines(state).size() - 1;
    default:
      return 0;
  }
}

std::string unit_text(const AttendedMachine& machine) {
  return machine.control().mm_per_unit() == 1 ? "mm" : "inches";
}

std::string work_system_name(std::size_t index) {
  return hal::system_name(static_cast<int>(index));
}

std::vector<int> known_tools(const Machine& machine, const MachineState& state) {
  std::set<int> numbers;
  for (const auto& [number, tool] : machine.tools) numbers.insert(number);
  for (const auto& [number, tool] : state.tools) numbers.insert(number);
  if (state.loaded_tool) numbers.insert(*state.loaded_tool);
  return {numbers.begin(), numbers.end()};
}

std::string tool_text(const Machine& machine, int number) {
  const auto tool = machine.tools.find(number);
  return fmt::format(
      "T{}{}", number,
      tool == machine.tools.end() || tool->second.name.empty() ? "" : ' ' + tool->second.name);
}

}  // namespace softcnc::app
