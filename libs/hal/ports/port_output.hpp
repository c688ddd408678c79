// SPDX-License-Identifier: MIT
// A parallel port with a machine on it: what changes is written, what comes in is understood.
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

  /// Writes the registers that change. Alarm::port, or none. Realtime.
  Alarm write(const PortWord& word) noexcept;

  /// What the inputs say, if any are used. Realtime.
  Alarm look() noexcept;

  /// Steps low, drives disabled, whatever has been written before. For signal handlers, too.
  void rest() noexcept;

  /// An alarm in words.
  Diagnostic diagnostic(Alarm alarm) const;

 private:
  std::unique_ptr<PortRegisters> registers_;
  PortPins pins_;
  std::string device_;
  std::optional<PortWord> last_;
};

}  // namespace softcnc::hal
