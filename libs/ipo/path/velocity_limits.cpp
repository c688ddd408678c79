// SPDX-License-Identifier: MIT
// What intervals require of their neighbours; what joints require: corner_limits.cpp.
//
// Where something limits the length g of every step that touches it, the speed is limited to g / T
// within g of it on either side. That is enough: a step that reached it and were longer than g
// would have to cross one of those two parts, which alone takes a period.
#include <algorithm>
#include <cmath>

#include "ipo/path/chain.hpp"
#include "ipo/path/corner_limits.hpp"
#include "ipo/path/step_limit_dilation.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {
namespace {

class VelocityLimitDerivation {
 public:
  VelocityLimitDerivation(Chain& chain, const ConstraintList& constraints)
      : chain_(chain), constraints_(constraints), period_(constraints.limits().period) {}

  void run(std::size_t first) {
    reset(first);
    const std::size_t asking = chain_.felt_from(first, period_);
    const std::size_t sharing = chain_.felt_from(asking, period_);
    find_times(sharing);
    find_tops(asking);
    find_shared_steps(sharing);
    dilate_steps(asking);
    apply_corner_limits(chain_, constraints_, times_, asking);
  }

 private:
  void reset(std::size_t first) {
    chain_.inside.resize(first);
    for (std::size_t i = first; i < chain_.intervals.size(); ++i)
      chain_.inside.push_back({limit_inside(i)});
    for (std::size_t n = first; n < chain_.nodes.size(); ++n)
      chain_.nodes[n].velocity_limit = chain_.own_limit(n);
  }

  /// The contour tolerance is the only limit that differs between the ends of a line.
  VelocityLimit limit_inside(std::size_t i) const {
    const VelocityLimit left = chain_.left_limit(i);
    const VelocityLimit& right = chain_.intervals[i].right_limit;
    return left.limit == Limit::contour && right.q > left.q ? right : left;
  }

  void find_times(std::size_t first) {
    times_.assign(chain_.intervals.size(), 0.0);
    for (std::size_t i = first; i < times_.size(); ++i)
      times_[i] = chain_.intervals[i].shortest_time();
  }

  /// Finds the highest q by groups of intervals that take a period or more: a step extends into the
  /// next group at most.
  void find_tops(std::size_t first) {
    group_.assign(chain_.intervals.size(), 0);
    tops_.assign(1, 0);
    double time = 0;
    for (std::size_t i = first; i < chain_.intervals.size(); ++i) {
      const Interval& interval = chain_.intervals[i];
      group_[i] = tops_.size() - 1;
      tops_.back() = std::max({tops_.back(), interval.left_limit.q, interval.right_limit.q});
      if ((time += times_[i]) < period_) continue;
      tops_.push_back(0);
      time = 0;
    }
  }

  /// The highest q that a step through the interval touches.
  double top_near(std::size_t interval) const {
    const auto group = tops_.begin() + static_cast<std::ptrdiff_t>(group_[interval]);
    const double before = group == tops_.begin() ? 0 : group[-1];
    const double after = group + 1 == tops_.end() ? 0 : group[1];
    return std::max({before, *group, after});
  }

  /// Curves within a step of a corner leave it a part of the chord tolerance; q goes with it.
  void find_shared_steps(std::size_t first) {
    step_share_.assign(chain_.intervals.size(), 1.0);
    for (std::size_t n = first; n < chain_.nodes.size(); ++n)
      if (chain_.nodes[n].turns())
        chain_.for_intervals_in_step(n, period_, [this](std::size_t i) {
          step_share_[i] = tuning::joints::kTurnShare;
          return true;
        });
  }

  void dilate_steps(std::size_t first) {
    StepLimitDilation dilation(chain_, times_, period_, first);
    for (std::size_t i = first; i < chain_.intervals.size(); ++i) {
      VelocityLimit bound = chain_.intervals[i].step_limit;
      bound.q *= step_share_[i];
      if (bound.q < top_near(i)) dilation.ask(i, bound);  // else it binds nowhere
    }
    dilation.lower();
  }

  Chain& chain_;
  const ConstraintList& constraints_;
  double period_;
  std::vector<double> tops_;        // the highest q that any interval of a group allows
  std::vector<std::size_t> group_;  // by interval
  std::vector<double> times_;       // s, by interval: the shortest
  std::vector<double> step_share_;  // by interval
};

}  // namespace

void derive_velocity_limits(Chain& chain, const ConstraintList& constraints, std::size_t first) {
  VelocityLimitDerivation(chain, constraints).run(first);
}

}  // namespace softcnc::ipo
