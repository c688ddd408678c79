// SPDX-License-Identifier: MIT
// The stretch of path between what is already timed and what is not yet read.
//
// Speeds in it are final as soon as they no longer depend on what follows: the backward pass is run
// once from rest at the end of the window and once from the highest speed there; left of the node
// where the two meet they agree bit by bit. So the plan is that of the whole program, however the
// program arrives and wherever the window ends.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ipo/schedule.hpp"

namespace softcnc::ipo {

class Window {
 public:
  explicit Window(const Constraints& constraints) : constraints_(constraints) {}

  /// Appends a move from `from` mm to its end. The machine rests at the joint if the tangent turns
  /// there by more than kTangentTolerance, or if `rest` asks for it.
  void append(const Move& move, bool rest, double from = 0);

  /// Intervals from the front on; interval i lies between nodes i and i + 1.
  std::size_t size() const noexcept { return intervals_.size() - front_; }

  /// The last `count` intervals appended.
  std::span<const Interval> newest(std::size_t count) const noexcept {
    return std::span(intervals_).last(count);
  }

  /// Finds the speeds and returns the number of intervals, from the front, whose speeds are final.
  /// `ended`: nothing follows the window, so all are, and the machine rests at its end.
  std::size_t settle(bool ended);

  /// After settle(): the largest q at the front from which rest at node `end` can be reached.
  double reachable_from_rest(std::size_t end);

  /// After settle(): runs interval 0 from its left speed, appends its pieces and drops it.
  void run_front(std::vector<SpeedPiece>& out);

  /// q at the front.
  double front_q() const noexcept { return q_; }
  void set_front_q(double q) noexcept { q_ = q; }
  /// Whether the direction of the path jumps at the front.
  bool turns_at_front() const noexcept { return !nodes_[front_].kink.isZero(0); }

 private:
  struct Node {
    Cap own;                               // of the joint and its two intervals
    AxisVector kink = AxisVector::Zero();  // |jump of x'| by axis
    double s = 0;                          // mm from the first node ever
    Cap cap;                               // own, and what neighbours ask for
    double k = 0;                          // the largest reachable q
  };

  void derive_caps();
  void spread_step_caps();
  void spread_step_cap(std::size_t interval);
  void pass_kinks();
  void pass_kink(std::size_t node);
  double kink_load(std::size_t node, double v) const;
  void back_from(std::size_t last, double k);
  Reach reach(std::size_t interval) const noexcept;
  void forget();
  double step_reach() const noexcept;

  const Constraints& constraints_;
  std::vector<Interval> intervals_;
  std::vector<Cap> inside_;    // by interval: cap of a straight one between its nodes
  std::vector<double> share_;  // by interval: of the axis accelerations
  std::vector<Node> nodes_;    // one more than intervals
  std::size_t front_ = 0;      // intervals left of it are kept for what they ask of neighbours
  double top_ = 0;             // the highest q any interval in the window allows
  double q_ = 0;               // at the front node
};

/// The tangent turns where its direction jumps by more than this (rad); below it the path is
/// tangent but for the rounding of the program, and the machine passes with a bounded jump of
/// velocity.
inline constexpr double kTangentTolerance = 0.01;

}  // namespace softcnc::ipo
