// SPDX-License-Identifier: MIT
// What methods of reference pulses require of the planning side, before and after the speeds are
// planned.
#pragma once

#include <optional>

#include "ipo/queue/block_queue.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Gives every move its staircase, so that the cycle only walks it. Does nothing for other methods.
///
/// Where clocks are equal parts of a move (has_equal_clocks), they come at the rate of its feed per
/// BLU, in whatever direction they lead: its speed along the path follows from their number. Under
/// the paper's clock a move also goes from rest to rest.
class PulseStage {
 public:
  /// `machine` must outlive the stage.
  explicit PulseStage(const Machine& machine);

  /// Changes a move into what the planner is to run. Returns SC7080 if the axes it moves have
  /// different BLU, which one clock cannot serve. The caller sets the position of the
  /// diagnostic.
  std::optional<Diagnostic> prepare(Block& block) const;

  /// Attaches the staircase. Planning side: it allocates.
  void attach(TimedBlock& timed);

 private:
  bool works() const noexcept { return is_by_pulses(machine_.control.interpolation); }
  std::optional<Diagnostic> check_blu(const Path& path) const;

  const Machine& machine_;
  AxisVector blu_;
  std::optional<GridPoint> at_;  // where the last staircase ends
};

}  // namespace softcnc::ipo
