// SPDX-License-Identifier: MIT
// A key that an operator presses.
#pragma once

#include <cstdint>

namespace softcnc::app {

struct Key {
  enum class Kind : std::uint8_t {
    character,  // a printable one
    up,
    down,
    left,
    right,
    page_up,
    page_down,
    home,
    end,
    enter,
    escape,
    backspace,
    delete_,
    interrupt,  // Ctrl-C
    unknown,
  };

  Kind kind = Kind::unknown;
  char character = 0;

  friend bool operator==(const Key&, const Key&) = default;
};

/// Returns the key of a printable character.
constexpr Key key_of(char character) noexcept { return {Key::Kind::character, character}; }

}  // namespace softcnc::app
