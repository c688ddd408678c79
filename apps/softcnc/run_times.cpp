// SPDX-License-Identifier: MIT
#include "run_times.hpp"

#include <algorithm>

namespace softcnc::app {

void RunTimes::add(const ipo::TimedBlock& timed, double until, double feed_override) {
  double left = until;
  timed.profile.for_each_piece([&](Limit limit, double duration) {
    by_limit_[static_cast<std::size_t>(limit)] += std::clamp(left, 0.0, duration);
    left -= duration;
  });
  keeper_.add(timed, until, feed_override);
  if (by_line_) lines_.add(timed, until, feed_override);
}

}  // namespace softcnc::app
