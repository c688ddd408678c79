// SPDX-License-Identifier: MIT
#include "hal/import/linuxcnc_folders.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "hal/machine/toml_text.hpp"
#include "motion/core/utf8.hpp"

namespace softcnc::hal {
namespace {

/// The folder as it counts from the folder of the machine file; a whole path stays.
std::string counted_from(const std::string& target_folder, const std::string& file,
                         const std::string& name) {
  const std::string folder = beside_file(file, name);
  if (std::filesystem::path(name).is_absolute()) return folder;
  std::error_code unreadable;
  const auto relative =
      std::filesystem::proximate(folder, target_folder.empty() ? "." : target_folder, unreadable);
  return unreadable ? folder : relative.string();
}

/// The names between the colons of a list.
std::vector<std::string> names_in(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const auto end = std::min(list.find(':'), list.size());
    const std::string_view name = trimmed_setting(list.substr(0, end));
    if (!name.empty()) names.emplace_back(name);
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return names;
}

}  // namespace

void take_subroutine_path(IniFile& ini, const std::string& file, const std::string& target_folder,
                          MachineDraft& draft) {
  const IniVariable* prefix = ini.find("DISPLAY", "PROGRAM_PREFIX");
  const IniVariable* path = ini.find("RS274NGC", "SUBROUTINE_PATH");
  std::string list;
  for (const IniVariable* given : {prefix, path}) {
    if (!given) continue;
    for (const std::string& name : names_in(given->value)) {
      if (name.starts_with('~'))
        draft.leave(given->at, name + ": name it with its whole path in program.path");
      else
        list += (list.empty() ? "" : ", ") +
                toml_string(as_utf8(counted_from(target_folder, file, name)));
    }
  }
  if (!list.empty()) draft.set("program.path", "[" + list + "]", path ? path->at : prefix->at);
}

}  // namespace softcnc::hal
