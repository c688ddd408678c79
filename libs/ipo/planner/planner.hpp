// SPDX-License-Identifier: MIT
// Blocks in, timed blocks out: as fast as the machine can follow them, and never beyond a limit.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ipo/jerk_limited/horizon.hpp"
#include "ipo/path/window.hpp"
#include "ipo/planner/feed_control.hpp"
#include "ipo/planner/spindle_changes.hpp"
#include "ipo/planner/stop.hpp"
#include "ipo/planner/unplanned_feed.hpp"
#include "ipo/queue/block_queue.hpp"
#include "ipo/queue/pulse_stage.hpp"
#include "ipo/smoothing/corner_stage.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

struct PlannerCounts {
  std::size_t nodes = 0;   // of the grid, in all
  std::size_t passes = 0;  // over the window
  PlanEffort effort;
  RebuildCounts rebuild;
};

class Planner {
 public:
  /// `machine` and the further constraints must outlive the planner.
  Planner(const Machine& machine, double feed_override, Diagnostics& diagnostics,
          const Horizon& horizon = {}, const FurtherConstraints& further = {});
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  /// A move that leaves the travel of an axis (SC4001), or that its pulses cannot make (SC7080), is
  /// reported and skipped: what came before it ends at rest.
  void push(Block block);
  /// What has been pushed ends at rest, as at the end of a program, and no longer waits for what
  /// follows; more may be pushed. Corners that wait for the next move stay sharp.
  void come_to_rest();
  /// Ends the program: the machine rests at the end of the last block.
  void finish();

  /// Returns the next block whose speeds no longer depend on blocks not yet pushed.
  std::optional<TimedBlock> pop();
  /// Returns the next block as soon as a part of it is settled; then its further parts.
  std::optional<TimedPart> pop_part();
  /// Like pop_part(), where nothing more may be pushed for long: finds out what is settled by now.
  std::optional<TimedPart> pop_part_now();

  /// Plans everything again from `state` inside the first block of `rest` not passed, at program
  /// time `t`, for the feed requested from then on. pop() continues with that block; a block in
  /// which the machine is held has no end. Returns what has been passed.
  std::deque<TimedBlock> replan(PartlyPassed rest, const State& state, double t,
                                const FeedControl& asked);
  /// Lets the machine halt likewise, unless `in_time`, which is asked once the stop is found, says
  /// that it comes too late: then nothing is halted, `rest` holds the same motion, and the result
  /// is false. Otherwise `rest` keeps what has been passed. Not for methods that ignore the plan.
  bool halt_in_time(PartlyPassed& rest, const State& state, double t, const FeedControl& asked,
                    const std::function<bool()>& in_time);

  PlannerCounts counts() const noexcept;

 private:
  enum class Found : std::uint8_t { nothing, part, all };

  /// A stop: where it begins, what the machine runs before that in the same block, and the stop
  /// itself, by block.
  struct StopAhead {
    State from;
    Profile before;
    std::vector<Profile> profiles;
    std::vector<Profile> whole = {};  // of the blocks that it runs to their ends before that
  };
  enum class StopWithin : std::uint8_t { block, queue };

  void accept(Piece piece);
  bool lay_ahead();
  void lay(Piece piece);
  void leave_out(Diagnostic diagnostic, const SourcePos& place);
  void flush_corners();
  void take_back(PartlyPassed& rest, double s, double t);
  State begin_replan(PartlyPassed& rest, const State& state, double t);
  void halt(PartlyPassed& rest, const StopAhead& stop, double t, const FeedControl& asked);
  void go_on(PartlyPassed& rest, const State& now, double t, const FeedControl& asked);
  StopAhead stop_ahead(PartlyPassed& rest, const State& now, double t, Limit as, StopWithin within);
  std::vector<Profile> planned_to_rest(PartlyPassed& rest, const State& now, double t);
  void plan_up_to_rest(PartlyPassed& rest);
  double distance_to_rest(double s) const;
  void lay_out(const std::deque<TimedBlock>& passed, double s);
  void append(const Move& move, RestBefore rest);
  bool stop_first();
  Found find_next(bool parts);
  Found run_move(bool parts);
  bool has_part() const noexcept;
  bool settle();
  void report_no_speed(Profile& profile);
  void rest_at_turn(Profile& profile);
  void rest_until_sample(Profile& profile);
  TimedBlock take_ready();
  TimedBlock take();
  TimedBlock take_begin();
  Continuation take_more();

  const Machine& machine_;
  Diagnostics& diagnostics_;
  ConstraintList constraints_;
  const Horizon horizon_;
  std::optional<UnplannedFeed> unplanned_;  // instead of all that follows
  PulseStage pulses_;
  CornerStage corners_;
  std::unique_ptr<Window> window_;
  std::unique_ptr<Constraint>
      slower_;                    // the feed to which the moves of the window are to slow down
  std::deque<TimedBlock> ready_;  // timed; before the pending ones
  std::deque<TimedBlock> pending_;
  std::deque<Piece> ahead_;  // after the pending ones: a long curve, and what has come since
  double laid_ = 0;          // mm of the first of them that are pending already
  std::size_t given_ = 0;    // pieces of the first pending one that have left already
  PlannerCounts counts_;
  std::size_t settled_ = 0;    // intervals at the front of the window whose speeds are final
  std::size_t last_size_ = 0;  // unsettled intervals after the last passes
  double t_ = 0, s_ = 0;       // where the first pending block starts
  SpindleChanges spindle_;
  double last_rest_ = -1;          // when the machine last rested at a turn
  RestBefore rest_ = Limit::stop;  // before the next move
  bool finished_ = false;
  bool resting_ = false;  // at the end of what has been pushed
  bool to_rest_ = false;  // at the end of what is pending, whatever follows
  FeedControl feed_;
  Overrides running_;                   // overrides with which the machine last continued
  Overrides ceiling_;                   // the highest ones from which it may still be slowing down
  double begun_ = 0;                    // mm of path where the last plan began,
  double slow_until_ = 0;               // and where the machine is as slow as that plan requires
  std::vector<Profile> stop_profiles_;  // from there to rest, until slowing down is planned
  bool rests_anyway_ = false;           // the stop profiles are what the machine was running
  bool hurried_ = false;                // settle however little has come
};

}  // namespace softcnc::ipo
