// SPDX-License-Identifier: MIT
// How large the contents of a compressed file may be: a few bytes can stand for hours of reading.
#pragma once

#include <cstdint>

namespace softcnc::hal {

/// The number of bytes that any file may decompress to: they are read in a second.
inline constexpr std::uint64_t kFreelyDecompressed = std::uint64_t{1} << 26U;

/// The largest number of bytes, beyond those, that a byte of a file may stand for. Deflate makes
/// 1032 of one; a trace, whose times go up from row to row, less than a hundred.
inline constexpr std::uint64_t kMostDecompressedPerByte = 2000;

/// Returns whether so many compressed bytes may decompress to this size.
constexpr bool may_decompress(std::uint64_t decompressed, std::uint64_t compressed) noexcept {
  return decompressed <= kFreelyDecompressed ||
         (decompressed - kFreelyDecompressed) / kMostDecompressedPerByte <= compressed;
}

}  // namespace softcnc::hal
