// SPDX-License-Identifier: MIT
// Reference pulses (paper 003): a path as a staircase of moves by one basic length unit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "motion/core/axes.hpp"

namespace softcnc {

/// How the next move of a staircase is found.
///   sam    Stairs Approximation Method: one axis at a time, always towards the path
///   m_sam  the same with the diagonal beside the axis along which the path runs
///   dsm    Direct Search Method: the nearest of axis, diagonal and other axis
///   m_dsm  the nearer of two: the diagonal, and the axis along which the path runs
///   dda    Digital Differential Analyzer: a register for each axis that overflows into pulses
enum class PulseMethod : std::uint8_t { sam, m_sam, dsm, m_dsm, dda };
inline constexpr std::array<std::string_view, 5> kPulseMethodNames{"sam", "m-sam", "dsm", "m-dsm",
                                                                   "dda"};
constexpr std::string_view name(PulseMethod method) noexcept {
  return kPulseMethodNames[static_cast<std::size_t>(method)];
}

/// A grid point in whole BLU of each axis.
using GridPoint = std::array<std::int64_t, kAxes>;

/// One clock of a staircase: which axes move by one BLU, and in which direction. A clock in which
/// none moves is no pulse.
class Step {
 public:
  constexpr Step() = default;
  /// `direction` > 0, < 0, or 0 for no move.
  constexpr Step(int axis, std::int64_t direction) noexcept
      : bits_(static_cast<std::uint8_t>(
            direction == 0 ? 0U : (direction > 0 ? kMoves : kMoves | kBack) << unsigned(axis))) {}

  /// -1, 0 or 1.
  constexpr int operator[](int axis) const noexcept {
    const unsigned bits = bits_ >> unsigned(axis);
    return (bits & kMoves) == 0 ? 0 : (bits & kBack) == 0 ? 1 : -1;
  }
  constexpr bool is_pulse() const noexcept { return bits_ != 0; }
  constexpr int axes() const noexcept {
    return (bits_ & 1U) + ((bits_ >> 1U) & 1U) + ((bits_ >> 2U) & 1U);
  }

  /// Returns this step together with the other one, or alone, without a branch.
  constexpr Step with_if(bool joined, Step other) const noexcept {
    Step both = *this;
    both.bits_ = static_cast<std::uint8_t>(bits_ | (other.bits_ & -static_cast<int>(joined)));
    return both;
  }
  constexpr Step operator|(Step other) const noexcept { return with_if(true, other); }
  constexpr bool operator==(const Step&) const noexcept = default;

 private:
  static constexpr unsigned kMoves = 0x01, kBack = 0x10;
  std::uint8_t bits_ = 0;
};
static_assert(kAxes <= 4 && sizeof(Step) == 1);

constexpr void advance(GridPoint& point, Step step) noexcept {
  for (int axis = 0; axis < kAxes; ++axis) point[static_cast<std::size_t>(axis)] += step[axis];
}

}  // namespace softcnc
