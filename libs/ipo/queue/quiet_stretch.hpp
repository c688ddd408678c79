// SPDX-License-Identifier: MIT
// Where the rows of a block need not be looked at one by one: the motion and its path leave them
// far below every limit.
#pragma once

#include "ipo/queue/block_queue.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// A stretch of a block from some instant on.
struct QuietStretch {
  double until = 0;    // s of the block's profile: where it ends
  bool quiet = false;  // whether its rows use no more than a quarter of any limit
  double step = 0;     // s: rows so far apart still draw the path to a tenth of the chord tolerance
};

/// The longest stretch from `t` s of the profile on that is quiet all along; or one that need not
/// be looked at again, since it is not, or too short. A block that asks for a roughness is never
/// quiet. Bounds come from the motion and the derivatives of the path at five instants of every
/// piece of the profile, and from how the direction jumps between pieces.
QuietStretch quiet_from(const TimedBlock& timed, double t, const Machine& machine);

}  // namespace softcnc::ipo
