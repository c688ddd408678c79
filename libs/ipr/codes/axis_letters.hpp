// SPDX-License-Identifier: MIT
// The letters of coordinates and of distances along the axes.
#pragma once

#include <cstddef>
#include <string_view>

#include "ipr/text/letter_set.hpp"
#include "motion/core/axes.hpp"
#include "motion/geometry/arc.hpp"

namespace softcnc::ipr {

/// The letters of coordinate `axis`, and of the distance from the start beside it.
inline constexpr std::string_view kOffsetLetters = "IJK";
constexpr char axis_letter(int axis) noexcept {
  return kAxisLetters[static_cast<std::size_t>(axis)];
}
constexpr char offset_letter(int axis) noexcept {
  return kOffsetLetters[static_cast<std::size_t>(axis)];
}

/// The two coordinates along a plane.
constexpr LetterSet plane_letters(const PlaneAxes& axes) noexcept {
  LetterSet letters;
  letters.add(axis_letter(axes.first));
  letters.add(axis_letter(axes.second));
  return letters;
}

}  // namespace softcnc::ipr
