// SPDX-License-Identifier: MIT
// Real time on Linux: scheduling priority, locked memory, a clock to wait for.
#pragma once

#include <cstdint>
#include <string>

namespace softcnc::runtime {

/// The real-time rights that the system has granted.
struct RealtimeRights {
  bool first = false;   // SCHED_FIFO: before all ordinary threads
  bool locked = false;  // no page of memory is fetched while it runs
  std::string refusal;  // why not; empty: all is granted

  bool all() const noexcept { return first && locked; }
};

/// Requests both for the calling thread, and touches its stack.
RealtimeRights become_realtime();

/// Returns both to the system.
void become_ordinary() noexcept;

/// Returns a description of the rights: "SCHED_FIFO, memory locked".
std::string text(const RealtimeRights& rights);

/// Returns the time in ns of a clock that is never set.
std::int64_t now_ns() noexcept;

/// Waits until the clock reaches `instant`, ns; returns at once if it has passed. Realtime.
void sleep_until(std::int64_t instant) noexcept;

}  // namespace softcnc::runtime
