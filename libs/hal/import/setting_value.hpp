// SPDX-License-Identifier: MIT
// Numbers of settings after a change of units.
#pragma once

#include <array>
#include <charconv>

namespace softcnc::hal {

/// Returns a number without the rounding errors that a change of units leaves in its last digits:
/// the nearest of those with 15 significant digits, which -1.5 inch make -38.1 mm.
inline double without_rounding(double value) noexcept {
  constexpr int kDigits = 15;
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::general, kDigits);
  double read = value;
  std::from_chars(text.data(), end.ptr, read);
  return read;
}

}  // namespace softcnc::hal
