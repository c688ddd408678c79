// SPDX-License-Identifier: MIT
#include "runtime/figures/run_times.hpp"

#include <algorithm>

namespace softcnc::runtime {

void RunTimes::add(const ipo::TimedBlock& timed, double until, double feed_override) {
  if (of_plan_) add_limits(timed.profile, until);
  keeper_.add(timed, until, feed_override);
  if (!by_line_) return;
  lines_.add(timed, until, feed_override);
  causes_.add(timed, until, feed_override);
}

void RunTimes::add_row(Limit limit, double period) noexcept {
  by_limit_[static_cast<std::size_t>(limit)] += period;
}

void RunTimes::add_limits(const ipo::Profile& profile, double until) {
  profile.for_each_piece([&](Limit limit, double duration) {
    by_limit_[static_cast<std::size_t>(limit)] += std::clamp(until, 0.0, duration);
    until -= duration;
  });
}

}  // namespace softcnc::runtime
