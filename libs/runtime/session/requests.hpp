// SPDX-License-Identifier: MIT
// The one mailbox of a run: what its operator, or the script of --at, requests while it runs.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "ipo/planner/feed_control.hpp"
#include "motion/model/cycle.hpp"
#include "runtime/session/feed_script.hpp"

namespace softcnc::runtime {

/// Keeps requests until the planning side answers them. stop() may be called by any thread; the
/// others belong to the thread that plans.
class Requests {
 public:
  /// Makes the requests of a run that begins with this override. `script` is sorted by time.
  explicit Requests(double feed_override = 1, std::vector<FeedEvent> script = {})
      : control_{feed_override, false, false}, script_(std::move(script)) {}

  /// Multiplies the programmed feed, up to kLargestOverride. NaN changes nothing.
  void set_feed_override(double feed_override) noexcept;
  /// Multiplies the speed of rapids, from kSmallestRapid to 1. NaN changes nothing.
  void set_rapid_override(double rapid_override) noexcept;
  void hold() noexcept;
  void resume() noexcept;
  /// Lets the machine come to rest on the path, and ends the program there: nothing else is
  /// answered any more.
  void stop() noexcept { panel_.stop = true; }
  /// Requests what is in force once more, except a stop: a new path does not know of it.
  void begin_again() noexcept {
    panel_.stop = false;
    pending_ = true;
  }

  bool stops() const noexcept { return panel_.stop; }
  /// Returns what the cycle looks at in each period.
  const Panel& panel() const noexcept { return panel_; }
  /// Returns what is in force once everything up to now is answered.
  const ipo::FeedControl& control() const noexcept { return control_; }

  /// Returns whether something is to be answered at the instant `t` of the run, s.
  bool due(double t) const noexcept {
    return !stops() && (pending_ || (answered_ < script_.size() && t >= script_[answered_].time));
  }
  /// Takes what is due and returns what the rest of the path is to be planned for.
  const ipo::FeedControl& answer(double t) noexcept;
  /// Returns how many events of the script the run has not reached.
  std::size_t script_left() const noexcept { return script_.size() - answered_; }

 private:
  Panel panel_;
  ipo::FeedControl control_;
  bool pending_ = false;
  std::vector<FeedEvent> script_;
  std::size_t answered_ = 0;
};

}  // namespace softcnc::runtime
