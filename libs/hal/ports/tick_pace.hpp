// SPDX-License-Identifier: MIT
// The instant at which the next write to a port is due, however late the last one was.
#pragma once

#include <algorithm>
#include <cstdint>

namespace softcnc::hal {

/// Ticks keep their period on the whole, but never come closer to each other than `shortest`, which
/// keeps the rules of the driver; a tick that is later than that delays all after it.
class TickPace {
 public:
  TickPace(std::int64_t period, std::int64_t shortest, std::int64_t first) noexcept
      : period_(period), shortest_(shortest), due_(first) {}

  std::int64_t due() const noexcept { return due_; }

  /// Takes the tick that was due, at `now`, and returns how late it is, ns. Realtime.
  std::int64_t come(std::int64_t now) noexcept {
    const std::int64_t late = now - due_;
    due_ = std::max(due_ + period_, now + shortest_);
    return late;
  }

 private:
  std::int64_t period_, shortest_, due_;  // ns
};

}  // namespace softcnc::hal
