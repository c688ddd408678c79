// SPDX-License-Identifier: MIT
// The registers of a PC's parallel port (82C55 style), real or simulated.
#pragma once

#include <cstdint>
#include <optional>

#include "motion/core/result.hpp"

namespace softcnc::hal {

/// The registers of a port, by their bits. Any call may fail, and then all after it; failure() says
/// why.
class PortRegisters {
 public:
  virtual ~PortRegisters() = default;

  /// Writes the data register; pins 2 to 9 are bits 0 to 7. Returns false after a failure.
  /// Realtime.
  virtual bool write_data(std::uint8_t bits) noexcept = 0;
  /// Writes the control register; pins 1, 14, 16 and 17 are bits 0 to 3, and all but 16 are
  /// inverted by the port. Returns false after a failure. Realtime.
  virtual bool write_control(std::uint8_t bits) noexcept = 0;
  /// Returns the status register; pins 15, 13, 12, 10 and 11 are bits 3 to 7, and 11 is inverted by
  /// the port. Returns nothing after a failure. Realtime.
  virtual std::optional<std::uint8_t> read_status() noexcept = 0;

  /// Returns why a call failed: SC6074.
  virtual Diagnostic failure() const = 0;
};

}  // namespace softcnc::hal
