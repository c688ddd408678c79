// SPDX-License-Identifier: MIT
// A parallel port with a machine: writes the registers that change, interprets the inputs.
#pragma once

#include <memory>
#include <optional>

#include "hal/ports/port_pins.hpp"
#include "hal/ports/port_registers.hpp"

namespace softcnc::hal {

class PortOutput {
 public:
  PortOutput(std::unique_ptr<PortRegisters> registers, const Machine& machine);
  PortOutput(const PortOutput&) = delete;
  PortOutput& operator=(const PortOutput&) = delete;
  ~PortOutput() { rest(); }

  const PortPins& pins() const noexcept { return pins_; }

  /// Writes the registers that change in the next base period. Alarm::port, or none. Realtime.
  Alarm write(const PortWord& word) noexcept;
  /// The same with the last word once more: charge pump and the signal of the spindle go on.
  Alarm write_again() noexcept;

  /// Reads the inputs, if any are used: what they stop, and what inputs() then returns. Realtime.
  Alarm look() noexcept;
  const InputLevels& inputs() const noexcept { return inputs_; }

  /// Sets steps low and disables the drives, whatever was written before. Safe in signal handlers.
  void rest() noexcept;

  /// Returns the diagnostic of an alarm.
  Diagnostic diagnostic(Alarm alarm) const;

 private:
  std::unique_ptr<PortRegisters> registers_;
  PortPins pins_;
  std::string device_;
  InputLevels inputs_;
  PortWord word_;                 // as it was given
  std::int64_t tick_ = 0;         // the next base period
  std::optional<PortWord> last_;  // as it was written
};

}  // namespace softcnc::hal
