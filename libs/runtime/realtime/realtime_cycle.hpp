// SPDX-License-Identifier: MIT
// A thread that exchanges with a backend in real time, one setpoint each period.
#pragma once

#include <array>
#include <atomic>
#include <deque>
#include <memory>
#include <thread>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/realtime/lateness.hpp"
#include "runtime/realtime/realtime.hpp"
#include "runtime/realtime/realtime_queue.hpp"
#include "runtime/sinks/row_sink.hpp"

namespace softcnc {
class Contour;
}

namespace softcnc::runtime {

/// The punctuality of a run in real time.
struct Punctuality {
  Lateness lateness;           // of the periods in which it moved
  std::int64_t unplanned = 0;  // periods for which no setpoint had been planned in time
  RealtimeRights rights;

  /// Returns the number of periods missed: later than a whole one, or without a setpoint.
  std::int64_t overruns() const noexcept { return lateness.overruns() + unplanned; }
};

/// Setpoints wait in a queue of half a second; their rows come back and are written by the thread
/// that plans. A period that comes late delays those after it, and the run goes on.
class RealtimeCycle {
 public:
  /// The backend must outlive it, and nobody else may touch it between two calls of rest(). `rows`
  /// may be null.
  RealtimeCycle(hal::Backend& backend, double period, RowSink* rows);
  RealtimeCycle(const RealtimeCycle&) = delete;
  RealtimeCycle& operator=(const RealtimeCycle&) = delete;
  ~RealtimeCycle() { stop(); }

  /// Measures the rows that come back before they are written, as soon as their path is known.
  void measure(Contour& contour) noexcept { contour_ = &contour; }

  /// Takes a further setpoint; may wait until the queue has room. Returns the feedback of the last
  /// row that has been written.
  Feedback exchange(const Setpoint& setpoint) noexcept;

  /// Writes the rows that have come back. Returns false when no more are wanted.
  bool collect();

  /// Ends the setpoints so far at rest; returns when all have been exchanged and written.
  void rest();

  /// Ends the thread: no setpoint comes any more.
  void stop() noexcept;

  /// Returns the number of rows that have been exchanged and written; last() returns the last of
  /// them.
  std::int64_t rows() const noexcept { return written_; }
  const Setpoint& last() const noexcept { return last_; }
  const Feedback& feedback() const noexcept { return feedback_; }

  /// Returns the punctuality of the run. To be called after stop().
  const Punctuality& punctuality() const noexcept { return punctuality_; }

 private:
  struct Slot {
    Setpoint setpoint;
    std::vector<TimedStep> pulses;
    std::vector<FinePoint> fine;
    std::vector<double> values;
    std::vector<AxisVector> actual;
    Feedback feedback;
    bool exchanged = false;  // false: after an alarm nothing moves any more
  };
  using Queue = RealtimeQueue<Slot*>;

  void run() noexcept;
  void exchange(Slot& slot) noexcept;
  bool can_write_next() const noexcept;
  void write(Slot& slot);

  hal::Backend& backend_;
  std::int64_t period_;  // ns
  RowSink* row_sink_;
  Contour* contour_ = nullptr;
  Queue to_do_;
  BoundedQueue<Slot*> done_;
  std::vector<Slot> slots_;
  std::vector<Slot*> free_;
  std::deque<Slot*> back_;  // exchanged, and not yet written
  bool wanted_ = true;
  std::int64_t written_ = 0;
  Setpoint last_;
  Feedback feedback_;
  bool alarmed_ = false;  // of the thread
  std::atomic<bool> stopping_{false};
  Punctuality punctuality_;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace softcnc::runtime
