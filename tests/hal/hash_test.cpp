// SPDX-License-Identifier: MIT
// Fingerprints: known values, and the same however the bytes arrive.
#include "hal/files/hash.hpp"

#include <catch2/catch.hpp>

namespace softcnc::hal {
namespace {

TEST_CASE("the fingerprint of nothing is that of the XXH3 specification", "[hal][hash]") {
  CHECK(hash_hex("") == "99aa06d3014798d86001c324468d497f");
  CHECK(Hasher().hex() == hash_hex(""));
}

TEST_CASE("a text has one fingerprint, whole or in pieces", "[hal][hash]") {
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "N" + std::to_string(i) + " G01 X1\n";
  for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{4096}}) {
    Hasher hasher;
    for (std::size_t at = 0; at < text.size(); at += piece)
      hasher.add(std::string_view(text).substr(at, piece));
    CHECK(hasher.hex() == hash_hex(text));
  }
  CHECK(hash_hex(text) != hash_hex(text + " "));
}

}  // namespace
}  // namespace softcnc::hal
