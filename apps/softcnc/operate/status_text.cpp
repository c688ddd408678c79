// SPDX-License-Identifier: MIT
// The rows about feed, spindle and program, and what the operator can do next.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "messages/duration_text.hpp"
#include "motion/core/units.hpp"
#include "operate/views.hpp"

namespace softcnc::app {
namespace {

std::string feed_row(const ConsoleView& view) {
  const Setpoint& last = view.machine.control().last();
  const Requests::Overrides& overrides = view.requests.overrides();
  const bool moves = view.machine.control().moving();
  const std::string asked =
      moves && last.feed > 0 ? fmt::format(" of {:.0f}", mm_min_from_mm_s(last.feed)) : "";
  return fmt::format(" feed     {:<23} feed {:.0f} %  rapids {:.0f} %  spindle {:.0f} %",
                     fmt::format("{:.0f}{} mm/min", moves ? mm_min_from_mm_s(last.v) : 0, asked),
                     100 * overrides.feed, 100 * overrides.rapid, 100 * overrides.spindle);
}

std::string spindle_row(const ConsoleView& view) {
  const runtime::Operator& control = view.machine.control();
  const Outputs& on = control.outputs();
  std::string text = on.spindle_rpm == 0
                         ? "off"
                         : fmt::format("{:.0f} rpm {}", std::abs(on.spindle_rpm),
                                       on.spindle_rpm > 0 ? "clockwise" : "counterclockwise");
  if (on.mist) text += ", mist";
  if (on.flood) text += ", flood";
  const auto tool = control.state().loaded_tool;
  if (tool && *tool > 0) text += ", " + tool_text(view.machine.machine(), *tool);
  std::string row = fmt::format(" spindle  {:<37}", text);
  if (control.moving()) row += fmt::format(" limit: {}", name(control.last().limit));
  return row;
}

std::string progress_row(const ConsoleView& view) {
  const LoadedProgram& program = *view.state.program;
  const CheckedProgram* checked = program.checked();
  std::string text = fmt::format(" line     {} of {}", view.state.line, program.lines());
  const double gone = view.machine.program_time();
  if (checked != nullptr && checked->time > 0)
    text += fmt::format(
        ", {:.0f} %, about {} left", std::min(100 * gone / checked->time, 100.0),
        duration_text(std::max(checked->time - gone, 0.0) / view.requests.overrides().feed));
  return text;
}

std::string jog_row(const ConsoleView& view) {
  const Requests::Switches& switches = view.requests.switches();
  std::string text = fmt::format("{:g} mm, {:.0f} mm/min", kJogSteps[view.state.jog_step],
                                 kJogFeeds[view.state.jog_feed]);
  std::string on;
  if (switches.single_block) on += "  single block";
  if (switches.optional_stop) on += "  optional stop";
  if (switches.block_skip) on += "  block skip";
  return fmt::format(" jog      {:<22}{}", text, on);
}

std::string span_text(const runtime::TravelSpan& span) {
  std::string text;
  for (int axis = 0; axis < kAxes; ++axis)
    if (!span.empty(axis))
      text += fmt::format(" {} {:.1f} to {:.1f}", kAxisLetters[static_cast<std::size_t>(axis)],
                          span.min[axis], span.max[axis]);
  return text;
}

std::string pause_advice(const ConsoleView& view, const runtime::Pause& pause) {
  const auto* action = std::get_if<Action>(&pause.block.what);
  if (pause.before || action == nullptr)
    return fmt::format("single block: Enter runs line {}", pause.block.source.line);
  if (runtime::is_tool_change(pause))
    return tool_text(view.machine.machine(), static_cast<int>(action->value)) + " in, then Enter";
  return fmt::format("M{:02}: Enter goes on", action->code);
}

}  // namespace

std::vector<std::string> status_rows(const ConsoleView& view) {
  std::vector<std::string> rows{feed_row(view), spindle_row(view)};
  if (view.state.runs) rows.push_back(progress_row(view));
  rows.push_back(jog_row(view));
  return rows;
}

std::string program_summary(const ConsoleView& view) {
  if (!view.state.program) return {};
  const CheckedProgram* checked = view.state.program->checked();
  if (checked == nullptr) return "c checks the program";
  if (!checked->passed) return "the program cannot run: v shows why";
  return fmt::format("{}, machine{}: s starts", duration_text(checked->time),
                     span_text(checked->span));
}

std::string advice(const ConsoleView& view) {
  using enum runtime::MachineMode;
  const runtime::Operator& control = view.machine.control();
  const bool known = control.knows_position();
  const std::string find = "h homes, k says where the machine stands";
  switch (control.mode()) {
    case idle:
      return known ? program_summary(view) : "the position is not known: " + find;
    case alarm:
      return known ? "Alarm: u unlocks"
                   : "Alarm, and the position is not known: u unlocks; " + find;
    case hold:
      if (control.in_motion()) return "the machine is coming to rest, or moved by hand";
      if (control.is_short_of_change()) return "Enter goes on to the place for tool changes";
      if (const runtime::Pause* pause = control.pause()) return pause_advice(view, *pause);
      return control.return_point() ? "Enter goes back and on, a ends the program"
                                    : "Enter goes on, a ends the program";
    case door:
      return "the door is open, or was: Enter goes on";
    case check:
      return "lines are only judged; r ends that";
    case sleep:
      return "outputs are off until r";
    default:
      return {};
  }
}

}  // namespace softcnc::app
