// SPDX-License-Identifier: MIT
// What is typed at the prompts of the console.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "motion/model/probe_tip.hpp"
#include "operate/console.hpp"
#include "operate/probing_cycles.hpp"
#include "operate/views.hpp"

namespace softcnc::app {

void Console::open(Prompt prompt) {
  answers_.clear();
  state_.prompt = std::move(prompt);
}

void Console::show(Page page) {
  state_.page = page;
  state_.selection = 0;
}

void Console::ask_for_row() {
  const std::string unit = unit_text(machine_);
  if (state_.page == Page::work) {
    open({Prompt::For::work, fmt::format("origin of {} in {}, as X-200 Y-150: ",
                                         work_system_name(state_.selection), unit)});
  } else if (const auto tool = selected_tool(); tool && state_.page == Page::tools) {
    open({Prompt::For::tool, fmt::format("T{} in {}, as Z-62.5 R3: ", *tool, unit)});
  }
}

std::optional<int> Console::selected_tool() const {
  const auto tools = known_tools(machine_.machine(), machine_.control().state());
  return state_.selection < tools.size() ? std::optional(tools[state_.selection]) : std::nullopt;
}

/// Of the page of tools: m measures by where the tip stands, g puts a tool into the spindle.
void Console::key_of_tools(const Key& key) {
  const auto tool = selected_tool();
  if (!tool) return;
  if (key == key_of('m'))
    open({Prompt::For::tip,
          fmt::format("T{}: its tip stands at work Z, in {}: ", *tool, unit_text(machine_))});
  if (key == key_of('g')) {
    show(Page::main);
    requests_.line(fmt::format("T{} M06\nG43", *tool));
  }
}

void Console::take(const std::string& text) {
  const Prompt::For what = state_.prompt->what;
  if (what == Prompt::For::line) {
    if (text.empty()) state_.prompt.reset();
    if (!text.empty()) requests_.line(text);
    if (state_.prompt)
      state_.prompt->label =
          machine_.control().is_line_open() ? "line, until it is closed: " : "line: ";
    return;
  }
  state_.prompt.reset();
  const bool may_be_empty = what == Prompt::For::position;
  if (text.empty() && !may_be_empty) return;
  switch (what) {
    case Prompt::For::line:
      break;
    case Prompt::For::program:
      return load(text);
    case Prompt::For::touch_off:
      take_place(text, &Requests::touch_off);
      break;
    case Prompt::For::position:
      take_place(text, &Requests::stand_at);
      break;
    case Prompt::For::probe:
      return take_probe(text);
    case Prompt::For::work:
      requests_.line(fmt::format("G10 L2 P{} {}", state_.selection + 1, text));
      break;
    case Prompt::For::tool:
      if (const auto tool = selected_tool())
        requests_.line(fmt::format("G10 L1 P{} {}", *tool, text));
      break;
    case Prompt::For::tip:
      if (const auto tool = selected_tool())
        requests_.line(fmt::format("G10 L10 P{} Z{}", *tool, text));
      break;
  }
}

bool Console::take_place(const std::string& text,
                         bool (Requests::*request)(const AxisWords&, const std::string&)) {
  const AxisWords place = axis_words(words_of(text));
  if (machine_.control().in_motion()) {
    journal_.add(EntryKind::action, text);
    journal_.add(EntryKind::fault, "not while the machine moves");
    return false;
  }
  if (place.wrong.empty()) return (requests_.*request)(place, text);
  journal_.add(EntryKind::action, text);
  journal_.add(EntryKind::fault, "'" + place.wrong + "' is not an axis in mm, as X-12.5");
  return false;
}

void Console::take_probe(const std::string& text) {
  const runtime::Operator& control = machine_.control();
  journal_.add(EntryKind::action, "probe " + text);
  if (control.in_motion()) return journal_.add(EntryKind::fault, "not while the machine moves");
  const Machine& machine = machine_.machine();
  const double radius = probe_tip(machine, control.state().loaded_tool).radius;
  const auto lines = probing_lines(text, {control.position(), radius}, machine);
  if (!lines) return journal_.add(EntryKind::fault, lines.error());
  probes_ = requests_.line("M70\n" + *lines);
}

}  // namespace softcnc::app
