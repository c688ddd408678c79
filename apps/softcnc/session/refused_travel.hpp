// SPDX-License-Identifier: MIT
// Moves that are not planned, against the travel of the axes.
#pragma once

#include "ipr/interpreter/interpreter.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::app {

/// Reports where a move that is not planned would leave the travel, as that of a line which
/// is refused for something else.
class RefusedTravel final : public ipr::RefusedMoves {
 public:
  RefusedTravel(const Machine& machine, Diagnostics& diagnostics)
      : machine_(machine), diagnostics_(diagnostics) {}
  void see(const Move& move, SourcePos source) override;

 private:
  const Machine& machine_;
  Diagnostics& diagnostics_;
};

}  // namespace softcnc::app
