// SPDX-License-Identifier: MIT
// A file read piece by piece, decompressed where Zstandard has compressed it.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "hal/files/zip_file.hpp"
#include "motion/core/result.hpp"

struct ZSTD_DCtx_s;

namespace softcnc::hal {

class CompressedFile {
 public:
  /// Opens a file, or standard input if its name is "-". Errors: `unreadable`.
  static Result<CompressedFile> open(const std::string& file, Code unreadable, Code damaged);

  /// Reads an entry of a zip, which must outlive it; `name` is that of messages.
  CompressedFile(ZipEntry entry, std::string name, Code unreadable, Code damaged);

  /// Returns the next piece, empty at the end; valid until the next call. Errors: `unreadable`, or
  /// `damaged` where it is compressed and not whole, or larger than may_decompress() allows.
  Result<std::string_view> next();

 private:
  CompressedFile(std::string file, std::FILE* stream, Code unreadable, Code damaged);
  Result<std::string_view> failure(Code code, const std::string& why) const;
  Result<std::string_view> read();
  Result<std::size_t> read_bytes();
  Result<std::string_view> decompress();

  std::string file_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream_;
  std::optional<ZipEntry> entry_;  // instead of a stream
  Code unreadable_, damaged_;
  std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> decompressor_;
  std::string bytes_, decompressed_;
  std::size_t begin_ = 0, end_ = 0;  // of what is read and not yet decompressed
  std::uint64_t compressed_bytes_ = 0, decompressed_bytes_ = 0;
  bool begun_ = false, compressed_ = false, within_frame_ = false;
};

}  // namespace softcnc::hal
