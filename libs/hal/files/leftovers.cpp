// SPDX-License-Identifier: MIT
#include "hal/files/leftovers.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "hal/files/output_file.hpp"
#include "hal/files/unfinished_file.hpp"

namespace softcnc::hal {
namespace {

Diagnostic leftover(const std::string& name, const std::string& says) {
  return {.code = Code::SC6016, .message = says, .file = name};
}

/// The names beside `target` of unfinished files, sorted.
std::vector<std::string> unfinished_names(const std::string& target) {
  const std::string begin = name_beside_target(target, "");
  const std::filesystem::path folder = std::filesystem::path(begin).parent_path();
  std::vector<std::string> names;
  std::error_code error;
  std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    std::string name = folder / entries->path().filename();
    const bool is_one = name.size() == begin.size() + kUnfinishedEnding &&
                        name.starts_with(begin) && is_name_beside_target(name);
    if (is_one) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Nothing is said of a file that is being written, has just got its name, or is no file; nor of
/// one that may not be read, of which that cannot be known.
void remove_leftover(const std::string& name, std::vector<Diagnostic>& notes) {
  struct stat info {};
  const int file = ::open(name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return;
  const bool is_left = ::fstat(file, &info) == 0 && S_ISREG(info.st_mode) &&
                       ::flock(file, LOCK_EX | LOCK_NB) == 0 && bears(file, name);
  if (is_left && ::unlink(name.c_str()) == 0)
    notes.push_back(leftover(name, "left unfinished by a run that was killed; it is removed"));
  else if (is_left)
    notes.push_back(leftover(
        name, std::string("left unfinished by a run that was killed; it cannot be removed: ") +
                  std::strerror(errno)));
  ::close(file);
}

}  // namespace

std::vector<Diagnostic> remove_leftovers(const std::string& file) {
  std::vector<Diagnostic> notes;
  if (!is_replaced(file)) return notes;
  for (const std::string& name : unfinished_names(target_of(file))) remove_leftover(name, notes);
  return notes;
}

}  // namespace softcnc::hal
