// SPDX-License-Identifier: MIT
// Programs that move for longer than a run may last.
#pragma once

#include <optional>

#include "motion/model/block.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::runtime {

/// The time that a block takes at least, s: at its feed from end to end, or of a rapid with every
/// axis at its velocity limit.
double least_time(const Block& block, const Machine& machine, double feed_override);

class MotionLimit {
 public:
  /// The machine must outlive it. `feed_override` is the largest that may be in force.
  MotionLimit(const Machine& machine, double feed_override) noexcept
      : machine_(machine), feed_override_(feed_override) {}

  /// Takes the next block of the program; the motion is planned up to `planned`, s. SC4050 if the
  /// block ends too late however fast it and those before it are.
  std::optional<Diagnostic> check(const Block& block, double planned);
  /// Returns SC4050 for a block that is planned to end at `end`, s, if that is too late.
  std::optional<Diagnostic> check_end(const Block& block, double end) const;

 private:
  const Machine& machine_;
  double feed_override_;
  double least_ = 0;  // s: of all blocks taken
};

}  // namespace softcnc::runtime
