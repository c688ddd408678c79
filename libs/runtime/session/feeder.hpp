// SPDX-License-Identifier: MIT
// The planning side of a run: from text to timed blocks in a queue.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ipo/planner/planner.hpp"
#include "ipo/queue/block_queue.hpp"
#include "ipr/interpreter/interpreter.hpp"
#include "motion/verification/programmed_path.hpp"
#include "runtime/session/block_history.hpp"
#include "runtime/session/channel_options.hpp"
#include "runtime/session/first_cut_delay.hpp"
#include "runtime/session/motion_limit.hpp"
#include "runtime/session/spindle_wait.hpp"
#include "runtime/session/watcher.hpp"

namespace softcnc::runtime {

/// The planning side: reads, interprets and plans as far as the queue needs it.
class Feeder {
 public:
  /// Makes a feeder. Everything referred to must outlive it. `input` is the descriptor of the
  /// reader; -1 if there is none and the text is fed.
  Feeder(ipr::Reader& reader, int input, const Machine& machine, const ChannelOptions& options,
         Diagnostics& diagnostics);

  /// Times blocks until the queue reaches beyond `until`, or holds all there are. After an error
  /// the motion ends with the last good block, and the rest is read only to report what else is
  /// wrong.
  void fill(ipo::BlockQueue& queue, double until);
  /// Times what there is of the path up to `s` mm, but no further than until `t`. What may
  /// still change when more of a program comes is left as it is.
  void look_ahead(ipo::BlockQueue& queue, double s, double t);
  /// Reads what has come so far, at most `blocks`, so that what is wrong with it is known, and
  /// times what does not depend on what may follow.
  void read_ahead(ipo::BlockQueue& queue, int blocks);
  /// The path in the queue ends at rest where what has come so far ends, and the machine stays
  /// there for two periods; more may come.
  void come_to_rest(ipo::BlockQueue& queue);
  /// The next block of the program, before lines that have not been read.
  void push(Block block) { pushed_.push_back(std::move(block)); }
  /// Returns whether fill() has ended because the program's pipe has nothing more yet.
  bool waiting() const noexcept { return waiting_; }
  /// Returns whether the queue must be filled further before anything is taken from it: where the
  /// rest of the path will be planned again, as much of it must be known as of a program in a file.
  bool needs_more_first() const noexcept { return waiting_ && patient_; }

  /// Plans the queue again from the state `now` in its first block, at program time `t`; fill()
  /// adds what follows. After a stop nothing more is read.
  void replan(ipo::BlockQueue& queue, const ipo::State& now, double t,
              const ipo::FeedControl& asked);

  /// Lets the machine stop likewise, unless `in_time`, which is asked once the stop is found, says
  /// that it comes too late: then the queue stays as it is, and the result is false.
  bool stop_in_time(ipo::BlockQueue& queue, const ipo::State& now, double t,
                    const ipo::FeedControl& asked, const std::function<bool()>& in_time);

  /// Reads no further; the queue gets what has been read.
  void finish(ipo::BlockQueue& queue);

  /// Sets the switches of the operator for the lines that have not been read yet.
  void set_switches(bool block_skip, bool optional_stop, bool single_block) noexcept {
    interpreter_.set_switches(block_skip, optional_stop);
    options_.single_block = single_block;
  }

  /// Returns the pauses up to the end of the queue.
  const std::deque<Pause>& pauses() const noexcept { return pauses_; }
  /// The first of them has been answered.
  void pass_pause() noexcept {
    if (!pauses_.front().before) answered_ = pauses_.front().block.number;
    pauses_.pop_front();
  }

  /// The probing move at which the program waits; null: none.
  const ProbeRequest* probe() const noexcept { return interpreter_.probe(); }
  void probed(const ProbeAnswer& answer) { interpreter_.probed(answer); }

  /// Returns the number of the last block that has been read.
  int last_number() const noexcept { return last_number_; }
  /// What the lines before the first one with an error have left: Interpreter::memory().
  const ipr::Memory& memory() const noexcept { return interpreter_.memory(); }

  /// The states of the machine as far as has been read.
  BlockHistory<MachineState>& states() noexcept { return states_; }
  const BlockHistory<MachineState>& states() const noexcept { return states_; }
  /// Returns the coordinates in force at each block, likewise.
  const BlockHistory<ipr::Coordinates>& coordinates() const noexcept { return coordinates_; }
  /// The machine is in block `number`.
  void pass(int number) {
    states_.pass(number);
    coordinates_.pass(number);
  }

  /// Passes every block to `programmed` before the planner gets it.
  void show(ProgrammedPath& programmed) noexcept { programmed_ = &programmed; }

  /// How far the program has been read, in bytes from its beginning.
  std::uint64_t read_to() noexcept { return parser_.reader().place().offset; }
  std::vector<ipr::FoundFile> called_files() const { return interpreter_.called_files(); }
  const std::set<std::string>& missing_files() const noexcept {
    return interpreter_.missing_files();
  }
  /// Returns the origins of the work systems that moves belong to, mm, machine coordinates, by
  /// their index: each as the first of these moves has it.
  const std::map<int, AxisVector>& origins() const noexcept { return origins_; }
  const std::vector<StockOutline>& stocks() const noexcept { return interpreter_.stocks(); }
  ipo::PlannerCounts counts() const noexcept { return planner_.counts(); }
  double cpu() const noexcept { return cpu_; }  // s

 private:
  bool read_block();
  void note_origin(const Block& block);
  void plan(Block block);
  std::optional<Block> next_block();
  void take(ipo::BlockQueue& queue, ipo::TimedPart part);
  void take_all(ipo::BlockQueue& queue);
  void end_at_last_block();
  bool is_endless();
  void read_unplanned(std::optional<Block> block);
  void find_pauses(const ipo::TimedBlock& timed);
  bool was_single(int number) const noexcept;
  void begin_replan(const ipo::BlockQueue& queue, const ipo::FeedControl& asked);
  std::optional<Block> wait_for_block();
  void read_on(std::optional<Block> block);

  int input_;  // where it reads
  const Machine& machine_;
  const Machine path_machine_;  // with the limits of its paths
  ChannelOptions options_;
  Diagnostics& diagnostics_;
  ipr::Parser parser_;
  ipr::Interpreter interpreter_;
  ipo::Planner planner_;
  ProgrammedPath* programmed_ = nullptr;
  std::deque<Pause> pauses_;
  std::deque<Block> pushed_;  // and not yet planned
  std::map<int, AxisVector> origins_;
  int last_system_ = kNoSystem;
  double first_cut_delay_;  // s: of a program that has not begun,
  DelayPlace delay_place_;  // and where it rests for so long
  SourcePos last_place_;    // of the block planned last
  int last_number_ = 0;
  std::vector<std::pair<int, bool>> single_;  // single block, from the block of a number on
  int answered_ = 0;               // the number of the block whose pause has been answered last
  bool at_rest_ = true;            // where all ends that has come
  std::optional<int> last_block_;  // the number of the last one in the queue
  BlockHistory<MachineState> states_;
  BlockHistory<ipr::Coordinates> coordinates_;
  SpindleWait spindle_;
  bool ended_ = false, waiting_ = false;
  bool patient_;
  MotionLimit limit_;
  double planned_ = 0;               // s: the end of the queue
  std::int64_t read_again_ = 65536;  // bytes: where more have been, it is asked for an end
  double until_ = 0;                 // what fill() was asked for
  double cpu_ = 0;
};

}  // namespace softcnc::runtime
