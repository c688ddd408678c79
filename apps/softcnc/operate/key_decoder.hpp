// SPDX-License-Identifier: MIT
// From the bytes of a terminal to keys.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "operate/key.hpp"

namespace softcnc::app {

/// Arrows and the like are sequences that begin with the byte of Esc, and may come in pieces
/// through a slow connection; one that is not known is an unknown key, as a whole. The byte of Esc
/// alone is Esc once nothing has followed it for kPatience.
class KeyDecoder {
 public:
  static constexpr double kPatience = 0.15;  // s

  /// Takes bytes that have come at the instant `now`, s, and returns the keys that are whole.
  std::vector<Key> take(std::string_view bytes, double now);
  /// Time goes on to `now`, s; returns Esc where it was that.
  std::optional<Key> wait(double now) noexcept;

 private:
  enum class State : std::uint8_t { plain, escape, sequence, letter };

  std::optional<Key> take_byte(unsigned char byte);

  State state_ = State::plain;
  std::string sequence_;  // after ESC [
  double since_ = 0;      // s: of its last byte
};

}  // namespace softcnc::app
