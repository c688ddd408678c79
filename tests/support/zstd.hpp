// SPDX-License-Identifier: MIT
// Texts packed by Zstandard, and unpacked.
#pragma once

#include <zstd.h>

#include <catch2/catch.hpp>
#include <string>

namespace softcnc::test {

/// Of at most 32 MiB.
inline std::string unpacked(const std::string& packed) {
  std::string text(std::size_t{1} << 25U, '\0');
  const std::size_t size = ZSTD_decompress(text.data(), text.size(), packed.data(), packed.size());
  REQUIRE(!ZSTD_isError(size));
  text.resize(size);
  return text;
}

inline std::string packed(const std::string& text) {
  std::string bytes(ZSTD_compressBound(text.size()), '\0');
  bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), text.data(), text.size(), 3));
  return bytes;
}

}  // namespace softcnc::test
