// SPDX-License-Identifier: MIT
// Setpoints that are planned ahead of their instants, and the rows that come back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hal/backends/backend.hpp"
#include "runtime/realtime/bounded_queue.hpp"
#include "runtime/realtime/realtime_queue.hpp"

namespace softcnc::runtime {

/// Half a second of setpoints waits until each is exchanged with the backend, at its instant, by
/// whoever drives the queue: a real-time thread, or a test. Those that wait can be taken back.
class SetpointQueue {
 public:
  /// The backend must outlive it, and nobody else may touch it until all rows are back.
  SetpointQueue(hal::Backend& backend, double period);
  SetpointQueue(const SetpointQueue&) = delete;
  SetpointQueue& operator=(const SetpointQueue&) = delete;
  virtual ~SetpointQueue() = default;

  /// Returns how many setpoints can be added.
  std::size_t capacity_left() const noexcept;
  /// Adds a setpoint; requires capacity_left(). Returns the feedback of the last row that has been
  /// collected.
  Feedback exchange(const Setpoint& setpoint) noexcept;
  /// Marks that the setpoints so far end at rest, and that more may take long.
  void rest() noexcept { to_do_.rest(); }

  /// A setpoint that has been exchanged.
  struct Row {
    const Setpoint& setpoint;
    std::span<const double> values;      // of row_columns(), without what the backend cannot know
    std::span<const AxisVector> actual;  // Backend::actual()
    const Feedback& feedback;
  };
  /// Calls take(row) for the rows that are back, at most so many. Those that come behind an alarm
  /// have not been exchanged, and are left out.
  template <typename Take>
  void collect(std::size_t most, Take&& take) {
    for (Slot* slot = nullptr; most > 0 && done_.take(slot); --most) {
      free_.push_back(slot);
      if (!slot->exchanged) continue;
      feedback_ = slot->feedback;
      take(Row{slot->setpoint, slot->values, slot->actual, slot->feedback});
    }
  }
  /// Returns how many setpoints are back, and whether all of them are, or have been collected.
  std::size_t back() const noexcept { return done_.pushed() - done_.taken(); }
  bool all_back() const noexcept { return free_.size() + back() == slots_.size(); }

  /// Lets time pass in which setpoints may be exchanged.
  virtual void wait() noexcept = 0;
  /// Ends whoever drives the queue: no setpoint comes any more.
  virtual void stop() noexcept {}

  /// A place in the queue: that behind `last`.
  struct Cut {
    std::uint32_t number;
    Setpoint last;  // without pulses and fine points
  };
  /// Returns the place that is reached `ahead` s from now, but none before the setpoint of
  /// `period`, or else the end; nothing if no setpoint waits.
  std::optional<Cut> cut_in(double ahead, std::int64_t period) const noexcept;
  /// Returns how many setpoints are behind a place.
  std::size_t count_after(const Cut& cut) const noexcept {
    return to_do_.load().pushed - cut.number;
  }
  /// Takes back the setpoints behind a place, while there is time left to add others; false, and
  /// all stays, if there is not. Always succeeds at the end.
  bool take_back(const Cut& cut) noexcept;

 protected:
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

  /// Takes the next setpoint, for the one who drives the queue, who then plays it. Realtime.
  Queue::Next take(Slot*& slot) noexcept { return to_do_.take(slot); }
  /// Exchanges a setpoint with the backend. Realtime.
  void play(Slot& slot) noexcept;

 private:
  hal::Backend& backend_;
  double period_;  // s
  Queue to_do_;
  std::vector<Slot> slots_;
  BoundedQueue<Slot*> done_;
  std::vector<Slot*> free_;
  Feedback feedback_;
  bool alarmed_ = false;  // of the one who plays
};

}  // namespace softcnc::runtime
