// SPDX-License-Identifier: MIT
#include "hal/machine/machine_confinement.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "hal/files/folder_bounds.hpp"

namespace softcnc::hal {
namespace {

/// A key by which a backend reaches outside, and what a machine does without it.
struct OutsideKey {
  BackendKind backend;
  std::string_view key;
  std::string& (*value)(Machine&);
  std::string_view without;
};

constexpr OutsideKey kOutsideKeys[] = {
    {BackendKind::stepdir, "backend.stepdir.file",
     [](Machine& machine) -> std::string& { return machine.step_port.file; },
     "no edges are written"},
    {BackendKind::parport, "backend.parport.device",
     [](Machine& machine) -> std::string& { return machine.parallel_port.device; },
     "no port is opened"},
    {BackendKind::hal_stream, "backend.hal-stream.file",
     [](Machine& machine) -> std::string& { return machine.hal_stream.file; }, "no rows are sent"},
};

constexpr std::string_view kBackendKey = "control.backend";

/// Where the file of the machine gives a value; null where a setting or nobody does.
const GivenAt* place_in_file(const LoadedMachine& loaded, std::string_view key) {
  const auto found = loaded.given.find(key);
  return found == loaded.given.end() || found->second.file == kSettingFile ? nullptr
                                                                           : &found->second;
}

bool is_set(const LoadedMachine& loaded, std::string_view key) {
  return loaded.given.contains(key) && !place_in_file(loaded, key);
}

Diagnostic ignored(const OutsideKey& opening, std::string_view key, const GivenAt& place) {
  return {.code = Code::SC7021,
          .pos = place.pos,
          .message = std::string(key) +
                     " is ignored unless --machine names the file: " + std::string(opening.without),
          .file = place.file,
          .source_line = place.line};
}

/// Leaves only the folders of subprograms that lie in the folder of the machine file.
void confine_path(LoadedMachine& loaded, std::vector<Diagnostic>& changes) {
  constexpr std::string_view kPathKey = "program.path";
  const GivenAt* place = place_in_file(loaded, kPathKey);
  if (!place) return;
  ProgramReading& reading = loaded.machine.program;
  const std::string base = reading.path_base.empty() ? "." : reading.path_base;
  const auto leads_out = [&](const std::string& folder) {
    const std::string path = folder.starts_with('/') ? folder : base + '/' + folder;
    return !is_in_folder(real_path(path), real_path(base));
  };
  const auto first = std::find_if(reading.path.begin(), reading.path.end(), leads_out);
  if (first == reading.path.end()) return;
  changes.push_back({.code = Code::SC7021,
                     .pos = place->pos,
                     .message = std::string(kPathKey) + ": '" + *first +
                                "' is ignored unless --machine names the file: it is not in the "
                                "folder of the file",
                     .file = place->file,
                     .source_line = place->line});
  std::erase_if(reading.path, leads_out);
}

}  // namespace

std::string name_beside(const std::string& part) {
  return std::filesystem::path(part).replace_extension(".toml");
}

std::string machine_beside(const std::string& part) {
  std::string file = name_beside(part);
  std::error_code ignored;
  const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(file, ignored));
  return file.ends_with(".state.toml") || !is_there ? std::string() : file;
}

std::vector<Diagnostic> confine(LoadedMachine& loaded) {
  std::vector<Diagnostic> changes;
  confine_path(loaded, changes);
  for (const OutsideKey& opening : kOutsideKeys) {
    if (is_set(loaded, opening.key)) continue;
    const GivenAt* named = place_in_file(loaded, opening.key);
    const GivenAt* chosen = place_in_file(loaded, kBackendKey);
    std::string& value = opening.value(loaded.machine);
    const bool would_reach =
        loaded.machine.control.backend == opening.backend && !value.empty() && (named || chosen);
    if (would_reach)
      changes.push_back(
          ignored(opening, named ? opening.key : kBackendKey, named ? *named : *chosen));
    if (named || chosen) value.clear();
    if (named) loaded.given.erase(loaded.given.find(opening.key));
  }
  return changes;
}

bool writes_default_file(const LoadedMachine& loaded) {
  Machine machine = loaded.machine;
  for (const OutsideKey& opening : kOutsideKeys)
    if (opening.backend == machine.control.backend && opening.backend != BackendKind::parport)
      return !loaded.given.contains(opening.key) && !opening.value(machine).empty();
  return false;
}

}  // namespace softcnc::hal
