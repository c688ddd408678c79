// SPDX-License-Identifier: MIT
// The writer of words to a port, one each base period.
#pragma once

#include <span>

#include "hal/ports/port_pins.hpp"
#include "motion/core/result.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

class PortPlayer {
 public:
  virtual ~PortPlayer() = default;

  /// Takes the words of further base periods; may wait until the queue has room. Returns what has
  /// gone wrong so far: Alarm::port, overrun, emergency_stop, limit_switch or driver_fault.
  virtual Alarm play(std::span<const PortWord> words) noexcept = 0;

  /// Marks that the words so far end at rest, and that more may take long.
  virtual void rest() noexcept = 0;

  /// Returns when all has been played and the port is at rest. Errors: SC6074, SC5030 to SC5033.
  virtual Status finish() = 0;
};

}  // namespace softcnc::hal
