// SPDX-License-Identifier: MIT
// A set of the letters A to Z, in one machine word.
#pragma once

#include <cstdint>
#include <string_view>

namespace softcnc::ipr {

/// Expects upper-case letters everywhere.
class Letters {
 public:
  constexpr Letters() = default;
  constexpr Letters(std::string_view letters) noexcept {
    for (const char letter : letters) add(letter);
  }
  constexpr Letters(const char* letters) noexcept : Letters(std::string_view(letters)) {}

  constexpr void add(char letter) noexcept { bits_ |= bit(letter); }
  constexpr void remove(char letter) noexcept { bits_ &= ~bit(letter); }

  constexpr bool has(char letter) const noexcept { return (bits_ & bit(letter)) != 0; }
  constexpr bool has_any(Letters other) const noexcept { return (bits_ & other.bits_) != 0; }
  constexpr bool empty() const noexcept { return bits_ == 0; }

  constexpr Letters& operator|=(Letters other) noexcept {
    bits_ |= other.bits_;
    return *this;
  }
  friend constexpr bool operator==(Letters, Letters) = default;
  constexpr Letters without(Letters other) const noexcept {
    Letters rest;
    rest.bits_ = bits_ & ~other.bits_;
    return rest;
  }

 private:
  static constexpr std::uint32_t bit(char letter) noexcept { return 1U << (letter - 'A'); }

  std::uint32_t bits_ = 0;
};

inline constexpr Letters kAxisWords{"XYZ"};
inline constexpr Letters kAllLetters{"ABCDEFGHIJKLMNOPQRSTUVWXYZ"};

}  // namespace softcnc::ipr
