// SPDX-License-Identifier: MIT
// `softcnc machine`: the effective machine, each value with where it came from; or as a machine
// file, also one made of the settings of another control.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "commands/commands.hpp"
#include "hal/import/import_machine.hpp"
#include "hal/machine/machine_file.hpp"
#include "hal/machine/state_file.hpp"
#include "messages/messages.hpp"
#include "messages/standard_output.hpp"

namespace softcnc::app {
namespace {

int write_machine(const std::string& text, const std::string& file) {
  if (file.empty()) {
    StandardOutput out;
    out.write(text);
    return out.finish();
  }
  const Status written = hal::write_file(file, text);
  return written ? 0 : failed(written.error());
}

int write_toml(const Options& options) {
  const auto machine = hal::load_machine(options.machine_file, options.settings);
  if (!machine) return failed(machine.error());
  return write_machine(hal::readable_machine_toml(*machine, options.verbose), options.output);
}

/// What machine files have no place for: to the file that is named, or a note says that there is
/// something.
Status write_state(const MachineState& state, const Options& options, Messages& messages) {
  if (options.state.empty()) {
    if (state != MachineState())
      messages.show({.code = Code::SC7031,
                     .message =
                         "tool lengths and offsets belong in a state file: --state FILE.toml "
                         "writes one",
                     .file = options.imported});
    return {};
  }
  std::error_code ignored;
  const auto type = std::filesystem::symlink_status(options.state, ignored).type();
  if (type != std::filesystem::file_type::not_found)
    return tl::make_unexpected(Diagnostic{.code = Code::SC7038,
                                          .message = "exists already, and is not overwritten",
                                          .file = options.state});
  return hal::write_file(options.state, hal::state_toml(state));
}

int import_settings(const Options& options) {
  const bool in_working_folder = options.output.empty() || options.output == "-";
  hal::ImportOptions how;
  if (!in_working_folder) how.folder = std::filesystem::path(options.output).parent_path();
  how.inches = options.imports_inches;
  how.allowed_folders = options.allowed_folders;
  const auto imported = hal::import_machine(options.imported, how);
  if (!imported) return failed(imported.error());
  Messages messages;
  for (const Diagnostic& note : imported->notes) messages.show(note);
  if (Status kept = write_state(imported->state, options, messages); !kept)
    return failed(kept.error());
  return write_machine(imported->machine, options.output);
}

int list_values(const Options& options) {
  const auto values = hal::effective_values(options.machine_file, options.settings);
  if (!values) return failed(values.error());
  const auto widest = [&](std::string hal::EffectiveValue::*column) {
    std::size_t width = 0;
    for (const auto& value : *values) width = std::max(width, (value.*column).size());
    return width;
  };
  using Value = hal::EffectiveValue;
  const std::size_t key = widest(&Value::key), text = widest(&Value::value),
                    unit = widest(&Value::unit), origin = widest(&Value::origin);
  StandardOutput out;
  for (const auto& value : *values) {
    std::string line = fmt::format("{:<{}} = {:<{}}  # {:<{}}  {:<{}}", value.key, key, value.value,
                                   text, value.unit, unit, value.origin, origin);
    if (options.verbose) line += "  " + value.meaning;
    line.erase(line.find_last_not_of(' ') + 1);
    out.write(line + '\n');
  }
  return out.finish();
}

}  // namespace

int machine(const Options& options) {
  if (!options.imported.empty()) return import_settings(options);
  return options.toml ? write_toml(options) : list_values(options);
}

}  // namespace softcnc::app
