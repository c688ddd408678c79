// SPDX-License-Identifier: MIT
// A parallel port that remembers what was written to it, and reads and fails as it is set.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <vector>

#include "hal/ports/port_registers.hpp"

namespace softcnc::test {

/// What stays when the port is gone.
struct PortRecord {
  struct Write {
    bool control;
    std::uint8_t bits;
    std::int64_t tick;
    bool operator==(const Write&) const = default;
  };

  std::vector<Write> writes;
  std::int64_t tick = 0;  // whoever plays the port counts it
  std::atomic<std::uint8_t> status{0};
  std::atomic<bool> fails{false};

  std::uint8_t last(bool control) const {
    for (auto write = writes.rbegin(); write != writes.rend(); ++write)
      if (write->control == control) return write->bits;
    return 0xFF;
  }
};

class RecordedPort final : public hal::PortRegisters {
 public:
  explicit RecordedPort(PortRecord& record) : record_(record) {}

  bool write_data(std::uint8_t bits) noexcept override { return write(false, bits); }
  bool write_control(std::uint8_t bits) noexcept override { return write(true, bits); }
  std::optional<std::uint8_t> read_status() noexcept override {
    return record_.fails ? std::nullopt : std::optional<std::uint8_t>(record_.status);
  }
  Diagnostic failure() const override { return {Code::SC6074, {}, "it was told to", "port", {}}; }

 private:
  bool write(bool control, std::uint8_t bits) {
    if (record_.fails) return false;
    record_.writes.push_back({control, bits, record_.tick});
    return true;
  }

  PortRecord& record_;
};

}  // namespace softcnc::test
