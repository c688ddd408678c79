// SPDX-License-Identifier: MIT
// When the speed of the spindle was last changed, since a wait for it counts from there.
#pragma once

#include <algorithm>
#include <deque>
#include <variant>

#include "motion/model/block.hpp"

namespace softcnc::ipo {

class SpindleChanges {
 public:
  /// A block ends at the instant `t` of the plan, s.
  void pass(const Block& block, double t) {
    const auto* action = std::get_if<Action>(&block.what);
    if (action == nullptr || action->kind != Action::Kind::spindle) return;
    times_.push_back(t);
    if (times_.size() > kMost) times_.pop_front();
  }

  /// What comes after `t` is planned again.
  void go_back_to(double t) {
    while (!times_.empty() && times_.back() > t) times_.pop_back();
  }

  /// Returns how long a dwell that begins at `t` lasts, s.
  double time_left(const Dwell& dwell, double t) const {
    if (!dwell.since_spindle || times_.empty()) return dwell.duration;
    return std::max(dwell.duration - (t - times_.back()), 0.0);
  }

 private:
  static constexpr std::size_t kMost = 1000;  // no plan goes back behind as many changes

  std::deque<double> times_;
};

}  // namespace softcnc::ipo
