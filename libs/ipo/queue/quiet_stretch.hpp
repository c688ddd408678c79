// SPDX-License-Identifier: MIT
// Where the samples of a block need not be checked one by one: the motion and its path leave them
// far below every limit.
#pragma once

#include "ipo/queue/block_queue.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// A part of a block from some instant on.
struct QuietStretch {
  double until = 0;    // s of the block's profile: where it ends
  bool quiet = false;  // whether its samples use no more than a quarter of any limit
  double step =
      0;  // s: samples this far apart still draw the path to a tenth of the chord tolerance
};

/// Returns the longest part from `t` s of the profile on that is quiet throughout; or one that need
/// not be examined again, since it is not quiet, or too short. A block with a roughness target is
/// never quiet. The bounds come from the motion and the derivatives of the path at five instants of
/// every piece of the profile, and from how the direction jumps between pieces.
QuietStretch quiet_from(const TimedBlock& timed, double t, const Machine& machine);

}  // namespace softcnc::ipo
