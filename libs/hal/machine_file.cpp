// SPDX-License-Identifier: MIT
// From the text of a machine file and the settings on the command line to a Machine.
#include "hal/machine_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <tuple>

#include "hal/machine_keys.hpp"
#include "hal/machine_value.hpp"
#include "hal/number.hpp"
#include "hal/toml_reader.hpp"
#include "motion/units.hpp"

namespace softcnc::hal {
namespace {

constexpr const char* kSetting = "--set";

/// Where a value was given.
struct Place {
  std::string file;
  SourcePos pos;
  std::string line;
};

struct Loaded {
  Machine machine;
  std::map<std::string, Place, std::less<>> given;  // by full name of the key
};

Diagnostic placed(Code code, const Place& place, std::string message) {
  return {code, place.pos, std::move(message), place.file, place.line};
}

bool earlier(const Diagnostic& a, const Diagnostic& b) {
  return std::tie(a.pos.line, a.pos.column) < std::tie(b.pos.line, b.pos.column);
}

/// Collects what file and settings say; the first error wins.
class Loader {
 public:
  void read(std::string_view text, const std::string& name);
  void set(const std::string& setting);
  Result<Loaded> finish();

 private:
  void take(const TomlEntry& entry, std::string_view text, const std::string& name);
  void store(const KeyRef& ref, const FileValue& value, Place place);
  void keep_named_axes(const std::vector<TomlEntry>& entries);
  void derive_servo_period();
  void check_travel(int axis);
  void check_periods();
  const Place& place_of(std::string_view key, std::string_view other) const;

  Loaded loaded_;
  std::vector<Diagnostic> errors_;
};

void Loader::read(std::string_view text, const std::string& name) {
  const auto stem = std::filesystem::path(name).stem().string();
  if (!stem.empty()) loaded_.machine.name = stem;
  const auto entries = read_toml(text);
  if (!entries) {
    const Diagnostic& d = entries.error();
    errors_.push_back(placed(d.code, {name, d.pos, text_line(text, d.pos.line)}, d.message));
    return;
  }
  for (const TomlEntry& entry : *entries) take(entry, text, name);
  keep_named_axes(*entries);
  std::stable_sort(errors_.begin(), errors_.end(), earlier);
}

void Loader::take(const TomlEntry& entry, std::string_view text, const std::string& name) {
  const Place at_value{name, entry.value_pos, text_line(text, entry.value_pos.line)};
  if (is_section(entry.path)) {
    if (!entry.table)
      errors_.push_back(placed(Code::SC7004, at_value, entry.path + " is a table of keys"));
  } else if (const auto ref = find_key(entry.path)) {
    store(*ref, entry.value, at_value);
  } else {
    const Place at_key{name, entry.key_pos, text_line(text, entry.key_pos.line)};
    errors_.push_back(placed(
        Code::SC7001, at_key,
        "unknown key '" + entry.path + "'; did you mean '" + nearest_key(entry.path) + "'?"));
  }
}

void Loader::store(const KeyRef& ref, const FileValue& value, Place place) {
  if (auto stored = assign(ref, value, loaded_.machine); !stored)
    errors_.push_back(placed(stored.error().code, place, std::move(stored.error().message)));
  loaded_.given.insert_or_assign(path_of(ref), std::move(place));
}

void Loader::keep_named_axes(const std::vector<TomlEntry>& entries) {
  std::array<bool, kAxes> named{};
  for (const TomlEntry& entry : entries)
    if (entry.table && entry.path.size() == 6 && is_section(entry.path) &&
        entry.path.starts_with("axis."))
      named[static_cast<std::size_t>(axis_index(entry.path.back()))] = true;
  if (std::none_of(named.begin(), named.end(), [](bool is) { return is; })) return;
  for (std::size_t axis = 0; axis < named.size(); ++axis)
    loaded_.machine.axes[axis].present = named[axis];
}

void Loader::set(const std::string& setting) {
  const auto equals = setting.find('=');
  const auto trimmed = [](std::string_view text) {
    const auto first = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
  };
  const std::string_view all = setting;
  const auto key = trimmed(all.substr(0, equals));
  const auto value = equals == all.npos ? std::string_view{} : trimmed(all.substr(equals + 1));
  const auto place = [&](std::string_view part) {
    const int column = part.empty() ? static_cast<int>(all.size()) + 1
                                    : static_cast<int>(part.data() - all.data()) + 1;
    return Place{kSetting, {1, column, std::max(1, static_cast<int>(part.size()))}, setting};
  };
  if (equals == all.npos || key.empty() || value.empty()) {
    errors_.push_back(placed(Code::SC7011, place(value), "a setting reads KEY=VALUE"));
    return;
  }
  const auto ref = find_key(key);
  if (!ref)
    errors_.push_back(
        placed(Code::SC7001, place(key),
               "unknown key '" + std::string(key) + "'; did you mean '" + nearest_key(key) + "'?"));
  else if (is_axis_key(*ref->key) &&
           !loaded_.machine.axes[static_cast<std::size_t>(ref->index)].present)
    errors_.push_back(
        placed(Code::SC7007, place(key),
               "the machine has no axis " + std::string(key.substr(5, key.find('.', 5) - 5))));
  else
    store(*ref, read_toml_value(std::string(value)), place(value));
}

Result<Loaded> Loader::finish() {
  if (errors_.empty()) {
    derive_servo_period();
    check_periods();
    for (int axis = 0; axis < kAxes; ++axis) check_travel(axis);
  }
  if (!errors_.empty()) return tl::make_unexpected(std::move(errors_.front()));
  return std::move(loaded_);
}

/// Without a word about it the servo period is 1 ms, or the next smaller that divides the period.
void Loader::derive_servo_period() {
  Control& control = loaded_.machine.control;
  if (loaded_.given.contains("control.servo_period_ms")) return;
  const double period_ms = ms_from_s(control.period);
  control.servo_period = s_from_ms(period_ms / std::ceil(period_ms - 1e-9));
}

void Loader::check_periods() {
  const Control& control = loaded_.machine.control;
  const double ratio = control.period / control.servo_period;
  if (ratio > 0.5 && std::abs(ratio - std::round(ratio)) < 1e-9 * ratio) return;
  errors_.push_back(placed(Code::SC7010, place_of("control.period_ms", "control.servo_period_ms"),
                           "control.period_ms = " + number_text(ms_from_s(control.period)) +
                               " is no multiple of control.servo_period_ms = " +
                               number_text(ms_from_s(control.servo_period))));
}

void Loader::check_travel(int index) {
  const Axis& axis = loaded_.machine.axes[static_cast<std::size_t>(index)];
  if (!axis.present || axis.min < axis.max) return;
  const std::string low = path_of(*find_key("axis.x.min_mm")).replace(5, 1, 1, "xyz"[index]);
  const std::string high = path_of(*find_key("axis.x.max_mm")).replace(5, 1, 1, "xyz"[index]);
  errors_.push_back(placed(Code::SC7008, place_of(high, low),
                           low + " = " + number_text(axis.min) + " is not below " + high + " = " +
                               number_text(axis.max)));
}

/// Where the first of two keys was given, or else the second.
const Place& Loader::place_of(std::string_view key, std::string_view other) const {
  const auto found = loaded_.given.find(key);
  return found != loaded_.given.end() ? found->second : loaded_.given.find(other)->second;
}

Diagnostic unreadable(const std::string& file) {
  return {Code::SC7003, {}, "cannot be read: " + std::string(std::strerror(errno)), file, {}};
}

Result<std::string> read_text(const std::string& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"),
                                                               std::fclose);
  if (!stream) return tl::make_unexpected(unreadable(file));
  std::string text;
  std::array<char, 4096> part{};
  while (const auto n = std::fread(part.data(), 1, part.size(), stream.get()))
    text.append(part.data(), n);
  if (std::ferror(stream.get())) return tl::make_unexpected(unreadable(file));
  return text;
}

Result<Loaded> load(Loader& loader, std::span<const std::string> settings) {
  for (const std::string& setting : settings) loader.set(setting);
  return loader.finish();
}

Result<Loaded> load_file(const std::string& file, std::span<const std::string> settings) {
  Loader loader;
  if (file.empty()) return load(loader, settings);
  const auto text = read_text(file);
  if (!text) return tl::make_unexpected(text.error());
  loader.read(*text, file);
  return load(loader, settings);
}

/// What there is to say for one row: itself, or itself for each axis or tool of the machine.
std::vector<KeyRef> instances(const MachineKey& key, const Machine& machine) {
  std::vector<KeyRef> refs;
  if (is_axis_key(key)) {
    for (int axis = 0; axis < kAxes; ++axis)
      if (machine.axes[static_cast<std::size_t>(axis)].present) refs.push_back({&key, axis});
  } else if (is_tool_key(key)) {
    for (const auto& [number, tool] : machine.tools) refs.push_back({&key, number});
  } else {
    refs.push_back({&key, 0});
  }
  return refs;
}

std::string section_of(std::string_view path) {
  const auto dot = path.rfind('.');
  return dot == path.npos ? std::string() : std::string(path.substr(0, dot));
}

/// All keys of a machine, section by section: those of one axis, then those of the next.
std::vector<KeyRef> all_instances(const Machine& machine) {
  std::vector<KeyRef> refs;
  for (const MachineKey& key : machine_keys()) {
    const auto more = instances(key, machine);
    refs.insert(refs.end(), more.begin(), more.end());
  }
  std::stable_sort(refs.begin(), refs.end(), [](const KeyRef& a, const KeyRef& b) {
    const auto group = [](const KeyRef& ref) {
      return std::tuple(is_tool_key(*ref.key), is_axis_key(*ref.key) ? 1 : 0,
                        is_axis_key(*ref.key) || is_tool_key(*ref.key) ? ref.index : 0);
    };
    return group(a) < group(b);
  });
  return refs;
}

std::string origin_text(const Loaded& loaded, const std::string& path) {
  const auto found = loaded.given.find(path);
  if (found == loaded.given.end()) return "default";
  const Place& place = found->second;
  return place.file == kSetting ? place.file : place.file + ":" + std::to_string(place.pos.line);
}

}  // namespace

Result<Machine> load_machine(const std::string& file, std::span<const std::string> settings) {
  return load_file(file, settings).map([](Loaded&& loaded) { return std::move(loaded.machine); });
}

Result<Machine> parse_machine(std::string_view text, const std::string& name,
                              std::span<const std::string> settings) {
  Loader loader;
  loader.read(text, name);
  return load(loader, settings).map([](Loaded&& loaded) { return std::move(loaded.machine); });
}

Result<std::vector<EffectiveValue>> effective_values(const std::string& file,
                                                     std::span<const std::string> settings) {
  const auto loaded = load_file(file, settings);
  if (!loaded) return tl::make_unexpected(loaded.error());
  std::vector<EffectiveValue> values;
  for (const KeyRef& ref : all_instances(loaded->machine)) {
    const std::string path = path_of(ref);
    values.push_back({path, value_text(ref, loaded->machine), std::string(ref.key->unit),
                      origin_text(*loaded, path), std::string(ref.key->meaning)});
  }
  return values;
}

std::string machine_toml(const Machine& machine) {
  std::string text, section;
  for (const KeyRef& ref : all_instances(machine)) {
    const std::string path = path_of(ref);
    if (section_of(path) != section) {
      section = section_of(path);
      text += "\n[" + section + "]\n";
    }
    const std::string name = path.substr(section.empty() ? 0 : section.size() + 1);
    text += name + " = " + value_text(ref, machine) + '\n';
  }
  return text;
}

std::string key_table() {
  Machine machine;
  machine.tools[1] = {};
  std::string text = "| key | default | meaning |\n|---|---|---|\n";
  for (const MachineKey& key : machine_keys()) {
    const KeyRef ref{&key, is_tool_key(key) ? 1 : 0};
    text += "| `" + std::string(key.name) + "` | `" + value_text(ref, machine) + "` | " +
            std::string(key.meaning) + " |\n";
  }
  return text;
}

}  // namespace softcnc::hal
