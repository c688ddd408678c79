// SPDX-License-Identifier: MIT
// Real time as Linux has it: a thread that comes first, memory that stays, a clock to wait for.
#pragma once

#include <cstdint>
#include <string>

namespace softcnc::app {

/// What the system has granted.
struct RealtimeRights {
  bool first = false;   // SCHED_FIFO: before all ordinary threads
  bool locked = false;  // no page of memory is fetched while it runs
  std::string refusal;  // why not; empty: all is granted

  bool all() const noexcept { return first && locked; }
};

/// Asks for both for the calling thread, and touches its stack.
RealtimeRights become_realtime();

/// Gives both back.
void become_ordinary() noexcept;

/// In words: "SCHED_FIFO, memory locked".
std::string text(const RealtimeRights& rights);

/// ns of a clock that nobody sets.
std::int64_t now_ns() noexcept;

/// Returns when the clock has come to `instant`, ns, or at once if it has passed. Realtime.
void sleep_until(std::int64_t instant) noexcept;

}  // namespace softcnc::app
