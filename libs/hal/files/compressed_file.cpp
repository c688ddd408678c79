// SPDX-License-Identifier: MIT
#include "hal/files/compressed_file.hpp"

#include <zstd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "hal/files/unpacking.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kPiece = 1U << 16U;  // bytes
constexpr std::string_view kPackedHead = "\x28\xB5\x2F\xFD";

int leave_open(std::FILE* /*stream*/) { return 0; }

}  // namespace

PackedFile::PackedFile(std::string file, std::FILE* stream, Code unreadable, Code damaged)
    : file_(std::move(file)),
      stream_(stream, stream == stdin ? leave_open : std::fclose),
      unreadable_(unreadable),
      damaged_(damaged),
      unpacker_(ZSTD_createDCtx(), ZSTD_freeDCtx),
      bytes_(kPiece, '\0') {}

Result<PackedFile> PackedFile::open(const std::string& file, Code unreadable, Code damaged) {
  std::FILE* stream = file == "-" ? stdin : std::fopen(file.c_str(), "rbe");
  if (stream) return PackedFile(file, stream, unreadable, damaged);
  return tl::make_unexpected(
      Diagnostic{unreadable, {}, std::string("cannot be read: ") + std::strerror(errno), file, {}});
}

Result<std::string_view> PackedFile::failure(Code code, const std::string& why) const {
  return tl::make_unexpected(Diagnostic{code, {}, why, file_, {}});
}

Result<std::string_view> PackedFile::next() {
  if (packed_) return unpack();
  auto bytes = read();
  if (!bytes || std::exchange(begun_, true) || !bytes->starts_with(kPackedHead)) return bytes;
  packed_ = true;
  end_ = bytes->size();
  return unpack();
}

Result<std::string_view> PackedFile::read() {
  const std::size_t n = std::fread(bytes_.data(), 1, bytes_.size(), stream_.get());
  if (n == 0 && std::ferror(stream_.get()))
    return failure(unreadable_, std::string("cannot be read: ") + std::strerror(errno));
  packed_bytes_ += n;
  return std::string_view(bytes_).substr(0, n);
}

Result<std::string_view> PackedFile::unpack() {
  unpacked_.resize(ZSTD_DStreamOutSize());
  for (;;) {
    ZSTD_inBuffer in{bytes_.data(), end_, begin_};
    ZSTD_outBuffer out{unpacked_.data(), unpacked_.size(), 0};
    const std::size_t left = ZSTD_decompressStream(unpacker_.get(), &out, &in);
    if (ZSTD_isError(left))
      return failure(damaged_, std::string("damaged: ") + ZSTD_getErrorName(left));
    if (in.pos > begin_ || out.pos > 0) within_frame_ = left > 0;
    begin_ = in.pos;
    unpacked_bytes_ += out.pos;
    if (!may_unpack(unpacked_bytes_, packed_bytes_))
      return failure(damaged_, "unpacks to more than " + std::to_string(kMostUnpackedPerByte) +
                                   " times its size");
    if (out.pos > 0) return std::string_view(unpacked_).substr(0, out.pos);
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
