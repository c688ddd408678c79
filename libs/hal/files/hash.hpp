// SPDX-License-Identifier: MIT
// The fingerprint by which traces and recordings name a program and a machine.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace softcnc::hal {

/// Returns the XXH3 hash of `bytes`, 128 bits, as 32 hexadecimal digits in canonical (big-endian)
/// order.
std::string hash_hex(std::string_view bytes);

/// The same for bytes that come piece by piece.
class Hasher {
 public:
  Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;
  ~Hasher();

  void add(std::string_view bytes);
  std::string hex() const;  // of what has been added so far

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace softcnc::hal
