// SPDX-License-Identifier: MIT
#include "hal/import/import_machine.hpp"

#include <algorithm>
#include <filesystem>

#include "hal/files/suffix.hpp"
#include "hal/files/text_file.hpp"
#include "hal/import/fluidnc_configuration.hpp"
#include "hal/import/grbl_settings.hpp"
#include "hal/import/linuxcnc_configuration.hpp"
#include "hal/import/machine_draft.hpp"
#include "hal/import/tool_table_file.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

enum class Kind : std::uint8_t { unknown, tool_table, configuration, grbl, fluidnc };

bool begins_with_section(std::string_view text) {
  for (const std::string& line : setting_lines(text)) {
    const std::string_view setting = trimmed_setting(line);
    if (setting.empty() || setting.starts_with('#') || setting.starts_with(';')) continue;
    return setting.starts_with('[') && setting.find(']') != setting.npos &&
           setting.find(':') == setting.npos;
  }
  return false;
}

Kind kind_of(const std::string& file, std::string_view text) {
  if (has_suffix(file, ".tbl")) return Kind::tool_table;
  if (has_suffix(file, ".ini")) return Kind::configuration;
  if (is_grbl_settings(text)) return Kind::grbl;
  if (is_fluidnc_configuration(text)) return Kind::fluidnc;
  if (is_tool_table(text)) return Kind::tool_table;
  return begins_with_section(text) ? Kind::configuration : Kind::unknown;
}

std::string made_from(const std::string& file, std::string_view kind) {
  return "Made by softcnc machine import of " + std::string(kind) + " " + file;
}

tl::unexpected<std::vector<Diagnostic>> refused(Diagnostic error) {
  return tl::make_unexpected(std::vector{std::move(error)});
}

}  // namespace

tl::expected<ImportedMachine, std::vector<Diagnostic>> import_machine(
    const std::string& file, const ImportOptions& options) {
  auto text = read_text(file, Code::SC7033);
  if (!text) return refused(std::move(text.error()));
  return import_text(*text, file, options);
}

tl::expected<ImportedMachine, std::vector<Diagnostic>> import_text(const std::string& text,
                                                                   const std::string& file,
                                                                   const ImportOptions& options) {
  MachineDraft draft(std::filesystem::path(file).parent_path().string(), options.allowed_folders);
  switch (kind_of(file, text)) {
    case Kind::tool_table:
      take_tool_table(text, file, options.inches ? kMmPerInch : 1, draft);
      return draft.finish(file, made_from(file, "the tool table"));
    case Kind::configuration:
      take_configuration(text, file, options.folder, draft);
      return draft.finish(file, made_from(file, "the configuration of LinuxCNC"));
    case Kind::grbl:
      take_grbl_settings(text, file, draft);
      return draft.finish(file, made_from(file, "the settings of grbl in"));
    case Kind::fluidnc:
      take_fluidnc_configuration(text, file, draft);
      return draft.finish(file, made_from(file, "the configuration of FluidNC"));
    case Kind::unknown:
      break;
  }
  return refused({.code = Code::SC7032,
                  .message =
                      "is neither a tool table nor a configuration of LinuxCNC, nor a list of "
                      "settings of grbl or a configuration of FluidNC",
                  .file = file});
}

}  // namespace softcnc::hal
