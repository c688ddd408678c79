// SPDX-License-Identifier: MIT
// Blocks in, timed blocks out: as fast as the machine may follow them, and never outside a limit.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "ipo/block_queue.hpp"
#include "ipo/corner_stage.hpp"
#include "ipo/window.hpp"
#include "motion/machine.hpp"

namespace softcnc::ipo {

struct PlannerCounts {
  std::size_t nodes = 0;   // of the grid, in all
  std::size_t passes = 0;  // over the window
  PlanEffort effort;
};

class Planner {
 public:
  /// `machine` must outlive the planner.
  Planner(const Machine& machine, double feed_override, Diagnostics& diagnostics);
  Planner(const Planner&) = delete;
  Planner& operator=(const Planner&) = delete;

  /// A move that leaves the travel of an axis is reported (SC4001) and left out: what came before it
  /// ends at rest.
  void push(Block block);
  /// Nothing follows: the machine rests at the end of the last block.
  void finish();

  /// The next block whose speeds no longer depend on blocks not yet pushed.
  std::optional<TimedBlock> pop();
  /// The same where nothing more may be pushed for long: finds out what is settled by now.
  std::optional<TimedBlock> pop_now();

  PlannerCounts counts() const noexcept;

 private:
  void accept(Piece piece);
  void leave_out();
  void flush_corners();
  bool run_move();
  bool settle();
  void report_no_speed(Profile& profile);
  void rest_at_turn(Profile& profile);
  TimedBlock take();

  const Machine& machine_;
  Diagnostics& diagnostics_;
  Constraints constraints_;
  CornerStage corners_;
  std::unique_ptr<Window> window_;
  std::deque<TimedBlock> pending_;
  PlannerCounts counts_;
  std::size_t settled_ = 0;    // intervals at the front of the window whose speeds are final
  std::size_t last_size_ = 0;  // unsettled intervals after the last passes
  double t_ = 0, s_ = 0;       // where the first pending block starts
  double last_rest_ = -1;      // when the machine last rested at a turn
  bool rest_ = true;           // before the next move
  bool finished_ = false;
  bool hurried_ = false;  // settling is worth its while however little has come
};

}  // namespace softcnc::ipo
