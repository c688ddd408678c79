// SPDX-License-Identifier: MIT
#include "hal/files/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "hal/files/output_file.hpp"
#include "hal/files/unfinished_file.hpp"

namespace softcnc::hal {
namespace {

/// Another user's may be one that can only be read, which is enough for a lock.
int open_lock(const std::string& name) {
  constexpr int kFlags = O_NOFOLLOW | O_CLOEXEC;
  int file = ::open(name.c_str(), O_RDWR | O_CREAT | kFlags, kNewFileMode);
  if (file >= 0 || errno != EACCES) return file;
  file = ::open(name.c_str(), O_RDONLY | kFlags);
  if (file < 0) errno = EACCES;
  return file;
}

/// Why open_lock() has failed. The file itself might be there.
std::string why_not(const std::string& name) {
  const std::string reason = std::strerror(errno);
  return errno == ENOENT ? reason : "its lock " + name + ": " + reason;
}

/// A file system without locks takes none.
bool is_taken(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

/// What the holder has written: its number.
std::string holder(int descriptor) {
  std::array<char, 32> text{};
  const ssize_t n = ::pread(descriptor, text.data(), text.size(), 0);
  std::string number(text.data(), n > 0 ? static_cast<std::size_t>(n) : 0);
  while (number.ends_with('\n')) number.pop_back();
  const bool is_number =
      !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? "process " + number : "another run";
}

/// For the message to another process; the lock does not need it.
void sign(int descriptor) {
  const std::string number = std::to_string(::getpid()) + '\n';
  if (::ftruncate(descriptor, 0) != 0) return;
  if (::pwrite(descriptor, number.data(), number.size(), 0) < 0) return;
}

}  // namespace

Result<FileLock> FileLock::take(const std::string& file) {
  if (!is_replaced(file)) return FileLock(-1);
  std::string name = name_beside_target(target_of(file), "lock");
  for (;;) {
    FileLock lock(open_lock(name));
    if (lock.descriptor_ < 0)
      return file_failure(Code::SC6011, file, "cannot be created: " + why_not(name));
    if (is_taken(lock.descriptor_))
      return file_failure(Code::SC6017, file, "is in use by " + holder(lock.descriptor_));
    if (!bears(lock.descriptor_, name)) continue;  // its last holder has just removed it
    sign(lock.descriptor_);
    lock.name_ = std::move(name);
    return lock;
  }
}

FileLock::~FileLock() {
  if (!name_.empty()) ::unlink(name_.c_str());  // while it is held: nobody else has it now
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace softcnc::hal
