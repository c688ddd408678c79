// SPDX-License-Identifier: MIT
// What has come through a pipe, kept in a file without a name, so that it can be read again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "motion/core/result.hpp"

namespace softcnc::ipr {

class Spool {
 public:
  Spool() = default;
  Spool(Spool&& other) noexcept;
  Spool& operator=(Spool&& other) noexcept;
  ~Spool();

  /// Appends `size` bytes. After a failure, which failure() returns, nothing more is kept.
  void add(const char* bytes, std::size_t size);
  std::uint64_t size() const noexcept { return size_; }
  /// Returns why not everything is kept: SC6032.
  const std::optional<Diagnostic>& failure() const noexcept { return failure_; }

  /// Reads at most `size` bytes from `offset` into `to` and returns how many; 0 at the end, and -1
  /// with errno on an error.
  std::ptrdiff_t read(std::uint64_t offset, char* to, std::size_t size) const;

 private:
  bool open();
  void fail(int error);

  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::optional<Diagnostic> failure_;
};

}  // namespace softcnc::ipr
