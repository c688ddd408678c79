// SPDX-License-Identifier: MIT
// Numbers as text: the shortest form that reads back exactly.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace softcnc::hal {

/// No number takes more characters than this.
inline constexpr int kNumberLength = 25;

/// The three digits of every number below 1000, each in four bytes.
inline constexpr auto kTriples = [] {
  std::array<char, 4000> triples{};
  for (std::size_t i = 0; i < 1000; ++i) {
    triples[4 * i] = static_cast<char>('0' + i / 100);
    triples[4 * i + 1] = static_cast<char>('0' + i / 10 % 10);
    triples[4 * i + 2] = static_cast<char>('0' + i % 10);
  }
  return triples;
}();

/// Writes a number below 1000 with all three digits; returns the end. Realtime.
inline char* write_triple(char* out, std::uint32_t number) noexcept {
  std::memcpy(out, &kTriples[4 * std::size_t{number}], 3);
  return out + 3;
}

/// Writes a whole number; returns the end. Realtime.
inline char* write_whole(char* out, std::uint32_t number) noexcept {
  if (number >= 1000) return write_triple(write_whole(out, number / 1000), number % 1000);
  const std::size_t zeros = number < 10 ? 2 : number < 100 ? 1 : 0;
  std::memcpy(out, &kTriples[4 * std::size_t{number} + zeros], 3);
  return out + 3 - zeros;
}

/// Writes a size of at most six decimals, as most are, without searching for its digits: as many
/// decimals as doubles can distinguish are its shortest form. nullptr: it is no such size.
/// Realtime.
inline char* write_short_decimal(char* out, double size) noexcept {
  constexpr double kLow = 1e-3, kHigh = 1e5;  // beyond, an exponent may be shorter
  constexpr std::uint32_t kParts = 1000000;
  if (!(size >= kLow && size < kHigh)) return nullptr;
  const auto parts = static_cast<std::uint64_t>(size * double{kParts} + 0.5);
  if (static_cast<double>(parts) / double{kParts} != size) return nullptr;
  out = write_whole(out, static_cast<std::uint32_t>(parts / kParts));
  const auto rest = static_cast<std::uint32_t>(parts % kParts);
  if (rest == 0) return out;
  *out++ = '.';
  for (out = write_triple(write_triple(out, rest / 1000), rest % 1000); out[-1] == '0';) --out;
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

/// The shortest number that to_internal() turns into exactly `internal`. Scaling rounds, so it lies
/// within a few units in the last place of to_file(internal); if none is exact, it is that.
inline std::string scaled_text(double internal, double (*to_internal)(double),
                               double (*to_file)(double)) {
  constexpr int kNeighbours = 4;
  const double infinity = std::numeric_limits<double>::infinity();
  double candidate = to_file(internal);
  std::string shortest = number_text(candidate);
  bool exact = to_internal(candidate) == internal;
  for (int i = 0; i < kNeighbours; ++i) candidate = std::nextafter(candidate, -infinity);
  for (int i = -kNeighbours; i <= kNeighbours; ++i) {
    const std::string text = number_text(candidate);
    if (to_internal(candidate) == internal && (!exact || text.size() < shortest.size())) {
      shortest = text;
      exact = true;
    }
    candidate = std::nextafter(candidate, infinity);
  }
  return shortest;
}

}  // namespace softcnc::hal
