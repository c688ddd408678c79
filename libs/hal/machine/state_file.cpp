// SPDX-License-Identifier: MIT
// A state as named numbers: the same names lead a number into the state and out of it.
#include "hal/machine/state_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "hal/files/text_file.hpp"
#include "hal/machine/state_keys.hpp"
#include "hal/machine/state_names.hpp"
#include "hal/machine/toml_reader.hpp"
#include "hal/machine/toml_text.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr int kLastTool = 999'999'999;  // the longest number that T takes

/// Where a number of the file has its place in a state.
struct StateSlot {
  double* place;
  double (*to_internal)(double) = unconverted;
  double limit = kFarthest;  // either way, in the unit of the file
};

std::optional<StateSlot> axis_slot(AxisVector& vector, std::string_view key) {
  for (int axis = 0; axis < kAxes; ++axis)
    if (key == axis_name(axis) + "_mm") return StateSlot{&vector[axis]};
  return std::nullopt;
}

std::optional<StateSlot> work_slot(WorkOffset& work, std::string_view key) {
  if (key == "rotation_deg") return StateSlot{&work.rotation, rad_from_deg, kMostTurned};
  return axis_slot(work.origin, key);
}

std::optional<StateSlot> tool_slot(MachineState& state, int number, std::string_view key) {
  ToolOffset& tool = state.tools[number];
  if (key == "radius_mm") return StateSlot{&tool.radius};
  if (key == "length_wear_mm") return StateSlot{&tool.length_wear};
  if (key == "radius_wear_mm") return StateSlot{&tool.radius_wear};
  return axis_slot(tool.length, key);
}

std::optional<StateSlot> parameter_slot(MachineState& state, std::string_view key) {
  if (const std::string name = global_name(key); !name.empty())
    return StateSlot{&state.globals[name], unconverted, std::numeric_limits<double>::max()};
  const auto number = number_of(key);
  if (!number || *number < kFirstParameter || *number > kLastParameter) return std::nullopt;
  return StateSlot{&state.parameters[*number], unconverted, std::numeric_limits<double>::max()};
}

KeptPosition& kept_position(MachineState& state) {
  if (!state.position) state.position.emplace();
  return *state.position;
}

/// The place of G30 P3 and P4, which is known once the file names one of its axes.
std::optional<StateSlot> further_home_slot(std::optional<AxisVector>& home, std::string_view key) {
  AxisVector none;
  if (!axis_slot(none, key)) return std::nullopt;
  if (!home) home = AxisVector::Zero();
  return axis_slot(*home, key);
}

std::optional<StateSlot> find_slot(MachineState& state, std::string_view path) {
  if (const std::string_view name = without(path, "parameter."); !name.empty())
    return parameter_slot(state, name);
  const auto dot = std::min(path.rfind('.'), path.size());
  const std::string_view table = path.substr(0, dot),
                         key = path.substr(std::min(dot + 1, path.size()));
  AxisVector none;
  if (table == "position" && axis_slot(none, key))
    return axis_slot(kept_position(state).place, key);
  if (table == "g92") return axis_slot(state.shift, key);
  if (table == "g28") return axis_slot(state.home, key);
  if (table == "g30") return axis_slot(state.second_home, key);
  if (const auto home = index_in(kFurtherHomes, table))
    return further_home_slot(state.further_homes[static_cast<std::size_t>(*home)], key);
  if (const auto work = system_index(without(table, "work.")))
    return work_slot(state.work_system_entry(*work), key);
  if (const auto tool = number_of(without(table, "tool."))) return tool_slot(state, *tool, key);
  return std::nullopt;
}

bool is_table(std::string_view path) {
  constexpr std::array<std::string_view, 7> kTables{"position", "work", "g92",      "g28",
                                                    "g30",      "tool", "parameter"};
  return index_in(kTables, path) || index_in(kFurtherHomes, path) ||
         system_index(without(path, "work.")) || number_of(without(path, "tool."));
}

/// Collects what a file says, and all that is wrong with it, up to kMostErrors. In a file of
/// another schema, or of none, nothing else is wrong: it is another file.
class StateReader {
 public:
  StateReader(std::string_view text, std::string name)
      : text_(text), lines_(text), name_(std::move(name)) {}

  StateOrErrors read();

 private:
  void read_schema(const std::vector<TomlEntry>& entries);
  bool is_within_refused(std::string_view path) const;
  void take(const TomlEntry& entry);
  void take_value(const TomlEntry& entry);
  void take_number(const TomlEntry& entry);
  void take_tool(const TomlEntry& entry);
  bool is_new(const TomlEntry& entry);
  std::optional<int> work_system(const TomlEntry& entry);
  std::optional<int> word(const TomlEntry& entry, std::span<const std::string_view> words);
  void fail(Code code, const SourcePos& pos, std::string message);

  std::string_view text_;
  TextLines lines_;
  std::string name_;
  MachineState state_;
  std::string refused_;  // the last table that was
  std::map<std::string, SourcePos> globals_;
  std::vector<Diagnostic> errors_;
};

void StateReader::fail(Code code, const SourcePos& pos, std::string message) {
  errors_.push_back({.code = code,
                     .pos = pos,
                     .message = std::move(message),
                     .file = name_,
                     .source_line = std::string(lines_[pos.line])});
}

StateOrErrors StateReader::read() {
  const auto entries = read_toml(text_);
  if (!entries) {
    const Diagnostic& broken = entries.error();
    fail(broken.code == Code::SC7002 ? Code::SC7013 : broken.code, broken.pos, broken.message);
    return tl::make_unexpected(std::move(errors_));
  }
  read_schema(*entries);
  if (errors_.empty())
    for (const TomlEntry& entry : *entries)
      if (errors_.size() < kMostErrors && !is_within_refused(entry.path)) take(entry);
  if (errors_.empty()) return std::move(state_);
  std::stable_sort(errors_.begin(), errors_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.pos.line, a.pos.column) < std::tie(b.pos.line, b.pos.column);
  });
  return tl::make_unexpected(std::move(errors_));
}

/// The contents of a table that has been refused are not reported as well. Tables come before what
/// they contain.
bool StateReader::is_within_refused(std::string_view path) const {
  return !refused_.empty() && without(path, refused_).starts_with('.');
}

void StateReader::take(const TomlEntry& entry) {
  const std::size_t before = errors_.size();
  take_value(entry);
  if (errors_.size() > before && entry.table) refused_ = entry.path;
}

void StateReader::take_value(const TomlEntry& entry) {
  if (entry.path == "schema") return;
  if (entry.path == "active") {
    state_.active = work_system(entry).value_or(0);
  } else if (entry.path == "g92_in_force") {
    state_.shift_on = word(entry, kNoYes).value_or(0) == 1;
  } else if (entry.path == "position.in_motion") {
    kept_position(state_).in_motion = word(entry, kNoYes).value_or(0) == 1;
  } else if (entry.path == "tool_in_spindle") {
    take_tool(entry);
  } else if (is_table(entry.path)) {
    if (!entry.table) fail(Code::SC7004, entry.value_pos, entry.path + " must be a table");
  } else {
    take_number(entry);
  }
}

void StateReader::read_schema(const std::vector<TomlEntry>& entries) {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [](const TomlEntry& one) { return one.path == "schema"; });
  if (entry == entries.end())
    return fail(Code::SC7016, {}, "is not a state file of softcnc: it names no schema");
  const double schema = as_number(entry->value).value_or(0);
  if (schema == kStateSchema) return;
  fail(Code::SC7016, entry->value_pos,
       "is a state of schema " + number_text(schema) + "; this version reads schema " +
           std::to_string(kStateSchema));
}

/// Names that differ in case or blanks alone are one; tables are not in the order of their lines.
bool StateReader::is_new(const TomlEntry& entry) {
  const std::string name = global_name(without(entry.path, "parameter."));
  if (name.empty()) return true;
  const auto [known, added] = globals_.try_emplace(name, entry.key_pos);
  if (added) return true;
  const SourcePos& first = known->second;
  const bool is_later = first.line < entry.key_pos.line;
  fail(Code::SC7012, is_later ? entry.key_pos : first, "'" + name + "' is given twice");
  return false;
}

void StateReader::take_number(const TomlEntry& entry) {
  if (!is_new(entry)) return;
  const auto slot = find_slot(state_, entry.path);
  if (!slot) return fail(Code::SC7015, entry.key_pos, unknown_state_key(entry.path));
  const auto value = as_number(entry.value);
  if (!value) return fail(Code::SC7004, entry.value_pos, entry.path + " takes a number");
  if (!(std::abs(*value) <= slot->limit))
    return fail(Code::SC7005, entry.value_pos,
                entry.path + " must be from " + number_text(-slot->limit) + " to " +
                    number_text(slot->limit) + ", not " + number_text(*value));
  *slot->place = slot->to_internal(*value + 0.0);
}

void StateReader::take_tool(const TomlEntry& entry) {
  const auto number = as_number(entry.value);
  if (!number) return fail(Code::SC7004, entry.value_pos, entry.path + " takes a number");
  if (!(*number >= 0 && *number <= kLastTool) || *number != std::floor(*number))
    return fail(Code::SC7005, entry.value_pos,
                entry.path + " must be a whole number from 0 to " + std::to_string(kLastTool) +
                    ", not " + number_text(*number));
  state_.loaded_tool = static_cast<int>(*number);
}

std::optional<int> StateReader::work_system(const TomlEntry& entry) {
  const auto* given = std::get_if<std::string>(&entry.value);
  const auto index = given ? system_index(*given) : std::nullopt;
  if (!index)
    fail(given ? Code::SC7006 : Code::SC7004, entry.value_pos,
         entry.path + " takes one of " + quoted_words(kWorkNames) + ", or '" +
             system_name(kWorkSystems) + "' to '" +
             system_name(kWorkSystems + kFurtherSystems - 1) + "'");
  return index;
}

std::optional<int> StateReader::word(const TomlEntry& entry,
                                     std::span<const std::string_view> words) {
  const auto* given = std::get_if<std::string>(&entry.value);
  const auto index = given ? index_in(words, *given) : std::nullopt;
  if (!index)
    fail(given ? Code::SC7006 : Code::SC7004, entry.value_pos,
         entry.path + " takes one of " + quoted_words(words));
  return index;
}

}  // namespace

StateOrErrors load_state(const std::string& file) {
  const auto text = read_text(file, Code::SC7014);
  if (!text) return tl::make_unexpected(std::vector{text.error()});
  return parse_state(*text, file);
}

StateOrErrors parse_state(const std::string& text, const std::string& name) {
  return StateReader(text, name).read();
}

}  // namespace softcnc::hal
