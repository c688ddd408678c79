// SPDX-License-Identifier: MIT
// A set of the letters A to Z, and of @ and ^.
#pragma once

#include <string_view>

#include "ipr/text/small_set.hpp"

namespace softcnc::ipr {

/// A set of letters, which the characters from @ to _ are. Requires upper-case letters everywhere.
class LetterSet : public SmallSet<LetterSet, char, 'A'> {
 public:
  constexpr LetterSet() = default;
  constexpr LetterSet(std::string_view letters) noexcept {
    for (const char letter : letters) add(letter);
  }
  constexpr LetterSet(const char* letters) noexcept : LetterSet(std::string_view(letters)) {}
};

inline constexpr LetterSet kAxisWords{"XYZ"};
inline constexpr LetterSet kPolarWords{"@^"};
inline constexpr LetterSet kAllLetters = LetterSet::up_to('Z');

}  // namespace softcnc::ipr
