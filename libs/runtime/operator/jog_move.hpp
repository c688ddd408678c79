// SPDX-License-Identifier: MIT
// Moves by hand: how far, within the travel.
#pragma once

#include <limits>

#include "motion/core/result.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::runtime {

/// A motion by hand. A continuous one goes in the direction of `distance` to the end of the travel,
/// unless it is cancelled.
struct Jog {
  AxisVector distance = AxisVector::Zero();  // mm, from where the jog before it ends
  double feed = 0;                           // mm/s along the path; more than the axes have is cut
  bool continuous = false;
};

/// Returns where a jog from `from` ends, mm, machine coordinates. A place beyond the travel is
/// refused as a whole, unless the axis comes back from beyond it. Errors: SC4001 (beyond the
/// travel), SC5080 (no distance, or no feed).
Result<AxisVector> jog_end(const Jog& jog, const AxisVector& from, const Machine& machine);

/// Returns the machine without ends of travel: of one whose position is not known.
Machine without_travel(Machine machine);

}  // namespace softcnc::runtime
