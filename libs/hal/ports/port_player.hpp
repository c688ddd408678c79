// SPDX-License-Identifier: MIT
// Who writes words to a port, one each base period.
#pragma once

#include <span>

#include "hal/ports/port_pins.hpp"
#include "motion/core/result.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

class PortPlayer {
 public:
  virtual ~PortPlayer() = default;

  /// Takes the words of further base periods; may wait until there is room. What has been wrong so
  /// far: Alarm::port, overrun, emergency_stop, limit_switch or driver_fault.
  virtual Alarm play(std::span<const PortWord> words) noexcept = 0;

  /// The words so far end at rest, and more may be long in coming.
  virtual void rest() noexcept = 0;

  /// Returns when all has been played and the port is at rest. Errors: SC6074, SC5030 to SC5033.
  virtual Status finish() = 0;
};

}  // namespace softcnc::hal
