// SPDX-License-Identifier: MIT
// A thread of its own writes to a parallel port, a word each base period by the clock.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "hal/ports/port_output.hpp"
#include "hal/ports/port_player.hpp"
#include "hal/ports/port_timing.hpp"
#include "realtime/realtime.hpp"
#include "realtime/realtime_queue.hpp"

namespace softcnc::app {

/// Words wait in a queue of half a second. An alarm, a port that fails, a period missed (SC5030)
/// and the end, also by a signal that ends softcnc: the port is put at rest first.
class PacedPlayer final : public hal::PortPlayer {
 public:
  /// On the port of the machine. Errors: those of hal::Ppdev::open(); SC5031 to SC5033 where an
  /// input is on.
  static Result<std::unique_ptr<hal::PortPlayer>> open(const Machine& machine);
  static Result<std::unique_ptr<PacedPlayer>> open(const Machine& machine,
                                                   std::unique_ptr<hal::PortRegisters> registers);

  PacedPlayer(const PacedPlayer&) = delete;
  PacedPlayer& operator=(const PacedPlayer&) = delete;
  ~PacedPlayer() override;

  Alarm play(std::span<const hal::PortWord> words) noexcept override;
  void rest() noexcept override;
  Status finish() override;

  /// The port at rest, as soon as the word being written is out; nothing is written any more. For
  /// signal handlers.
  void abandon() noexcept;

 private:
  PacedPlayer(const Machine& machine, std::unique_ptr<hal::PortRegisters> registers);

  void run() noexcept;
  Alarm play_all() noexcept;
  Alarm write_next() noexcept;

  hal::PortTiming timing_;
  std::int64_t tolerance_;      // ns: later than this is an overrun
  std::int64_t ticks_to_look_;  // from one look at the inputs to the next
  hal::PortOutput output_;
  PacedQueue<hal::PortWord> words_;
  std::atomic<bool> finishing_{false}, abandoned_{false}, ended_{false};
  std::atomic<Alarm> alarm_{Alarm::none};
  RealtimeRights rights_;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace softcnc::app
