// SPDX-License-Identifier: MIT
// A thread of its own writes to a parallel port, a word each base period by the clock.
#pragma once

#include <atomic>
#include <memory>
#include <thread>

#include "hal/port_output.hpp"
#include "hal/port_player.hpp"
#include "hal/port_timing.hpp"
#include "realtime.hpp"
#include "word_ring.hpp"

namespace softcnc::app {

/// Words wait in a ring of half a second, and motion begins when that is half full, or all there is
/// has come. An alarm, a port that fails, a period missed (SC5030) and the end, also by a signal
/// that ends softcnc: the port is put at rest first.
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

  /// The port at rest, at once; nothing is written any more. For signal handlers.
  void abandon() noexcept;

 private:
  PacedPlayer(const Machine& machine, std::unique_ptr<hal::PortRegisters> registers);

  void run() noexcept;
  Alarm play_all() noexcept;
  bool may_move() const noexcept;
  Alarm write_next(bool& moves) noexcept;
  bool all_played() const noexcept { return ring_.taken() == rest_at_.load(); }

  hal::PortTiming timing_;
  std::int64_t tolerance_;      // ns: later than this is an overrun
  std::int64_t ticks_to_look_;  // from one look at the inputs to the next
  std::uint64_t lead_;          // words
  hal::PortOutput output_;
  WordRing ring_;
  std::atomic<std::uint64_t> rest_at_{0};  // words after which it may stand
  std::atomic<bool> finishing_{false}, abandoned_{false}, ended_{false};
  std::atomic<Alarm> alarm_{Alarm::none};
  RealtimeRights rights_;
  std::thread thread_;  // the last: it uses all others
};

}  // namespace softcnc::app
