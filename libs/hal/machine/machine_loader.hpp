// SPDX-License-Identifier: MIT
// From the text of a machine file and the settings on the command line to a Machine.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hal/machine/machine_value.hpp"
#include "hal/machine/toml_reader.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

/// The longest text of a machine, in bytes: hundreds of times what any machine needs, a thousand
/// tools included.
inline constexpr std::size_t kLongestMachine = std::size_t{1} << 20U;

/// The key that names the plant.
inline constexpr std::string_view kPlantKey = "backend.sim.plant";

/// The file that diagnostics of settings name.
inline constexpr std::string_view kSettingFile = "--set";

/// The place where a value was given.
struct GivenAt {
  std::string file;
  SourcePos pos;
  std::string line;
};

struct LoadedMachine {
  Machine machine;
  std::map<std::string, GivenAt, std::less<>> given;  // by full name of the key
  std::vector<Diagnostic> ignored;                    // SC7021: a plant that is not read
};

/// Where the text of a machine comes from, and which files it may name as its plant.
enum class MachineOrigin : std::uint8_t {
  file,      // that a user has named: any
  confined,  // that nobody has named: one in the same folder
  memory,    // none: its plant stands in it
};

using LoadedOrErrors = tl::expected<LoadedMachine, std::vector<Diagnostic>>;

/// Collects what a file and then settings say, and their errors, up to kMostErrors, except errors
/// that follow from others.
class MachineLoader {
 public:
  void read(std::string_view text, const std::string& name);
  void set(const std::string& setting);  // "KEY=VALUE"
  /// Reads the plant that the file or a setting names, unless it stands in the file itself: to be
  /// called after read() and the settings that choose it, before those that change it.
  void read_plant(MachineOrigin origin);

  /// Fills in what was left out and checks values against one another. To be called once.
  LoadedOrErrors finish();

 private:
  void take_all(const std::vector<TomlEntry>& entries, const TextLines& lines,
                const std::string& name);
  void take(const TomlEntry& entry, const TextLines& lines, const std::string& name);
  void take(const KeyRef& ref, const FileValue& value, GivenAt place);
  void take_device(const TomlEntry& entry, const TextLines& lines, const std::string& name);
  bool take_device_table(const std::string& path, GivenAt place);
  void take_device_value(const std::string& path, const FileValue& value, GivenAt place);
  void set_device(const std::string& key, const std::string& value, const GivenAt& key_place,
                  GivenAt value_place);
  void keep_named_axes(const std::vector<TomlEntry>& entries);
  void keep_named_axes_of_plant(const std::vector<TomlEntry>& entries, const TextLines& lines);
  std::optional<std::string> plant_to_read(MachineOrigin origin);
  void take_plant(MachineLoader&& plant);
  void check_plant(int index);
  void check_compensation();
  void check_periods();
  void check_travel(int index);
  void check_home(int index);
  void check_devices();
  void check_tool_change();
  void check_method();
  void check_rough_period();
  void check_averages();
  void check_step_port();
  void check_pulse_rate(int index);
  void check_feed(double rate, const std::string& in_words);
  void check_parallel_port();
  void check_port_rate(int index);
  void check_home_pin(int index);
  void check_pin(const std::string& key, int pin, bool (*fits)(int));
  void check_pin_of(const std::string& name, int pin, bool (*fits)(int));

  bool has_axis_of(const KeyRef& ref) const;
  using Keys = std::initializer_list<std::string>;
  const GivenAt& place_of(Keys keys) const;
  void fail(Code code, const GivenAt& place, std::string message);
  void clash(Code code, Keys keys, std::string message);

  LoadedMachine loaded_;
  std::string file_;                            // as diagnostics of its text name it
  std::map<int, std::string> used_pins_;        // of the parallel port, and by which key
  std::set<std::string, std::less<>> refused_;  // keys whose values are
  bool is_doubtful_ = false;  // what could not be read may have been meant for any key
  std::vector<Diagnostic> errors_;
};

}  // namespace softcnc::hal
