// SPDX-License-Identifier: MIT
// How much a compressed file may unpack to: a few bytes can stand for hours of reading.
#pragma once

#include <cstdint>

namespace softcnc::hal {

/// Any file may unpack to so many bytes: they are read in a second.
inline constexpr std::uint64_t kFreelyUnpacked = std::uint64_t{1} << 26U;

/// Beyond them, a byte of a file stands for at most so many. Deflate makes 1032 of one; a trace,
/// whose times go up from row to row, less than a hundred.
inline constexpr std::uint64_t kMostUnpackedPerByte = 2000;

/// Whether so many bytes may come out of so many packed ones.
constexpr bool may_unpack(std::uint64_t unpacked, std::uint64_t packed) noexcept {
  return unpacked <= kFreelyUnpacked ||
         (unpacked - kFreelyUnpacked) / kMostUnpackedPerByte <= packed;
}

}  // namespace softcnc::hal
