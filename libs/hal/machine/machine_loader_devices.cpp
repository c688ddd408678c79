// SPDX-License-Identifier: MIT
// M codes, outputs and inputs of a machine file and of settings.
#include <algorithm>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "hal/machine/device_keys.hpp"
#include "hal/machine/machine_loader.hpp"
#include "motion/core/spelling.hpp"

namespace softcnc::hal {

void MachineLoader::take_device(const TomlEntry& entry, const TextLines& lines,
                                const std::string& name) {
  const auto at = [&](const SourcePos& pos) {
    return GivenAt{name, pos, std::string(lines[pos.line])};
  };
  const auto path = device_path(entry.path);
  const bool is_table = path && path->key.empty();
  if (!path || (entry.table && !is_table)) {
    is_doubtful_ = true;
    fail(Code::SC7001, at(entry.key_pos),
         "unknown key '" + entry.path + "'" + did_you_mean(nearest_device_key(entry.path)));
  } else if (is_table && !entry.table) {
    is_doubtful_ = true;
    fail(Code::SC7004, at(entry.value_pos), entry.path + " must be a table");
  } else if (!is_table) {
    take_device_value(entry.path, entry.value, at(entry.value_pos));
  } else if (!path->of.empty()) {
    take_device_table(entry.path, at(entry.key_pos));
  }
}

/// False, after a report, if there can be none.
bool MachineLoader::take_device_table(const std::string& path, GivenAt place) {
  const auto made = make_device(*device_path(path), loaded_.machine);
  if (!made) fail(made.error().code, place, made.error().message);
  if (made) loaded_.given.insert_or_assign(path, std::move(place));
  return made.has_value();
}

void MachineLoader::take_device_value(const std::string& path, const FileValue& value,
                                      GivenAt place) {
  const auto stored = assign_device(*device_path(path), value, loaded_.machine);
  if (!stored) {
    fail(stored.error().code, place, stored.error().message);
    refused_.insert(path);
  }
  loaded_.given.insert_or_assign(path, std::move(place));
}

void MachineLoader::set_device(const std::string& key, const std::string& value,
                               const GivenAt& key_place, GivenAt value_place) {
  const auto path = device_path(key);
  if (!path || path->key.empty()) {
    is_doubtful_ = true;
    return fail(Code::SC7001, key_place,
                "unknown key '" + key + "'" + did_you_mean(nearest_device_key(key)));
  }
  const std::string table = path->table + '.' + path->of;
  if (loaded_.given.contains(table) || take_device_table(table, key_place))
    take_device_value(key, read_toml_value(value), std::move(value_place));
}

void MachineLoader::check_devices() {
  const auto is_given = [this](const std::string& key) { return loaded_.given.contains(key); };
  for (const DeviceClash& found : device_clashes(loaded_.machine, is_given)) {
    const auto is_refused = [this](const std::string& key) { return refused_.contains(key); };
    if (std::any_of(found.keys.begin(), found.keys.end(), is_refused)) continue;
    const auto place = std::find_if(found.keys.begin(), found.keys.end(), is_given);
    if (place != found.keys.end())
      fail(found.code, loaded_.given.find(*place)->second, found.message);
  }
}

void MachineLoader::check_tool_change() {
  const std::vector<double>& at = loaded_.machine.attendance.tool_change;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Axis& axis = loaded_.machine.axes[i];
    if (!axis.present || (at[i] >= axis.min && at[i] <= axis.max)) continue;
    const std::string name = "axis." + axis_name(static_cast<int>(i));
    clash(Code::SC7029, {"tool_change.at", name + ".min_mm", name + ".max_mm"},
          "tool_change.at: " + number_text(at[i]) + " is beyond the travel of " + name + " from " +
              number_text(axis.min) + " to " + number_text(axis.max));
  }
}

}  // namespace softcnc::hal
