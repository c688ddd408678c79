// SPDX-License-Identifier: MIT
// A list that takes little memory however long it is: the most of it stands in a file.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "motion/core/result.hpp"

namespace softcnc {

/// A temporary file without a name that grows, and is then read like memory.
class OverflowFile {
 public:
  OverflowFile() = default;
  OverflowFile(const OverflowFile&) = delete;
  OverflowFile& operator=(const OverflowFile&) = delete;
  OverflowFile(OverflowFile&& other) noexcept { *this = std::move(other); }
  OverflowFile& operator=(OverflowFile&& other) noexcept;
  ~OverflowFile();

  /// Errors: SC6003.
  Status add(std::span<const std::byte> bytes);
  /// Over what has been added at `place`. Errors: SC6003.
  Status put(std::size_t place, std::span<const std::byte> bytes);
  /// Nothing may be added after it. Errors: SC6003.
  Status map();

  bool is_open() const noexcept { return descriptor_ >= 0; }
  int descriptor() const noexcept { return descriptor_; }
  std::span<const std::byte> bytes() const noexcept { return {data_, mapped_}; }
  /// Gives back what has been read of it: it can be read again.
  void release() const noexcept;

 private:
  int descriptor_ = -1;
  std::size_t size_ = 0, mapped_ = 0;
  const std::byte* data_ = nullptr;
};

/// Grows, is finished, and is then read.
template <typename T>
class DiskBackedVector {
  static_assert(std::is_trivially_destructible_v<T> && std::is_standard_layout_v<T>,
                "bytes in a file own nothing");

 public:
  /// `most`: values that are kept in memory.
  explicit DiskBackedVector(std::size_t most = (std::size_t{1} << 24) / sizeof(T)) : most_(most) {}

  /// Errors: SC6003, on which nothing more is kept.
  void push_back(const T& value) {
    if (last_.size() >= most_) overflow();
    last_.push_back(value);
  }
  std::size_t size() const noexcept { return stored_ + last_.size(); }

  /// Call once; from then on values() are there. Errors: SC6003, of this or an earlier call.
  Status finish() {
    if (stored_ == 0) return failure_;
    overflow();
    if (failure_) failure_ = file_.map();
    return failure_;
  }

  /// Whether all is kept.
  const Status& kept() const noexcept { return failure_; }

  std::span<const T> values() const noexcept {
    if (stored_ == 0) return last_;
    return {reinterpret_cast<const T*>(file_.bytes().data()), file_.bytes().size() / sizeof(T)};
  }
  void release() const noexcept { file_.release(); }
  std::size_t memory() const noexcept { return last_.capacity() * sizeof(T); }

 private:
  void overflow() {
    if (failure_) failure_ = file_.add(std::as_bytes(std::span<const T>(last_)));
    stored_ += last_.size();
    last_.clear();
  }

  std::size_t most_, stored_ = 0;
  std::vector<T> last_;
  OverflowFile file_;
  Status failure_;
};

}  // namespace softcnc
