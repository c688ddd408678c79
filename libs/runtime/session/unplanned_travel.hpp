// SPDX-License-Identifier: MIT
// Moves that are not planned, against the travel of the axes.
#pragma once

#include "motion/core/diagnostic.hpp"
#include "motion/model/block.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::runtime {

/// Reports where a move that is not planned would leave the travel.
class UnplannedTravel {
 public:
  UnplannedTravel(const Machine& machine, Diagnostics& diagnostics)
      : machine_(machine), diagnostics_(diagnostics) {}
  void check(const Move& move, SourcePos source);

 private:
  const Machine& machine_;
  Diagnostics& diagnostics_;
};

}  // namespace softcnc::runtime
