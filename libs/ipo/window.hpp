// SPDX-License-Identifier: MIT
// The stretch of path between what is already timed and what is not yet read.
//
// Speeds in it are final as soon as they no longer depend on what follows: the backward pass is run
// once from rest at the end of the window and once from the highest speed there; left of the node
// where the two meet they agree bit by bit. So the plan is that of the whole program, however the
// program arrives and wherever the window ends.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ipo/chain.hpp"
#include "ipo/schedule.hpp"

namespace softcnc::ipo {

class Window {
 public:
  /// `acceleration_share`: of the axis accelerations, 1 for all.
  explicit Window(const Constraints& constraints, double acceleration_share = 1)
      : constraints_(constraints), acceleration_share_(acceleration_share) {}

  /// Appends a move; `rest`: the machine rests where it begins.
  void append(const Move& move, bool rest);

  /// Moves the front past `moves` moves and `s` mm into the next one.
  void skip(std::size_t moves, double s);

  /// Intervals from the front on.
  std::size_t size() const noexcept { return chain_.intervals.size() - front_; }
  /// Those of the move appended last.
  std::span<const Interval> last_move() const noexcept;

  /// Finds the speeds and returns the number of intervals, from the front, whose speeds are final.
  /// `ended`: nothing follows the window, so all are, and the machine rests at its end.
  std::size_t settle(bool ended);

  /// After settle(true): plans rest at the nearest node, to within `resolution` mm, at which the
  /// machine can stand, and returns the number of intervals up to it; nothing if it cannot stand
  /// anywhere in the window.
  std::optional<std::size_t> rest_early(double resolution);

  /// After settle(): runs the first interval, appends its pieces and drops it; true if its move
  /// ends there.
  bool run_front(std::vector<SpeedPiece>& out);

  /// q at the front.
  double front_q() const noexcept { return q_; }
  void set_front_q(double q) noexcept { q_ = q; }

  /// How the direction of the path jumps at the front.
  struct Turn {
    bool turns;
    bool shares_its_step;  // with a curve or another turn
  };
  Turn front_turn() const noexcept;

 private:
  std::size_t last_final_cap() const noexcept;
  double reachable_from_rest(std::size_t end);
  void back_from(std::size_t last, double k);
  Reach reach(std::size_t interval) const noexcept;
  void forget();

  const Constraints& constraints_;
  double acceleration_share_;
  Chain chain_;
  std::size_t front_ = 0;  // what lies left of it is kept for what it asks of its neighbours
  double q_ = 0;           // at the front node
};

}  // namespace softcnc::ipo
