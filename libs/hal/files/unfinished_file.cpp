// SPDX-License-Identifier: MIT
#include "hal/files/unfinished_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <filesystem>
#include <utility>

namespace softcnc::hal {
namespace {

constexpr std::string_view kMark = ".softcnc-";
constexpr std::string_view kLock = "lock";
constexpr int kAttempts = 100;  // names that are tried

constexpr std::string_view kEndingDigits = "0123456789abcdef";

bool is_ending_digit(char c) noexcept { return kEndingDigits.find(c) != std::string_view::npos; }

/// Empty if the system gives no random numbers; errno says why.
std::string random_ending() {
  std::array<unsigned char, kUnfinishedEnding> random{};
  if (::getrandom(random.data(), random.size(), 0) != static_cast<ssize_t>(random.size()))
    return {};
  std::string ending;
  for (const unsigned char number : random) ending += kEndingDigits[number % kEndingDigits.size()];
  return ending;
}

/// False if somebody else has it. A file system without locks locks nothing.
bool lock(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace

std::string name_beside_target(const std::string& target, std::string_view ending) {
  const std::filesystem::path path = target;
  const std::size_t most = NAME_MAX - 1 - kMark.size() - kUnfinishedEnding;
  std::string name = "." + path.filename().string().substr(0, most);
  return path.parent_path() / name.append(kMark).append(ending);
}

bool is_name_beside_target(std::string_view path) noexcept {
  const std::size_t slash = path.rfind('/');
  if (slash != std::string_view::npos) path.remove_prefix(slash + 1);
  const std::size_t mark = path.rfind(kMark);
  if (!path.starts_with('.') || mark == std::string_view::npos) return false;
  const std::string_view ending = path.substr(mark + kMark.size());
  return ending == kLock || (ending.size() == kUnfinishedEnding &&
                             std::all_of(ending.begin(), ending.end(), is_ending_digit));
}

bool bears(int descriptor, const std::string& name) {
  struct stat file {
  }, named{};
  return ::fstat(descriptor, &file) == 0 && ::lstat(name.c_str(), &named) == 0 &&
         file.st_dev == named.st_dev && file.st_ino == named.st_ino;
}

UnfinishedFile make_unfinished(const std::string& target, mode_t mode) {
  constexpr int kFlags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  for (int i = 0; i < kAttempts; ++i) {
    const std::string ending = random_ending();
    if (ending.empty()) break;
    std::string name = name_beside_target(target, ending);
    const int file = ::open(name.c_str(), kFlags, mode);
    if (file < 0 && errno == EEXIST) continue;
    if (file < 0) break;
    if (lock(file) && bears(file, name)) return {std::move(name), file};
    ::close(file);
    errno = EEXIST;
  }
  return {};
}

}  // namespace softcnc::hal
