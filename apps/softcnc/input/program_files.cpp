// SPDX-License-Identifier: MIT
#include "input/program_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "hal/files/suffix.hpp"
#include "motion/core/result.hpp"

namespace softcnc::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kSuffixes{".nc", ".ngc", ".tap", ".gcode",
                                                    ".gc", ".cnc", ".eia"};

bool is_program(const std::string& file) {
  return std::ranges::any_of(
      kSuffixes, [&](std::string_view suffix) { return hal::has_suffix(file, suffix); });
}

Diagnostic folder_error(const std::string& folder, std::string message) {
  return {.code = Code::SC6001, .message = std::move(message), .file = folder};
}

Result<std::vector<std::string>> programs_below(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code error;
  auto at = fs::recursive_directory_iterator(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error))
    if (std::error_code ignored; at->is_regular_file(ignored) && is_program(at->path().string()))
      found.push_back(at->path().string());
  if (error) return tl::make_unexpected(folder_error(folder, "cannot read it: " + error.message()));
  if (found.empty())
    return tl::make_unexpected(folder_error(
        folder, "the folder holds no part program (.nc, .ngc, .tap, .gcode, .gc, .cnc, .eia)"));
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

ProgramFiles programs_in(const std::vector<std::string>& names) {
  ProgramFiles files;
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!fs::is_directory(name, ignored)) {
      files.names.push_back(name);
    } else if (auto below = programs_below(name)) {
      files.names.insert(files.names.end(), below->begin(), below->end());
    } else {
      files.errors.push_back(below.error());
    }
  }
  return files;
}

}  // namespace softcnc::app
