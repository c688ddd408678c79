// SPDX-License-Identifier: MIT
// Blocks in, timed blocks out for methods that ignore the limits of the axes: every move at its
// feed from end to end.
#pragma once

#include <deque>
#include <optional>

#include "ipo/planner/feed_control.hpp"
#include "ipo/planner/spindle_changes.hpp"
#include "ipo/queue/block_queue.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// Times moves at constant speed: cutting moves at their feed with its override, at most
/// limits.feed; rapids as fast as the velocities of the axes allow. Where the machine must rest
/// (G61.1, and blocks that do not move), it waits until setpoints that lag have arrived; corners
/// are passed at speed. Override, hold and stop count from where the path is.
class UnplannedFeed {
 public:
  /// `machine` must outlive it.
  UnplannedFeed(const Machine& machine, double feed_override);

  void push(Block block);
  /// Returns the next block; nothing while the machine is held.
  std::optional<TimedBlock> pop();

  /// See Planner::replan().
  std::deque<TimedBlock> replan(PartlyPassed rest, const State& now, double t,
                                const FeedControl& asked);

 private:
  TimedBlock take();
  void time_move(const Move& move, Profile& profile);
  void wait_for_setpoints(Profile& profile);

  const Machine& machine_;
  double settling_;  // s: by which setpoints lag
  FeedControl feed_;
  std::deque<TimedBlock> pending_;
  std::optional<TimedBlock> held_;
  double begin_ = 0;      // mm of the first pending block that has been run
  double t_ = 0, s_ = 0;  // where the first pending block starts
  SpindleChanges spindle_;
  bool arriving_ = false;  // setpoints may lag
};

/// Returns the speed, mm/s, of a move at its feed, or of a rapid, with its override.
double constant_speed(const Move& move, const Machine& machine,
                      const Overrides& overrides) noexcept;

}  // namespace softcnc::ipo
