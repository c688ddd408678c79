// SPDX-License-Identifier: MIT
// The text of a file as it is now, whatever becomes of the file later.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "motion/core/result.hpp"

namespace softcnc::ipr {

/// A copy without a name: a short one lies in memory, a longer one in the folder for temporary
/// files, where a file system that can shares its blocks with the original.
class Snapshot {
 public:
  static constexpr std::int64_t kLongestInMemory = std::int64_t{1} << 20;  // bytes

  /// Copies what a regular file holds from `begin` on, in bytes. What is appended during the copy
  /// is not part of it. Errors: SC6002, SC6003.
  static Result<Snapshot> of(int file, std::int64_t begin);
  /// Keeps a text. Errors: SC6003.
  static Result<Snapshot> of(std::string_view text);

  Snapshot(Snapshot&& other) noexcept : descriptor_(other.release()) {}
  Snapshot& operator=(Snapshot&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    return *this;
  }
  ~Snapshot();

  int descriptor() const noexcept { return descriptor_; }
  /// Returns the descriptor, which the caller then has to close.
  int release() noexcept { return std::exchange(descriptor_, -1); }
  /// Returns a name under which this process can open the snapshot as long as it lives.
  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  explicit Snapshot(int descriptor) noexcept : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace softcnc::ipr
