// SPDX-License-Identifier: MIT
// What a program has switched on at the machine beside its axes.
#pragma once

#include <cstdint>

namespace softcnc {

struct Block;

struct Outputs {
  double spindle_rpm = 0;  // positive: M03, clockwise
  bool mist = false, flood = false;
  std::uint64_t digital = 0;  // outputs that are on: bit n of number n, up to 63

  bool is_on(int number) const noexcept { return (digital >> number & 1U) != 0; }

  /// The machine has passed a block.
  void pass(const Block& block) noexcept;

  friend bool operator==(const Outputs&, const Outputs&) = default;
};

}  // namespace softcnc
