// SPDX-License-Identifier: MIT
// What a program has switched on at the machine beside its axes.
#pragma once

#include <cstdint>

namespace softcnc {

struct Block;

struct Outputs {
  double spindle_rpm = 0;  // positive: M03, clockwise
  bool mist = false, flood = false;
  std::uint32_t pins = 0;  // of digital outputs on a parallel port that are on: bit n of pin n

  /// The machine has passed a block.
  void pass(const Block& block) noexcept;

  friend bool operator==(const Outputs&, const Outputs&) = default;
};

}  // namespace softcnc
