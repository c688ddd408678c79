// SPDX-License-Identifier: MIT
// Which bit of which register a pin of the 25-pole plug is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/signals/edge_sink.hpp"
#include "motion/model/machine.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::hal {

/// The bits of both registers that are written, as far as they do not depend on the base period,
/// and for how many base periods of its cycle the signal of the spindle's speed is high.
struct PortWord {
  std::uint8_t data = 0, control = 0;
  std::uint16_t speed = 0;
  bool operator==(const PortWord&) const = default;
};

bool is_data_pin(int pin);
bool is_output_pin(int pin);
bool is_input_pin(int pin);

/// The pins of a machine, its inversions and those of the port taken into account.
class PortPins {
 public:
  explicit PortPins(const Machine& machine);

  /// Returns the word with steps low, drives disabled, and all other outputs low.
  const PortWord& rest() const noexcept { return rest_; }
  /// The same with the drives enabled.
  PortWord enabled() const noexcept;

  /// Realtime.
  void set(PortWord& word, int axis, Wire wire, bool high) const noexcept;
  void set(PortWord& word, const Outputs& outputs) const noexcept;
  /// Returns the word as the base period `tick`, from 0, has charge pump and spindle speed.
  PortWord at(PortWord word, std::int64_t tick) const noexcept;

  /// Returns whether there is anything to see in the status register.
  bool looks() const noexcept;
  /// Returns what the status register means. Realtime.
  Alarm alarm(std::uint8_t status) const noexcept;
  InputLevels inputs(std::uint8_t status) const noexcept;

 private:
  /// A bit, and how it stands for high; no bit: no pin.
  struct Line {
    PortWord bit;
    PortWord high;
  };
  struct Input {
    std::uint8_t bit = 0, high = 0;
  };

  static Line line_of(int pin);
  static Input input_of(int pin);
  static bool is_high(const Input& input, std::uint8_t status) noexcept {
    return input.bit != 0 && (status & input.bit) == input.high;
  }
  static void put(PortWord& word, const Line& line, bool high) noexcept;

  std::array<std::array<Line, 2>, kAxes> lines_{};  // by axis and wire
  Line enable_, charge_pump_, spindle_, spindle_ccw_, spindle_pwm_, mist_, flood_;
  struct Output {
    int number;
    Line line;
  };
  std::vector<Output> outputs_;  // that programs set by number or name
  double max_rpm_;
  int pwm_levels_;
  Input estop_, limit_, fault_, probe_, door_;
  std::array<Input, kAxes> homes_;
  PortWord rest_;
};

}  // namespace softcnc::hal
