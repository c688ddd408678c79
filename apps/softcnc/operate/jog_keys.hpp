// SPDX-License-Identifier: MIT
// What a jog key does that may be pressed, held, or come late through a network.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "operate/key.hpp"

namespace softcnc::app {

/// A terminal tells of presses only, and of a held key that it repeats. One press is a step; from
/// the second repeat on the motion is continuous, and it ends once no repeat has come for
/// kPatience. Keys that come faster than a hand presses them, as through a connection that has
/// stood still, are one press.
class JogKeys {
 public:
  enum class Act : std::uint8_t { nothing, step, begin, stop };

  static constexpr double kPatience = 0.13;    // s: to rest well within 150 ms
  static constexpr double kFirstRepeat = 0.8;  // s: until a held key repeats for the first time

  /// Takes a jog key at the instant `now`, s.
  Act press(Key::Kind key, double now) noexcept;
  /// Any other key was pressed, or the motion has ended otherwise.
  Act release() noexcept;
  /// Time goes on to `now`, s.
  Act wait(double now) noexcept;

  bool is_continuous() const noexcept { return continuous_; }

 private:
  std::optional<Key::Kind> key_;
  double last_ = -std::numeric_limits<double>::infinity();  // s: of its last press
  bool repeats_ = false;  // that press may have been the first repeat of a held key
  bool continuous_ = false;
};

}  // namespace softcnc::app
