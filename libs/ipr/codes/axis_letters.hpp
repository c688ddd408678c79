// SPDX-License-Identifier: MIT
// The letters of coordinates and of distances along the axes.
#pragma once

#include <cstddef>
#include <string_view>

#include "ipr/text/letter_set.hpp"
#include "motion/core/axes.hpp"
#include "motion/geometry/arc.hpp"

namespace softcnc::ipr {

/// The letters of the distances from the start, by axis. axis_letter() returns the letter of
/// coordinate `axis` (0 is X), and offset_letter() that of the distance along it.
inline constexpr std::string_view kOffsetLetters = "IJK";
constexpr char axis_letter(int axis) noexcept {
  return kAxisLetters[static_cast<std::size_t>(axis)];
}
constexpr char offset_letter(int axis) noexcept {
  return kOffsetLetters[static_cast<std::size_t>(axis)];
}

/// Returns the letters of the two coordinates along a plane.
constexpr LetterSet plane_letters(const PlaneAxes& axes) noexcept {
  LetterSet letters;
  letters.add(axis_letter(axes.first));
  letters.add(axis_letter(axes.second));
  return letters;
}

}  // namespace softcnc::ipr
