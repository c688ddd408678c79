// SPDX-License-Identifier: MIT
// The queue between planning and the cycle: timed blocks, in order.
#pragma once

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "ipo/limits/planner_limits.hpp"
#include "ipo/path/piece.hpp"
#include "ipo/path/profile.hpp"
#include "ipo/queue/pulse_walk.hpp"

namespace softcnc::ipo {

/// A block, or several run as one curve, with its place in time and along the path.
struct TimedBlock {
  Block block;
  Profile profile;
  double t_start = 0;                   // s from the start of the program
  double s_start = 0;                   // mm of path from the start of the program
  std::vector<Mark> marks{};            // where later blocks begin
  std::unique_ptr<PulseWalk> pulses{};  // of a move, by a method of reference pulses

  double t_end() const noexcept { return t_start + profile.duration(); }
  const Move* move() const noexcept { return std::get_if<Move>(&block.what); }

  /// Returns which block it is `s` mm from its start, and its position in the program text.
  /// Realtime.
  Mark at(double s) const noexcept {
    const auto later = std::upper_bound(marks.begin(), marks.end(), s,
                                        [](double a, const Mark& mark) { return a < mark.s; });
    return later == marks.begin() ? Mark{0, block.source, block.number} : later[-1];
  }
  int last_number() const noexcept { return marks.empty() ? block.number : marks.back().number; }
};

/// A further part of the block before it.
struct Continuation {
  Profile profile;
};

using TimedPart = std::variant<TimedBlock, Continuation>;

/// Blocks of which the first `passed` have been passed by the machine, or will have been by the
/// instant from which the rest is planned again.
struct PartlyPassed {
  std::deque<TimedBlock> blocks;
  std::size_t passed = 0;
};

/// The reader only advances and frees nothing; the writer frees what the reader has passed.
class BlockQueue {
 public:
  /// Blocks are remembered for `memory` s after trim() has removed them. Where setpoints lag behind
  /// the plan, trim() leaves those in the queue that ended up to `lag` s ago.
  explicit BlockQueue(double memory, double lag = 0) : memory_(memory), lag_(lag) {}

  void push(TimedBlock block);
  void push(const Continuation& more);  // of the block pushed last
  void push(TimedPart part);
  /// Removes what has been passed and had ended by `until`, s. Planning side.
  void trim(double until = kUnlimited);
  /// Makes the block of the instant `t`, s, the present one again, for a machine that has not come
  /// so far. Requires that it is in the queue. Planning side.
  void go_back(double t, double same) noexcept;
  /// Takes out everything from the present block on, to be planned again, and before it what still
  /// matters. Planning side.
  PartlyPassed take_rest();
  /// Gives back what take_rest() has taken. Planning side.
  void put_back(PartlyPassed rest);
  /// Restores the queue: what follows begins at `t`; `passed` still matters. Planning side.
  void begin_again(std::deque<TimedBlock> passed, double t);

  /// Realtime.
  bool empty() const noexcept { return current_ == blocks_.size(); }
  const TimedBlock& front() const noexcept { return blocks_[current_]; }   // if not empty()
  PulseWalk* pulses() noexcept { return blocks_[current_].pulses.get(); }  // likewise
  void advance() noexcept { ++current_; }

  /// Returns the block that follows the present one; null if the queue holds none. Realtime.
  const TimedBlock* next() const noexcept {
    return current_ + 1 < blocks_.size() ? &blocks_[current_ + 1] : nullptr;
  }
  /// Returns the last block up to the present one that begins at `s` mm along the program or before
  /// it; null if the queue holds none. Realtime.
  const TimedBlock* at_place(double s) const noexcept;

  /// Calls visit(block) for what has been passed since the last trim() and had ended by `until`, s.
  template <typename Visit>
  void for_each_passed(Visit&& visit, double until = kUnlimited) const {
    const std::size_t end = passed_by(until);
    for (std::size_t i = kept_; i < end; ++i) visit(blocks_[i]);
  }

  /// Calls visit(block) for what has been passed and is in the queue, and for the present block.
  template <typename Visit>
  void for_each_recent(Visit&& visit) const {
    for (std::size_t i = 0; i < blocks_.size() && i <= current_; ++i) visit(blocks_[i]);
  }

  /// Calls visit(block) for the present block and what lies ahead.
  template <typename Visit>
  void for_each_ahead(Visit&& visit) const {
    for (std::size_t i = current_; i < blocks_.size(); ++i) visit(blocks_[i]);
  }

  /// Calls visit(block) for what is in the queue, passed or not.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for (const TimedBlock& block : blocks_) visit(block);
  }

  /// Returns the length of path, mm, up to which it is known; nothing where no move is in the
  /// queue.
  std::optional<double> s_end() const noexcept {
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block)
      if (block->move()) return block->s_start + length(block->move()->path);
    return std::nullopt;
  }

  /// Returns the instant, s, up to which everything is timed.
  double t_end() const noexcept { return t_end_; }

 private:
  std::size_t passed_by(double until) const noexcept;
  bool is_left(const TimedBlock& passed) const noexcept;
  void keep(std::deque<TimedBlock> passed);

  double memory_, lag_;
  std::deque<TimedBlock> blocks_, remembered_;
  std::size_t taken_memory_ = 0;  // blocks that were remembered when take_rest() took them
  std::size_t current_ = 0;
  std::size_t kept_ = 0;  // blocks that trim() has left, though they are passed
  double t_end_ = 0;
};

}  // namespace softcnc::ipo
