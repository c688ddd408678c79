// SPDX-License-Identifier: MIT
// Numbers as text: the shortest form that reads back exactly.
#pragma once

#include <charconv>
#include <string>

namespace softcnc::hal {

/// No number takes more characters than this.
inline constexpr int kNumberLength = 25;

/// Writes `value` at `out`, where kNumberLength characters are free; returns the end. -0.0 is
/// written as 0. Realtime.
inline char* write_number(char* out, double value) noexcept {
  return std::to_chars(out, out + kNumberLength, value + 0.0).ptr;
}

inline std::string number_text(double value) {
  char text[kNumberLength];
  return {text, write_number(text, value)};
}

}  // namespace softcnc::hal
