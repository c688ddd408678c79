// SPDX-License-Identifier: MIT
// Places as a person types them: X10 Y-2.5.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "motion/core/axes.hpp"

namespace softcnc::app {

/// The numbers of words such as X10.5, by axis; `wrong` is the first word that is none.
struct AxisWords {
  std::array<std::optional<double>, kAxes> mm;
  std::string wrong;

  std::size_t named() const;
};

AxisWords axis_words(std::span<const std::string> words);

/// Returns the words between blanks.
std::vector<std::string> words_of(std::string_view text);

}  // namespace softcnc::app
