// SPDX-License-Identifier: MIT
// A set of the letters A to Z.
#pragma once

#include <string_view>

#include "ipr/text/small_set.hpp"

namespace softcnc::ipr {

/// Expects upper-case letters everywhere.
class Letters : public SmallSet<Letters, char, 'A'> {
 public:
  constexpr Letters() = default;
  constexpr Letters(std::string_view letters) noexcept {
    for (const char letter : letters) add(letter);
  }
  constexpr Letters(const char* letters) noexcept : Letters(std::string_view(letters)) {}
};

inline constexpr Letters kAxisWords{"XYZ"};
inline constexpr Letters kAllLetters = Letters::up_to('Z');

}  // namespace softcnc::ipr
