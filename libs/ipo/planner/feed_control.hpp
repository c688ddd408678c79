// SPDX-License-Identifier: MIT
// What an operator requests of the feed while a program runs.
#pragma once

#include "ipo/limits/overrides.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

struct FeedControl {
  double feed_override = 1;   // of the programmed feed; 0 holds
  bool hold = false;          // rest on the path until it is false again
  bool stop = false;          // rest on the path for good: nothing follows
  double rapid_override = 1;  // of rapids: above 0, at most 1

  Overrides overrides() const noexcept { return {feed_override, rapid_override}; }
  bool halts() const noexcept { return stop || hold || feed_override == 0; }
  Limit halted_by() const noexcept {
    if (stop) return Limit::stop;
    return hold ? Limit::hold : Limit::override_;
  }
};

}  // namespace softcnc::ipo
