// SPDX-License-Identifier: MIT
// Files without a name: they are gone when their process is, however that ends.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include "hal/files/output_file.hpp"
#include "motion/core/result.hpp"

namespace softcnc::hal {

class TemporaryFile {
 public:
  /// Makes an empty one in the folder for temporary files. Errors: SC6003.
  static Result<TemporaryFile> make();
  TemporaryFile(TemporaryFile&& other) noexcept
      : descriptor_(std::exchange(other.descriptor_, -1)) {}
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  int descriptor() const noexcept { return descriptor_; }

  /// Appends bytes. Errors: SC6003.
  Status add(std::string_view bytes);

  /// Passes its contents to take(), piece by piece from the beginning. Errors: SC6003, and those of
  /// take().
  Status for_each_piece(const std::function<Status(std::string_view)>& take) const;

  /// Writes all that is in it to `out` and finishes that. Errors: SC6003, and those of `out`.
  Status copy_to(ByteSink& out) const;

 private:
  explicit TemporaryFile(int descriptor) noexcept : descriptor_(descriptor) {}

  int descriptor_;
};

/// Writes bytes into a temporary file, which must outlive it. Errors: SC6003.
class TemporarySink final : public ByteSink {
 public:
  explicit TemporarySink(TemporaryFile& file) noexcept : file_(file) {}
  Status write(std::string_view bytes) override { return file_.add(bytes); }
  Status finish() override { return {}; }

 private:
  TemporaryFile& file_;
};

}  // namespace softcnc::hal
