// SPDX-License-Identifier: MIT
// The writer of words to a port, one each base period.
#pragma once

#include <cstdint>
#include <span>

#include "hal/ports/port_pins.hpp"
#include "motion/core/result.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// The inputs from the base period on that follows so many words since the player began, or has
/// recovered.
struct PortChange {
  std::int64_t words = 0;
  InputLevels inputs;
};

class PortPlayer {
 public:
  virtual ~PortPlayer() = default;

  /// Takes the words of further base periods; may wait until the queue has room. Returns what has
  /// gone wrong so far: Alarm::port, overrun, emergency_stop, limit_switch or driver_fault.
  virtual Alarm play(std::span<const PortWord> words) noexcept = 0;

  /// Marks that the words so far end at rest, and that more may take long.
  virtual void rest() noexcept = 0;

  /// Returns how many s of words may wait.
  virtual double ahead() const noexcept = 0;
  /// From now on words come no more than `lead` s before they are due.
  virtual void follow(double lead) noexcept = 0;
  /// Takes the next change of the inputs; false where there is none.
  virtual bool next_change(PortChange& change) noexcept = 0;
  /// Returns what has ended the player, or Alarm::none, and describes it.
  virtual Alarm alarm() const noexcept = 0;
  virtual Diagnostic trouble() const = 0;
  /// Begins again after an alarm, without what has waited. Errors: SC5031 to SC5033 where an input
  /// is still on, SC6074.
  virtual Status recover() = 0;

  /// Returns when all has been played and the port is at rest. Errors: SC6074, SC5030 to SC5033.
  virtual Status finish() = 0;
};

}  // namespace softcnc::hal
