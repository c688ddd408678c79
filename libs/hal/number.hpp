// SPDX-License-Identifier: MIT
// Numbers as text: the shortest form that reads back exactly.
#pragma once

#include <charconv>
#include <cmath>
#include <limits>
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

/// The shortest number that to_house() turns into exactly `house`. Scaling rounds, so it lies
/// within a few units in the last place of to_file(house); if none is exact, it is that.
inline std::string scaled_text(double house, double (*to_house)(double),
                               double (*to_file)(double)) {
  constexpr int kNeighbours = 4;
  const double infinity = std::numeric_limits<double>::infinity();
  double candidate = to_file(house);
  std::string shortest = number_text(candidate);
  bool exact = to_house(candidate) == house;
  for (int i = 0; i < kNeighbours; ++i) candidate = std::nextafter(candidate, -infinity);
  for (int i = -kNeighbours; i <= kNeighbours; ++i) {
    const std::string text = number_text(candidate);
    if (to_house(candidate) == house && (!exact || text.size() < shortest.size())) {
      shortest = text;
      exact = true;
    }
    candidate = std::nextafter(candidate, infinity);
  }
  return shortest;
}

}  // namespace softcnc::hal
