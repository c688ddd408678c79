// SPDX-License-Identifier: MIT
#include "hal/files/compressed_file.hpp"

#include <zstd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "hal/files/decompression_limit.hpp"
#include "hal/files/file_piece.hpp"

namespace softcnc::hal {
namespace {

constexpr std::string_view kZstdMagic = "\x28\xB5\x2F\xFD";

int leave_open(std::FILE* /*stream*/) { return 0; }

}  // namespace

CompressedFile::CompressedFile(std::string file, std::FILE* stream, Code unreadable, Code damaged)
    : file_(std::move(file)),
      stream_(stream, stream == stdin ? leave_open : std::fclose),
      unreadable_(unreadable),
      damaged_(damaged),
      decompressor_(ZSTD_createDCtx(), ZSTD_freeDCtx),
      bytes_(kFilePiece, '\0') {}

CompressedFile::CompressedFile(ZipEntry entry, std::string name, Code unreadable, Code damaged)
    : CompressedFile(std::move(name), nullptr, unreadable, damaged) {
  entry_ = std::move(entry);
}

Result<CompressedFile> CompressedFile::open(const std::string& file, Code unreadable,
                                            Code damaged) {
  std::FILE* stream = file == "-" ? stdin : std::fopen(file.c_str(), "rbe");
  if (stream) return CompressedFile(file, stream, unreadable, damaged);
  return tl::make_unexpected(
      Diagnostic{.code = unreadable,
                 .message = std::string("cannot be read: ") + std::strerror(errno),
                 .file = file});
}

Result<std::string_view> CompressedFile::failure(Code code, const std::string& why) const {
  return tl::make_unexpected(Diagnostic{.code = code, .message = why, .file = file_});
}

Result<std::string_view> CompressedFile::next() {
  if (compressed_) return decompress();
  auto bytes = read();
  if (!bytes || std::exchange(begun_, true) || !bytes->starts_with(kZstdMagic)) return bytes;
  compressed_ = true;
  end_ = bytes->size();
  return decompress();
}

Result<std::string_view> CompressedFile::read() {
  const auto n = read_bytes();
  if (!n) return failure(unreadable_, n.error().message);
  compressed_bytes_ += *n;
  return std::string_view(bytes_).substr(0, *n);
}

Result<std::size_t> CompressedFile::read_bytes() {
  if (entry_) return entry_->read(bytes_.data(), bytes_.size());
  const std::size_t n = std::fread(bytes_.data(), 1, bytes_.size(), stream_.get());
  if (n > 0 || std::ferror(stream_.get()) == 0) return n;
  return tl::make_unexpected(Diagnostic{
      .code = unreadable_, .message = std::string("cannot be read: ") + std::strerror(errno)});
}

Result<std::string_view> CompressedFile::decompress() {
  decompressed_.resize(ZSTD_DStreamOutSize());
  for (;;) {
    ZSTD_inBuffer in{bytes_.data(), end_, begin_};
    ZSTD_outBuffer out{decompressed_.data(), decompressed_.size(), 0};
    const std::size_t left = ZSTD_decompressStream(decompressor_.get(), &out, &in);
    if (ZSTD_isError(left))
      return failure(damaged_, std::string("damaged: ") + ZSTD_getErrorName(left));
    if (in.pos > begin_ || out.pos > 0) within_frame_ = left > 0;
    begin_ = in.pos;
    decompressed_bytes_ += out.pos;
    if (!may_decompress(decompressed_bytes_, compressed_bytes_))
      return failure(damaged_, "unpacks to more than " + std::to_string(kMostDecompressedPerByte) +
                                   " times its size");
    if (out.pos > 0) return std::string_view(decompressed_).substr(0, out.pos);
    if (begin_ < end_) continue;
    const auto bytes = read();
    if (!bytes) return bytes;
    if (bytes->empty())
      return within_frame_ ? failure(damaged_, "not whole: it ends within its compressed part")
                           : bytes;
    begin_ = 0;
    end_ = bytes->size();
  }
}

}  // namespace softcnc::hal
