// SPDX-License-Identifier: MIT
// The blocks of a program one after the other, without motion.
#pragma once

#include "ipr/interpreter/interpreter.hpp"

namespace softcnc::runtime {

/// Hands every block to take(block) until it returns false. Where the program's pipe has nothing
/// more yet, wait() returns when it has; false: no more blocks are wanted.
template <typename Take, typename Wait>
void each_block(ipr::Interpreter& interpreter, Take&& take, Wait&& wait) {
  for (;;) {
    if (const auto block = interpreter.next()) {
      if (!take(*block)) return;
    } else if (!interpreter.waiting() || !wait()) {
      return;
    }
  }
}

}  // namespace softcnc::runtime
