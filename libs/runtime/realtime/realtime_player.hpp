// SPDX-License-Identifier: MIT
// A thread that writes to a parallel port in real time, one word each base period.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "hal/ports/port_output.hpp"
#include "hal/ports/port_player.hpp"
#include "hal/ports/port_timing.hpp"
#include "motion/core/diagnostic.hpp"
#include "runtime/realtime/bounded_queue.hpp"
#include "runtime/realtime/realtime.hpp"
#include "runtime/realtime/realtime_queue.hpp"

namespace softcnc::runtime {

/// Words wait in a queue. After an alarm, a failure of the port, a missed period
/// (SC5030), at the end and before a signal ends softcnc, the port is put at rest.
class RealtimePlayer final : public hal::PortPlayer {
 public:
  /// The one that the player keeps informed.
  struct Listener {
    /// Is called with the player before it can write to the port, and with null once it never will
    /// again: until then an end of softcnc calls abandon() first.
    std::function<void(RealtimePlayer*)> holds_port;
    /// Takes SC6075 where the system has refused the real-time rights.
    Diagnostics::Sink report;
  };

  /// Opens a player on the port of these registers, with a queue of `ahead` s: what waits there is
  /// written, whatever comes. Errors: SC5031 to SC5033 where an input is on.
  static Result<std::unique_ptr<RealtimePlayer>> open(const Machine& machine,
                                                      std::unique_ptr<hal::PortRegisters> registers,
                                                      Listener listener, double ahead);

  RealtimePlayer(const RealtimePlayer&) = delete;
  RealtimePlayer& operator=(const RealtimePlayer&) = delete;
  ~RealtimePlayer() override;

  Alarm play(std::span<const hal::PortWord> words) noexcept override;
  void rest() noexcept override;
  double ahead() const noexcept override { return ahead_; }
  void follow(double lead) noexcept override;
  bool next_change(hal::PortChange& change) noexcept override { return changes_.take(change); }
  Alarm alarm() const noexcept override { return alarm_; }
  Diagnostic trouble() const override { return output_.diagnostic(alarm_); }
  Status recover() override;
  Status finish() override;

  /// Puts the port at rest as soon as the present word is out, and writes nothing more. For signal
  /// handlers.
  void abandon() noexcept;

 private:
  static constexpr std::size_t kChanges = 4096;  // that wait to be taken; more are left out

  RealtimePlayer(const Machine& machine, std::unique_ptr<hal::PortRegisters> registers,
                 Listener listener, double ahead);

  Status start();
  void run() noexcept;
  Alarm play_all() noexcept;
  Alarm look() noexcept;
  Alarm write_next() noexcept;

  hal::PortTiming timing_;
  std::int64_t tolerance_;  // ns: later than this is an overrun
  double ahead_, lead_;     // s
  hal::PortOutput output_;
  std::optional<RealtimeQueue<hal::PortWord>> words_;
  std::int64_t written_ = 0;  // of them
  BoundedQueue<hal::PortChange> changes_{kChanges};
  hal::InputLevels seen_;  // the last change that was pushed
  std::atomic<bool> finishing_{false}, abandoned_{false}, ended_{false};
  std::atomic<Alarm> alarm_{Alarm::none};
  RealtimeRights rights_;
  Listener listener_;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace softcnc::runtime
