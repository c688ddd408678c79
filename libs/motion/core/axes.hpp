// SPDX-License-Identifier: MIT
// The axes of the machine: how many, their letters, and a vector over them.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string_view>

namespace softcnc {

inline constexpr int kAxes = 3;
inline constexpr std::string_view kAxisLetters = "XYZ";

/// One number per axis (mm, mm/s, mm/s^2, ...), in the order of kAxisLetters.
using AxisVector = Eigen::Matrix<double, kAxes, 1>;

/// Index of an axis letter in upper or lower case; -1 if it names no axis.
constexpr int axis_index(char letter) noexcept {
  const char upper =
      letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  const std::size_t found = kAxisLetters.find(upper);
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

}  // namespace softcnc
