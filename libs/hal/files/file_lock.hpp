// SPDX-License-Identifier: MIT
// A file that one process at a time reads and writes back.
#pragma once

#include <string>
#include <utility>

#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Held by a lock (flock) on a file beside it, `.NAME.softcnc-lock`, since a file that is replaced
/// carries no lock over. One that a killed process has left is taken over.
class FileLock {
 public:
  /// Locks a file; does nothing if it is not a regular file. Errors: SC6017 (another process has
  /// it; it is named), SC6011 (there can be no file beside it).
  static Result<FileLock> take(const std::string& file);

  FileLock(FileLock&& other) noexcept
      : name_(std::exchange(other.name_, {})), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

 private:
  explicit FileLock(int descriptor) noexcept : descriptor_(descriptor) {}

  std::string name_;  // while it is held
  int descriptor_;
};

}  // namespace softcnc::hal
