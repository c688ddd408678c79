// SPDX-License-Identifier: MIT
// The names in a state file: work systems, and numbers as names.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "motion/model/machine_state.hpp"

namespace softcnc::hal {

/// The names of the work systems that have codes of their own, in order.
inline constexpr std::array<std::string_view, kWorkSystems> kWorkNames{
    "G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};

inline constexpr std::array<std::string_view, 2> kFurtherHomes{"g30_p3", "g30_p4"};
inline constexpr std::array<std::string_view, 2> kNoYes{"no", "yes"};

/// Returns the index of a word among others; nothing if it is none of them.
template <typename Words>
std::optional<int> index_in(const Words& words, std::string_view word) {
  const auto found = std::find(words.begin(), words.end(), word);
  return found == words.end() ? std::nullopt
                              : std::optional(static_cast<int>(found - words.begin()));
}

/// Returns the number from 1 that a word is; nothing if it is none.
std::optional<int> number_of(std::string_view word);

/// Returns what follows the prefix in the text; an empty text if it does not begin with that.
std::string_view without(std::string_view text, std::string_view prefix);

/// Returns the index of the work system of a name, "G55" or "G54.1 P3"; nothing if there is none.
std::optional<int> system_index(std::string_view name);
/// Returns the name of the work system of an index.
std::string system_name(int index);

}  // namespace softcnc::hal
