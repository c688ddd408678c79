// SPDX-License-Identifier: MIT
// A thread that exchanges with a backend in real time, one setpoint each period.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "runtime/realtime/lateness.hpp"
#include "runtime/realtime/realtime.hpp"
#include "runtime/realtime/setpoint_queue.hpp"

namespace softcnc::runtime {

/// The punctuality of a run in real time.
struct Punctuality {
  Lateness lateness;           // of the periods in which it moved
  std::int64_t unplanned = 0;  // periods for which no setpoint had been planned in time
  RealtimeRights rights;

  /// Returns the number of periods missed: later than a whole one, or without a setpoint.
  std::int64_t overruns() const noexcept { return lateness.overruns() + unplanned; }
};

/// A period that comes late delays those after it, and the run goes on.
class RealtimeCycle final : public SetpointQueue {
 public:
  enum class Pace : std::uint8_t {
    clock,    // one setpoint each period
    backend,  // which has a clock of its own, and makes an exchange wait until it has room
  };
  RealtimeCycle(hal::Backend& backend, double period, Pace pace = Pace::clock);
  ~RealtimeCycle() override { stop(); }

  void wait() noexcept override;
  void stop() noexcept override;

  /// Returns the punctuality of the run, by the clock. To be called after stop().
  const Punctuality& punctuality() const noexcept { return punctuality_; }

 private:
  void run_by_clock() noexcept;
  void run_by_backend() noexcept;

  std::int64_t period_;  // ns
  std::atomic<bool> stopping_{false};
  Punctuality punctuality_;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace softcnc::runtime
