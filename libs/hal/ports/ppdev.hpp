// SPDX-License-Identifier: MIT
// A parallel port through Linux' ppdev.
#pragma once

#include <memory>
#include <string>

#include "hal/ports/port_registers.hpp"

namespace softcnc::hal {

class Ppdev final : public PortRegisters {
 public:
  /// Claims the port for itself alone. Errors: SC6072, SC6073 (in use).
  static Result<std::unique_ptr<Ppdev>> open(const std::string& device);

  Ppdev(const Ppdev&) = delete;
  Ppdev& operator=(const Ppdev&) = delete;
  ~Ppdev() override;

  bool write_data(std::uint8_t bits) noexcept override;
  bool write_control(std::uint8_t bits) noexcept override;
  std::optional<std::uint8_t> read_status() noexcept override;
  Diagnostic failure() const override;

 private:
  Ppdev(std::string device, int descriptor);
  bool call(unsigned long request, void* argument) noexcept;

  std::string device_;
  int descriptor_;
  bool claimed_ = false;
  int error_ = 0;  // errno of the first call that failed
};

/// Returns what a refusal by the system means, by its errno: SC6072, SC6073.
Diagnostic port_refusal(const std::string& device, const char* call, int error);

}  // namespace softcnc::hal
