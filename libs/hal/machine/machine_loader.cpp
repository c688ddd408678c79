// SPDX-License-Identifier: MIT
// What a machine file and settings say, checked and put in place.
#include "hal/machine/machine_loader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "hal/machine/device_keys.hpp"
#include "hal/machine/foreign_keys.hpp"
#include "motion/core/spelling.hpp"
#include "motion/core/units.hpp"
#include "motion/core/utf8.hpp"

namespace softcnc::hal {
namespace {

std::string unknown(std::string_view key, const std::string& nearest) {
  return "unknown key '" + std::string(key) + "'" + did_you_mean(nearest);
}

/// Of a key that other controls have, what softcnc has in its place.
std::string unknown_value(const std::string& key, const FileValue& value) {
  const std::string counterpart = counterpart_of(key, value);
  if (counterpart.empty()) return unknown(key, nearest_key(key));
  return "unknown key '" + key + "': " + counterpart;
}

/// Those of the file come first, then those of its plant, and those of settings last, in the order
/// in which they are found.
bool earlier(const Diagnostic& a, const Diagnostic& b, const std::string& file) {
  const auto rank = [&](const Diagnostic& error) {
    return error.file == kSettingFile ? 2 : error.file == file ? 0 : 1;
  };
  if (rank(a) != rank(b) || rank(a) == 2) return rank(a) < rank(b);
  return std::tie(a.pos.line, a.pos.column) < std::tie(b.pos.line, b.pos.column);
}

bool is_in_table(std::string_view path, std::string_view table) {
  return path.size() > table.size() && path.starts_with(table) && path[table.size()] == '.';
}

bool names_axis(const TomlEntry& entry) {
  constexpr std::string_view kAxis = "axis.";
  return entry.table && entry.path.starts_with(kAxis) && entry.path.size() == kAxis.size() + 1 &&
         is_section(entry.path);
}

/// What stands in state files, and in no machine file; null: nothing.
const TomlEntry* find_state(const std::vector<TomlEntry>& entries) {
  constexpr std::array<std::string_view, 8> kOfStates{
      "schema", "active", "g92_in_force", "g92", "g28", "g30", "work", "parameter"};
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const TomlEntry& entry) {
    return std::find(kOfStates.begin(), kOfStates.end(), entry.path) != kOfStates.end();
  });
  return found == entries.end() ? nullptr : &*found;
}

std::string_view trimmed(std::string_view text) {
  const auto first = std::min(text.find_first_not_of(" \t"), text.size());
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// KEY=VALUE taken apart. Both parts lie within the setting.
struct Setting {
  std::string_view key, value;
};

Setting split_setting(std::string_view setting) {
  const auto equals = setting.find('=');
  if (equals == setting.npos) return {trimmed(setting), setting.substr(setting.size())};
  return {trimmed(setting.substr(0, equals)), trimmed(setting.substr(equals + 1))};
}

/// Whether a value may be the empty text.
bool takes_text(std::string_view key) {
  const auto ref = find_key(key);
  return ref && std::holds_alternative<TextKey>(ref->key->value);
}

GivenAt place_in(const std::string& setting, std::string_view part) {
  const int column = static_cast<int>(part.data() - setting.data()) + 1;
  return {
      std::string(kSettingFile), {1, column, std::max(1, static_cast<int>(part.size()))}, setting};
}

}  // namespace

void MachineLoader::fail(Code code, const GivenAt& place, std::string message) {
  errors_.push_back({.code = code,
                     .pos = place.pos,
                     .message = std::move(message),
                     .file = place.file,
                     .source_line = place.line});
}

/// Reports values that do not go together, once per place, and not where one has been refused.
void MachineLoader::clash(Code code, Keys keys, std::string message) {
  const auto is_refused = [this](const std::string& key) { return refused_.contains(key); };
  if (std::any_of(keys.begin(), keys.end(), is_refused)) return;
  const GivenAt& place = place_of(keys);
  const auto is_this = [&](const Diagnostic& known) {
    return known.code == code && known.file == place.file && known.source_line == place.line &&
           known.pos.line == place.pos.line && known.pos.column == place.pos.column;
  };
  if (std::none_of(errors_.begin(), errors_.end(), is_this)) fail(code, place, std::move(message));
}

void MachineLoader::read(std::string_view text, const std::string& name) {
  const std::string stem = as_utf8(std::filesystem::path(name).stem().string());
  if (!stem.empty()) loaded_.machine.name = stem;
  file_ = name;
  const TextLines lines(text);
  const auto place = [&](const SourcePos& pos) {
    return GivenAt{name, pos, std::string(lines[pos.line])};
  };
  const auto entries = read_toml(text);
  if (!entries) {
    const Diagnostic& broken = entries.error();
    is_doubtful_ = true;
    return fail(broken.code, place(broken.pos), broken.message);
  }
  if (const TomlEntry* of_state = find_state(*entries)) {
    is_doubtful_ = true;
    return fail(Code::SC7020, place(of_state->key_pos),
                "'" + of_state->path + "' belongs in a state file: this is not a machine file");
  }
  take_all(*entries, lines, name);
  if (std::any_of(entries->begin(), entries->end(), names_axis)) keep_named_axes(*entries);
  keep_named_axes_of_plant(*entries, lines);
}

/// The contents of a table that is refused are not reported as well. Tables come before them.
void MachineLoader::take_all(const std::vector<TomlEntry>& entries, const TextLines& lines,
                             const std::string& name) {
  std::string_view refused_table;
  for (const TomlEntry& entry : entries) {
    if (!refused_table.empty() && is_in_table(entry.path, refused_table)) continue;
    const std::size_t before = errors_.size();
    if (before >= kMostErrors) return;
    take(entry, lines, name);
    if (entry.table && errors_.size() > before) refused_table = entry.path;
  }
}

void MachineLoader::take(const TomlEntry& entry, const TextLines& lines, const std::string& name) {
  const auto at = [&](const SourcePos& pos) {
    return GivenAt{name, pos, std::string(lines[pos.line])};
  };
  if (is_device_path(entry.path)) {
    take_device(entry, lines, name);
  } else if (is_section(entry.path)) {
    if (entry.table) return;
    is_doubtful_ = true;
    fail(Code::SC7004, at(entry.value_pos), entry.path + " must be a table");
  } else if (const auto ref = find_key(entry.path)) {
    take(*ref, entry.value, at(entry.value_pos));
  } else {
    is_doubtful_ = true;
    fail(Code::SC7001, at(entry.key_pos),
         entry.table ? unknown(entry.path, nearest_section(entry.path))
                     : unknown_value(entry.path, entry.value));
  }
}

void MachineLoader::take(const KeyRef& ref, const FileValue& value, GivenAt place) {
  const auto stored = assign(ref, value, loaded_.machine);
  if (!stored) {
    fail(stored.error().code, place, stored.error().message);
    refused_.insert(path_of(ref));
  }
  if (std::holds_alternative<ListKey>(ref.key->value))
    loaded_.machine.program.path_base =
        place.file == kSettingFile ? "" : std::filesystem::path(place.file).parent_path().string();
  loaded_.given.insert_or_assign(path_of(ref), std::move(place));
}

/// Axes that are not those of the built-in mill do not take its limit along the path either.
void MachineLoader::keep_named_axes(const std::vector<TomlEntry>& entries) {
  if (!loaded_.given.contains("limits.feed_mm_min")) loaded_.machine.limits.feed = 0;
  for (Axis& axis : loaded_.machine.axes) axis.present = false;
  for (const TomlEntry& entry : entries)
    if (names_axis(entry))
      loaded_.machine.axes[static_cast<std::size_t>(axis_index(entry.path.back()))].present = true;
}

void MachineLoader::set(const std::string& setting) {
  const auto [key, value] = split_setting(setting);
  const bool has_value = !value.empty() || (takes_text(key) && setting.find('=') != setting.npos);
  if (key.empty() || !has_value)
    return fail(Code::SC7011, place_in(setting, value), "a setting reads KEY=VALUE");
  if (!is_utf8(value))
    return fail(Code::SC7002, place_in(setting, value), "not TOML: a value that is not UTF-8");
  if (is_device_path(key))
    return set_device(std::string(key), std::string(value), place_in(setting, key),
                      place_in(setting, value));
  const auto ref = find_key(key);
  if (!ref) {
    is_doubtful_ = true;
    return fail(Code::SC7001, place_in(setting, key),
                unknown_value(std::string(key), read_toml_value(std::string(value))));
  }
  if (!has_axis_of(*ref)) {
    if (is_doubtful_) return;
    return fail(Code::SC7007, place_in(setting, key),
                std::string(ref->index < kAxes ? "the machine" : "the plant") + " has no axis " +
                    axis_name(ref->index % kAxes));
  }
  take(*ref, read_toml_value(std::string(value)), place_in(setting, value));
}

bool MachineLoader::has_axis_of(const KeyRef& ref) const {
  if (!is_axis_key(*ref.key)) return true;
  return axis_at(loaded_.machine, ref.index).present &&
         (ref.index < kAxes || loaded_.machine.plant.given);
}

LoadedOrErrors MachineLoader::finish() {
  if (!is_doubtful_) {
    check_periods();
    for (int axis = 0; axis < kAxes; ++axis) check_travel(axis);
    for (int axis = 0; axis < kAxes; ++axis) check_home(axis);
    check_devices();
    check_tool_change();
    for (int axis = 0; axis < kAxes; ++axis) check_plant(axis);
    check_compensation();
    const Control& control = loaded_.machine.control;
    const bool steps =
        control.backend == BackendKind::stepdir || control.backend == BackendKind::parport;
    if (steps || is_by_pulses(control.interpolation)) check_step_port();
    if (control.backend == BackendKind::parport) check_parallel_port();
    if (ignores_plan(control.interpolation)) check_method();
  }
  if (errors_.empty()) return std::move(loaded_);
  const auto sooner = [this](const Diagnostic& a, const Diagnostic& b) {
    return earlier(a, b, file_);
  };
  std::stable_sort(errors_.begin(), errors_.end(), sooner);
  return tl::make_unexpected(std::move(errors_));
}

void MachineLoader::check_periods() {
  constexpr double kRoundOff = 1e-9;
  const Control& control = loaded_.machine.control;
  if (control.servo_period == 0) return;
  const double ratio = control.period / control.servo_period;
  if (ratio > 0.5 && std::abs(ratio - std::round(ratio)) < kRoundOff * ratio) return;
  clash(Code::SC7010, {"control.period_ms", "control.servo_period_ms"},
        "control.period_ms = " + number_text(ms_from_s(control.period)) +
            " is not a multiple of control.servo_period_ms = " +
            number_text(ms_from_s(control.servo_period)));
}

void MachineLoader::check_travel(int index) {
  const Axis& axis = loaded_.machine.axes[static_cast<std::size_t>(index)];
  if (!axis.present || axis.min < axis.max) return;
  const std::string name = "axis." + axis_name(index);
  clash(Code::SC7008, {name + ".max_mm", name + ".min_mm"},
        name + ".min_mm = " + number_text(axis.min) + " is not below " + name +
            ".max_mm = " + number_text(axis.max));
}

/// Behind its home switch, where homing ends, an axis must be within its travel, and far enough
/// from the switch for a backend that sees it once a period.
void MachineLoader::check_home(int index) {
  constexpr double kPeriodsOff = 4;
  const Axis& axis = loaded_.machine.axes[static_cast<std::size_t>(index)];
  const HomeSwitch& home = axis.home;
  if (!has_home_switch(axis)) return;
  const std::string name = "axis." + axis_name(index);
  const double rest = home.rest();
  if (rest < axis.min || rest > axis.max)
    clash(Code::SC7028,
          {name + ".home.switch_mm", name + ".home.back_off_mm", name + ".home.search_mm_min"},
          name + " rests at " + number_text(rest) + " after homing, beyond its travel from " +
              number_text(axis.min) + " to " + number_text(axis.max));
  const double least = kPeriodsOff * std::abs(home.search) * loaded_.machine.control.period;
  if (home.back_off < least)
    clash(Code::SC7028, {name + ".home.back_off_mm", name + ".home.search_mm_min"},
          name + ".home.back_off_mm = " + number_text(home.back_off) +
              " is less than the search covers in four periods, " + number_text(least) + " mm");
}

/// Where the first of several keys was given that was given at all.
const GivenAt& MachineLoader::place_of(Keys keys) const {
  const auto given = [this](const std::string& key) { return loaded_.given.contains(key); };
  return loaded_.given.find(*std::find_if(keys.begin(), keys.end(), given))->second;
}

}  // namespace softcnc::hal
