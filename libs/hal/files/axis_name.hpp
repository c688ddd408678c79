// SPDX-License-Identifier: MIT
// Axes as machine files and columns spell them: in lower case.
#pragma once

#include <string>

#include "motion/core/axes.hpp"

namespace softcnc::hal {

/// Returns "x", "y" or "z". Requires 0 <= axis < kAxes.
inline std::string axis_name(int axis) {
  const char letter = kAxisLetters[static_cast<std::size_t>(axis)];
  return {static_cast<char>(letter - 'A' + 'a')};
}

}  // namespace softcnc::hal
