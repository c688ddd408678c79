// SPDX-License-Identifier: MIT
// Numbers as text: the shortest form that reads back exactly.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace softcnc::hal {

/// No number takes more characters than this.
inline constexpr int kNumberLength = 25;

/// Writes a size of at most six decimals, as most are, without searching for its digits: as many
/// decimals as doubles can tell apart are its shortest form. nullptr: it is no such size. Realtime.
inline char* write_short_decimal(char* out, double size) noexcept {
  constexpr double kLow = 1e-3, kHigh = 1e5;  // beyond, an exponent may be shorter
  constexpr std::uint64_t kParts = 1000000;
  if (!(size >= kLow && size < kHigh)) return nullptr;
  const auto parts = static_cast<std::uint64_t>(size * double{kParts} + 0.5);
  if (static_cast<double>(parts) / double{kParts} != size) return nullptr;
  out = std::to_chars(out, out + kNumberLength, parts / kParts).ptr;
  auto rest = static_cast<std::uint32_t>(parts % kParts);
  if (rest == 0) return out;
  out[0] = '.';
  for (int i = 6; i > 0; --i, rest /= 10) out[i] = static_cast<char>('0' + rest % 10);
  for (out += 7; out[-1] == '0';) --out;
  return out;
}

/// Writes `value` at `out`, where kNumberLength characters are free; returns the end. -0.0 is
/// written as 0. Realtime.
inline char* write_number(char* out, double value) noexcept {
  *out = '-';
  char* const digits = value < 0 ? out + 1 : out;
  if (char* const end = write_short_decimal(digits, std::abs(value))) return end;
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
