// SPDX-License-Identifier: MIT
#include "input/program_files.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "hal/files/suffix.hpp"

namespace softcnc::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 7> kSuffixes{".nc", ".ngc", ".tap", ".gcode",
                                                    ".gc", ".cnc", ".eia"};

bool is_program(const std::string& file) {
  return std::ranges::any_of(
      kSuffixes, [&](std::string_view suffix) { return hal::has_suffix(file, suffix); });
}

Result<std::vector<std::string>> programs_below(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code error;
  auto at = fs::recursive_directory_iterator(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error))
    if (std::error_code ignored; at->is_regular_file(ignored) && is_program(at->path().string()))
      found.push_back(at->path().string());
  if (error)
    return tl::make_unexpected(Diagnostic{
        .code = Code::SC6001, .message = "cannot read it: " + error.message(), .file = folder});
  if (found.empty())
    return tl::make_unexpected(Diagnostic{
        .code = Code::SC6001,
        .message = "the folder holds no part program (.nc, .ngc, .tap, .gcode, .gc, .cnc, .eia)",
        .file = folder});
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

Result<std::vector<std::string>> programs_in(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!fs::is_directory(name, ignored)) {
      files.push_back(name);
      continue;
    }
    auto below = programs_below(name);
    if (!below) return below;
    files.insert(files.end(), below->begin(), below->end());
  }
  return files;
}

}  // namespace softcnc::app
