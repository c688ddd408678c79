// SPDX-License-Identifier: MIT
// What methods of reference pulses ask of the planning side, before and behind the speeds.
#pragma once

#include <optional>

#include "ipo/queue/block_queue.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Gives every move its staircase, so that the cycle need only walk it. Does nothing for other
/// methods.
///
/// Under the paper's clock a move goes from rest to rest, and its clocks come at the rate of its
/// feed per BLU, whatever way they lead: its speed along the path is what follows from their
/// number.
class PulseStage {
 public:
  /// `machine` must outlive the stage.
  explicit PulseStage(const Machine& machine);

  /// Makes of a move what the planner is to run. SC7080: the axes it moves have BLU of their own,
  /// which the paper's clock does not know. The place of the diagnostic is left to the caller.
  std::optional<Diagnostic> prepare(Block& block) const;

  /// Planning side: the staircase allocates.
  void attach(TimedBlock& timed);

 private:
  bool works() const noexcept { return is_by_pulses(machine_.control.interpolation); }
  std::optional<Diagnostic> check_blu(const Path& path) const;

  const Machine& machine_;
  AxisVector blu_;
  std::optional<GridPoint> at_;  // where the last staircase ends
};

}  // namespace softcnc::ipo
