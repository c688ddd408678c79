// SPDX-License-Identifier: MIT
// What a program has switched on at the machine beside its axes.
#pragma once

#include <variant>

#include "motion/model/block.hpp"

namespace softcnc {

struct Outputs {
  double spindle_rpm = 0;  // positive: M03, clockwise
  bool mist = false, flood = false;

  /// The machine has passed a block.
  void pass(const Block& block) noexcept {
    constexpr int kMist = 7, kFlood = 8;
    const auto* action = std::get_if<Action>(&block.what);
    if (action == nullptr) return;
    if (action->kind == Action::Kind::end) *this = {};
    if (action->kind == Action::Kind::spindle) spindle_rpm = action->value;
    if (action->kind != Action::Kind::coolant) return;
    const int code = action->value != 0 ? static_cast<int>(action->value) : action->code;
    mist = code == kMist || (mist && code == kFlood);
    flood = code == kFlood || (flood && code == kMist);
  }

  friend bool operator==(const Outputs&, const Outputs&) = default;
};

}  // namespace softcnc
