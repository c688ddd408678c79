// SPDX-License-Identifier: MIT
// `softcnc state`: what a state file holds, for a person; and offsets and the position set in it.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>

#include "commands/commands.hpp"
#include "hal/files/number.hpp"
#include "hal/machine/state_file.hpp"
#include "hal/machine/state_names.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"
#include "motion/core/units.hpp"
#include "settings/axis_words.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

std::string axes_text(const AxisVector& place) {
  std::string text;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    text += fmt::format("{}{:<11} ", kAxisLetters[axis],
                        hal::number_text(place[static_cast<Eigen::Index>(axis)]));
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

/// The lines of `softcnc state show`. What is as on a new machine is left out.
class StateText {
 public:
  explicit StateText(const MachineState& state) : state_(state) {}

  std::string text() {
    add_position();
    add("work system", hal::system_name(state_.active));
    for (int i = 0; i < kWorkSystems; ++i) add_work(i);
    for (const auto& [number, work] : state_.further_work) add_work(kWorkSystems + number - 1);
    if (state_.shift_on || !state_.shift.isZero(0))
      add("G92", axes_text(state_.shift) + (state_.shift_on ? "" : "  (not in force)"));
    if (!state_.home.isZero(0)) add("G28", axes_text(state_.home));
    if (!state_.second_home.isZero(0)) add("G30", axes_text(state_.second_home));
    for (std::size_t i = 0; i < state_.further_homes.size(); ++i)
      if (const auto& home = state_.further_homes[i])
        add(fmt::format("G30 P{}", i + 3), axes_text(*home));
    if (state_.loaded_tool) add("in the spindle", fmt::format("tool {}", *state_.loaded_tool));
    for (const auto& [number, tool] : state_.tools) add_tool(number, tool);
    for (const auto& [number, value] : state_.parameters)
      if (value != 0) add(fmt::format("#{}", number), hal::number_text(value));
    for (const auto& [name, value] : state_.globals)
      add(fmt::format("#<{}>", name), hal::number_text(value));
    return std::move(text_);
  }

 private:
  void add(std::string_view what, std::string_view value) {
    text_ += fmt::format("{:<15} {}\n", what, value);
  }

  void add_position() {
    if (!state_.position) return add("position", "never kept: programs begin at machine zero");
    const AxisVector& place = state_.position->place;
    if (state_.position->in_motion)
      return add("position",
                 "not known: a run that began at " + axes_text(place) + " did not end at rest");
    add("position", axes_text(place));
    const WorkOffset work = state_.work_system(state_.active);
    const AxisVector shift = state_.shift_on ? state_.shift : AxisVector(AxisVector::Zero());
    if (work.rotation == 0 && !(work.origin + shift).isZero(0))
      add("  in " + hal::system_name(state_.active), axes_text(place - work.origin - shift));
  }

  void add_work(int index) {
    const WorkOffset work = state_.work_system(index);
    if (work == WorkOffset()) return;
    const std::string turned =
        work.rotation == 0 ? "" : fmt::format("  turned by {:g} deg", deg_from_rad(work.rotation));
    add(hal::system_name(index), axes_text(work.origin) + turned);
  }

  void add_tool(int number, const ToolOffset& tool) {
    std::string text = "length " + axes_text(tool.length);
    const auto also = [&](const char* what, double mm) {
      if (mm != 0) text += fmt::format("  {} {}", what, hal::number_text(mm));
    };
    also("radius", tool.radius);
    also("length wear", tool.length_wear);
    also("radius wear", tool.radius_wear);
    add(fmt::format("tool {}", number), text);
  }

  const MachineState& state_;
  std::string text_;
};

int usage_failure(std::string message) {
  return failed({.code = Code::SC6014, .message = std::move(message)});
}

/// Where a name of `state set` has its place in a state; null if there is no such name.
AxisVector* place_of(MachineState& state, const std::string& name) {
  std::string upper = name;
  for (char& c : upper)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  if (upper == "G28") return &state.home;
  if (upper == "G30") return &state.second_home;
  if (upper == "POSITION") {
    if (!state.position) state.position.emplace();
    return &state.position->place;
  }
  const auto system = parse_work_system(name);
  return system ? &state.work_system_entry(*system).origin : nullptr;
}

/// Returns what is wrong with `state set`; empty where it has been done.
std::string set(MachineState& state, std::span<const std::string> words) {
  const bool was_known = state.position && !state.position->in_motion;
  AxisVector* place = words.empty() ? nullptr : place_of(state, words.front());
  if (place == nullptr)
    return "state set: " + (words.empty() ? "" : '\'' + words.front() + "' is not ") +
           "position, G28, G30, G54 to G59.3 or G54.1P1 to G54.1P300";
  const bool is_position = state.position && place == &state.position->place;
  const AxisWords given = axis_words(words.subspan(1));
  if (!given.wrong.empty())
    return "state set: '" + given.wrong + "' is not an axis in mm, as X-12.5";
  if (given.named() == 0) return "state set " + words.front() + ": needs X, Y or Z, as X-12.5";
  if (is_position && !was_known && given.named() < kAxes)
    return "state set position: the position is not known, so X, Y and Z are needed";
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    if (given.mm[axis]) (*place)[static_cast<Eigen::Index>(axis)] = *given.mm[axis];
  if (is_position) state.position->in_motion = false;
  return {};
}

int set_in_file(const Options& options) {
  auto memory = MachineMemory::open(options.state);
  if (!memory) return failed(memory.error());
  Messages messages;
  auto state = open_state(options, messages);
  if (!state) return messages.fail(state.error());
  memory->read(*state);
  if (const std::string wrong = set(*state, std::span(options.action).subspan(1)); !wrong.empty())
    return usage_failure(wrong);
  const auto kept = memory->keep(*state);
  return kept ? 0 : failed(kept.error());
}

int show(const Options& options) {
  std::error_code ignored;
  if (!std::filesystem::exists(options.state, ignored))
    return failed({.code = Code::SC7014, .message = "does not exist", .file = options.state});
  Messages messages;
  const auto state = open_state(options, messages);
  if (!state) return messages.fail(state.error());
  StandardOutput out;
  out.write(StateText(*state).text());
  return out.finish();
}

}  // namespace

int state(const Options& options) {
  if (options.action.front() == "set") return set_in_file(options);
  if (options.action.front() != "show" || options.action.size() > 1)
    return usage_failure("softcnc state: 'show', or 'set NAME X.. Y.. Z..'; not '" +
                         options.action.back() + "'");
  return show(options);
}

}  // namespace softcnc::app
