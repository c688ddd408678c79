// SPDX-License-Identifier: MIT
// Machines from files and back to text.
#include "hal/machine/machine_file.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <system_error>
#include <tuple>

#include "hal/files/folder_bounds.hpp"
#include "hal/files/text_file.hpp"
#include "hal/machine/device_keys.hpp"
#include "hal/machine/machine_confinement.hpp"
#include "hal/machine/machine_keys.hpp"
#include "hal/machine/machine_loader.hpp"
#include "hal/machine/machine_value.hpp"
#include "motion/model/subprogram_path.hpp"

namespace softcnc::hal {
namespace {

LoadedOrErrors load_text(const std::string* text, const std::string& name,
                         std::span<const std::string> settings, MachineOrigin origin) {
  const auto names_plant = [](const std::string& setting) {
    return setting.substr(0, setting.find_first_of(" \t=")) == kPlantKey;
  };
  MachineLoader loader;
  if (text) loader.read(*text, name);
  for (const std::string& setting : settings)
    if (names_plant(setting)) loader.set(setting);
  loader.read_plant(origin);
  for (const std::string& setting : settings)
    if (!names_plant(setting)) loader.set(setting);
  return loader.finish();
}

LoadedOrErrors load_file(const std::string& file, std::span<const std::string> settings,
                         MachineOrigin origin = MachineOrigin::file) {
  if (file.empty()) return load_text(nullptr, {}, settings, origin);
  const auto text = read_text(file, Code::SC7003);
  if (!text) return tl::make_unexpected(std::vector{text.error()});
  if (text->size() > kLongestMachine)
    return tl::make_unexpected(std::vector{Diagnostic{
        .code = Code::SC7003, .message = "cannot be read: longer than 1 MiB", .file = file}});
  return load_text(&*text, file, settings, origin);
}

/// Whether a link leads to a file that is not below the folder of the link.
bool leads_out(const std::string& file) {
  std::error_code error;
  return std::filesystem::is_symlink(file, error) &&
         !is_in_folder(real_path(file), real_path(std::filesystem::path(file).parent_path()));
}

/// A file that nobody has named is neither waited for nor passed over.
std::optional<Diagnostic> unlike_a_file(const std::string& file) {
  std::error_code error;
  const auto type = std::filesystem::status(file, error).type();
  const bool regular = type == std::filesystem::file_type::regular;
  if (regular && !leads_out(file)) return std::nullopt;
  const std::string why = regular ? "it is a link out of its folder; name the machine by --machine"
                          : type == std::filesystem::file_type::not_found
                              ? "it is a link to nothing"
                              : "it is not a regular file";
  return Diagnostic{.code = Code::SC7003, .message = "cannot be read: " + why, .file = file};
}

Machine machine_of(LoadedMachine&& loaded) { return std::move(loaded.machine); }

/// What a row stands for in this machine: itself, or itself for each axis or tool.
std::vector<KeyRef> instances(const MachineKey& key, const Machine& machine) {
  std::vector<KeyRef> refs;
  if (is_axis_key(key)) {
    for (int axis = 0; axis < kAxes; ++axis)
      if (machine.axes[static_cast<std::size_t>(axis)].present) refs.push_back({&key, axis});
    for (int axis = 0; machine.plant.given && axis < kAxes; ++axis)
      if (machine.plant.axes[static_cast<std::size_t>(axis)].present)
        refs.push_back({&key, kAxes + axis});
  } else if (is_tool_key(key)) {
    for (const auto& [number, tool] : machine.tools) refs.push_back({&key, number});
  } else {
    refs.push_back({&key, 0});
  }
  return refs;
}

/// All keys of a machine, in the order of the table, but each axis and each tool in one piece.
std::vector<KeyRef> all_instances(const Machine& machine) {
  std::vector<KeyRef> refs;
  for (const MachineKey& key : machine_keys())
    for (const KeyRef& ref : instances(key, machine)) refs.push_back(ref);
  std::stable_sort(refs.begin(), refs.end(), [](const KeyRef& a, const KeyRef& b) {
    const auto group = [](const KeyRef& ref) {
      const int kind = is_tool_key(*ref.key) ? 2 : is_axis_key(*ref.key) ? 1 : 0;
      return std::tuple(kind, ref.index);
    };
    return group(a) < group(b);
  });
  return refs;
}

std::string origin_of(const LoadedMachine& loaded, const std::string& path) {
  const auto found = loaded.given.find(path);
  if (found == loaded.given.end()) return "default";
  const GivenAt& place = found->second;
  return place.file == kSettingFile ? place.file
                                    : place.file + ":" + std::to_string(place.pos.line);
}

}  // namespace

MachineOrErrors load_machine(const std::string& file, std::span<const std::string> settings) {
  return load_file(file, settings).map(machine_of);
}

MachineOrErrors parse_machine(const std::string& text, const std::string& name,
                              std::span<const std::string> settings) {
  return load_text(&text, name, settings, MachineOrigin::memory).map(machine_of);
}

tl::expected<FoundMachine, std::vector<Diagnostic>> find_machine(
    const MachineSource& source, std::span<const std::string> settings) {
  if (source.confined)
    if (auto error = unlike_a_file(source.file))
      return tl::make_unexpected(std::vector{*std::move(error)});
  const auto origin = source.confined ? MachineOrigin::confined : MachineOrigin::file;
  auto loaded = load_file(source.file, settings, origin);
  if (!loaded) return tl::make_unexpected(std::move(loaded.error()));
  FoundMachine found;
  found.ignored = std::move(loaded->ignored);
  if (source.confined) std::ranges::move(confine(*loaded), std::back_inserter(found.ignored));
  found.default_file = writes_default_file(*loaded);
  found.machine = std::move(loaded->machine);
  return found;
}

namespace {

/// Visits the path, the value and the key of each value, in the order of the table.
template <typename Visit>
void for_each_value(Machine& machine, Visit&& visit) {
  for (const KeyRef& ref : all_instances(machine))
    visit(path_of(ref), value_text(ref, machine), *ref.key);
  for (const DeviceValue& value : device_values(machine))
    visit(value.path, value.value, *value.key);
}

}  // namespace

tl::expected<std::vector<EffectiveValue>, std::vector<Diagnostic>> effective_values(
    const std::string& file, std::span<const std::string> settings) {
  auto loaded = load_file(file, settings);
  if (!loaded) return tl::make_unexpected(std::move(loaded.error()));
  loaded->machine = with_whole_paths(std::move(loaded->machine));
  std::vector<EffectiveValue> values;
  for_each_value(loaded->machine,
                 [&](const std::string& path, const std::string& value, const auto& key) {
                   values.push_back({path, value, std::string(key.unit), origin_of(*loaded, path),
                                     std::string(key.meaning)});
                 });
  return values;
}

namespace {

/// Keys and values, in the order of the table.
std::vector<std::pair<std::string, std::string>> values_of(Machine machine) {
  std::vector<std::pair<std::string, std::string>> values;
  for_each_value(machine, [&](const std::string& path, const std::string& value, const auto&) {
    values.emplace_back(path, value);
  });
  return values;
}

const std::string& value_in(const std::vector<std::pair<std::string, std::string>>& values,
                            const std::string& key) {
  static const std::string kNone;
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const auto& value) { return value.first == key; });
  return found == values.end() ? kNone : found->second;
}

}  // namespace

std::vector<DifferingValue> differing_values(const Machine& a, const Machine& b) {
  const auto of_a = values_of(a), of_b = values_of(b);
  std::vector<DifferingValue> differing;
  const auto is_place = [](const std::string& key) {
    return key.ends_with(".file") || key.ends_with(".device");
  };
  for (const auto& [key, value] : of_a)
    if (const std::string& other = value_in(of_b, key); other != value && !is_place(key))
      differing.push_back({key, value, other});
  for (const auto& [key, value] : of_b)
    if (value_in(of_a, key).empty() && !is_place(key)) differing.push_back({key, "", value});
  return differing;
}

namespace {

std::string toml_of(Machine machine, bool explained) {
  std::string text, section;
  for_each_value(machine, [&](const std::string& path, const std::string& value, const auto& key) {
    const auto dot = path.rfind('.');
    const std::string table = dot == path.npos ? "" : path.substr(0, dot);
    if (table != section) text += "\n[" + table + "]\n";
    section = table;
    if (explained) text += "# " + std::string(key.meaning) + '\n';
    text += path.substr(dot + 1) + " = " + value + '\n';
  });
  return text;
}

}  // namespace

std::string machine_toml(const Machine& machine) { return toml_of(machine, false); }

std::string readable_machine_toml(const Machine& machine, bool explained) {
  return "# A machine of softcnc. Units are in the names of the keys; docs/machine.md says what "
         "they mean.\n\n" +
         toml_of(with_whole_paths(machine), explained);
}

Machine with_whole_paths(Machine machine) {
  std::vector<std::string> whole;
  for (const std::string& folder : subprogram_path(machine.program)) {
    std::error_code unreadable;
    const auto path = std::filesystem::absolute(folder, unreadable);
    whole.push_back(unreadable ? folder : path.lexically_normal().string());
  }
  machine.program.path = std::move(whole);
  return machine;
}

std::string key_table() {
  Machine machine;
  machine.tools[1] = {};
  std::string text = "| key | default | takes | meaning |\n|---|---|---|---|\n";
  for (const MachineKey& key : machine_keys()) {
    const KeyRef ref{&key, is_tool_key(key) ? 1 : 0};
    text += "| `" + std::string(key.name) + "` | `" + value_text(ref, machine) + "` | " +
            allowed_text(key) + " | " + std::string(key.meaning) + " |\n";
  }
  return text;
}

}  // namespace softcnc::hal
