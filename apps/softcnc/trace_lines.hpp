// SPDX-License-Identifier: MIT
// The lines of a compressed trace, one at a time.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "hal/zip_file.hpp"

struct ZSTD_DCtx_s;

namespace softcnc::app {

class TraceLines {
 public:
  explicit TraceLines(hal::ZipEntry entry);

  /// The next line that is no comment, valid until the next call; nothing at the end or after an
  /// error.
  std::optional<std::string_view> next();

  /// Errors: SC6021.
  const Status& status() const noexcept { return status_; }

 private:
  bool fill();

  hal::ZipEntry entry_;
  std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> stream_;
  std::string packed_, text_;
  std::size_t packed_begin_ = 0, packed_end_ = 0, begin_ = 0;
  Status status_;
};

}  // namespace softcnc::app
