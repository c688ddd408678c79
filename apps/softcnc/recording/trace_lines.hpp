// SPDX-License-Identifier: MIT
// The lines of a compressed trace, one at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/zip_file.hpp"

struct ZSTD_DCtx_s;

namespace softcnc::app {

/// No row of a trace is longer, in bytes.
inline constexpr std::size_t kLongestRow = std::size_t{1} << 16U;

class TraceLines {
 public:
  explicit TraceLines(hal::ZipEntry entry);

  /// The next line that is no comment, valid until the next call; nothing at the end or after an
  /// error.
  std::optional<std::string_view> next();

  /// Errors: SC6021 (damaged, or a line longer than kLongestRow), SC6024 (more comes out of it than
  /// hal::may_decompress() allows).
  const Status& status() const noexcept { return status_; }

 private:
  bool fill();
  bool fail(Code code, std::string why);

  hal::ZipEntry entry_;
  std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> stream_;
  std::string compressed_, text_;
  std::uint64_t decompressed_bytes_ = 0;
  std::size_t compressed_begin_ = 0, compressed_end_ = 0, begin_ = 0;
  Status status_;
};

}  // namespace softcnc::app
