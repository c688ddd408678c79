// SPDX-License-Identifier: MIT
// The registers of a PC's parallel port (82C55 style), real or simulated.
#pragma once

#include <cstdint>
#include <optional>

#include "motion/core/result.hpp"

namespace softcnc::hal {

/// Bits as they stand in the registers. Any call may fail, and all after it; failure() says why.
class PortRegisters {
 public:
  virtual ~PortRegisters() = default;

  /// Pins 2 to 9 are bits 0 to 7. Realtime.
  virtual bool write_data(std::uint8_t bits) noexcept = 0;
  /// Pins 1, 14, 16, 17 are bits 0 to 3; all but 16 are inverted on their way. Realtime.
  virtual bool write_control(std::uint8_t bits) noexcept = 0;
  /// Pins 15, 13, 12, 10, 11 are bits 3 to 7; 11 is inverted on its way. Realtime.
  virtual std::optional<std::uint8_t> read_status() noexcept = 0;

  /// Why a call failed: SC6074.
  virtual Diagnostic failure() const = 0;
};

}  // namespace softcnc::hal
