// SPDX-License-Identifier: MIT
#include "recording/trace_lines.hpp"

#include <zstd.h>

#include <utility>

#include "hal/files/decompression_limit.hpp"

namespace softcnc::app {

TraceLines::TraceLines(hal::ZipEntry entry)
    : entry_(std::move(entry)),
      stream_(ZSTD_createDCtx(), ZSTD_freeDCtx),
      compressed_(ZSTD_DStreamInSize(), '\0') {}

std::optional<std::string_view> TraceLines::next() {
  for (;;) {
    const std::size_t end = text_.find('\n', begin_);
    if (end == std::string::npos) {
      if (!fill()) return std::nullopt;
      continue;
    }
    const std::string_view line = std::string_view(text_).substr(begin_, end - begin_);
    begin_ = end + 1;
    if (!line.starts_with('#')) return line;
  }
}

/// Decompresses more after what has not been read yet. False at the end.
bool TraceLines::fill() {
  text_.erase(0, std::exchange(begin_, 0));
  if (compressed_begin_ == compressed_end_) {
    const auto n = entry_.read(compressed_.data(), compressed_.size());
    if (!n) status_ = tl::make_unexpected(n.error());
    if (!n || *n == 0) return false;
    compressed_begin_ = 0;
    compressed_end_ = *n;
  }
  const std::size_t kept = text_.size();
  text_.resize(kept + ZSTD_DStreamOutSize());
  ZSTD_inBuffer in{compressed_.data(), compressed_end_, compressed_begin_};
  ZSTD_outBuffer out{text_.data() + kept, text_.size() - kept, 0};
  const std::size_t result = ZSTD_decompressStream(stream_.get(), &out, &in);
  compressed_begin_ = in.pos;
  text_.resize(kept + out.pos);
  decompressed_bytes_ += out.pos;
  if (ZSTD_isError(result) != 0)
    return fail(Code::SC6021, std::string("its trace is damaged: ") + ZSTD_getErrorName(result));
  if (!hal::may_decompress(decompressed_bytes_, entry_.file_size()))
    return fail(Code::SC6024, "its trace unpacks to more than " +
                                  std::to_string(hal::kMostDecompressedPerByte) +
                                  " times its size");
  if (kept > kLongestRow)
    return fail(Code::SC6021, "its trace is damaged: a row longer than " +
                                  std::to_string(kLongestRow) + " bytes");
  return true;
}

/// False.
bool TraceLines::fail(Code code, std::string why) {
  status_ = tl::make_unexpected(Diagnostic{.code = code, .message = std::move(why)});
  return false;
}

}  // namespace softcnc::app
