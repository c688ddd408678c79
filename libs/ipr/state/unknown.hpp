// SPDX-License-Identifier: MIT
// The parts of the state that an error has left open.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace softcnc::ipr {

/// A part of what lasts from line to line. An error leaves open what its line would have done to
/// some of them; a code that sets a part anew makes it known again.
enum class Part : std::uint8_t {
  motion,       // the motion code in force, or whether a curve over several lines is open
  plane,        // G17 to G19
  units,        // G20, G21
  distance,     // G90, G91
  centres,      // G90.1, G91.1
  feed_mode,    // G93 to G95
  feed,         // F
  speed,        // S
  spindle,      // M03 to M05
  tool,         // T, and the tool in the spindle
  cutter,       // G40 to G42
  tool_length,  // G43, G49
  work_system,  // G54 to G59.3
  shift,        // offsets of all work systems, and what tables hold: G10, G52, G92
  saved_modes,  // M70, M73
  x,
  y,
  z,            // the position along each axis
  cycle_words,  // what a canned cycle keeps from hole to hole
  end,          // whether the program has ended: M02, M30
};

/// A set of parts. The one rule of errors: an operation with an unknown operand makes what it would
/// have set unknown, and reports nothing.
class Unknown {
 public:
  constexpr Unknown() = default;
  constexpr Unknown(std::initializer_list<Part> parts) noexcept {
    for (const Part part : parts) add(part);
  }

  constexpr void add(Part part) noexcept { bits_ |= bit(part); }
  constexpr void remove(Part part) noexcept { bits_ &= ~bit(part); }
  constexpr Unknown without(Unknown other) const noexcept {
    Unknown rest = *this;
    rest.bits_ &= ~other.bits_;
    return rest;
  }
  constexpr bool has(Part part) const noexcept { return (bits_ & bit(part)) != 0; }
  constexpr bool has_any(Unknown other) const noexcept { return (bits_ & other.bits_) != 0; }
  constexpr bool empty() const noexcept { return bits_ == 0; }
  constexpr Unknown& operator|=(Unknown other) noexcept {
    bits_ |= other.bits_;
    return *this;
  }

 private:
  static constexpr std::uint32_t bit(Part part) noexcept {
    return 1U << static_cast<unsigned>(part);
  }
  std::uint32_t bits_ = 0;
};

inline constexpr Unknown kPosition{Part::x, Part::y, Part::z};
/// What lies between programmed and machine coordinates.
inline constexpr Unknown kOffsets{Part::tool_length, Part::work_system, Part::shift};
/// What a programmed coordinate is read by.
inline constexpr Unknown kCoordinates{Part::units, Part::distance, Part::tool_length,
                                      Part::work_system, Part::shift};
inline constexpr Unknown kEverything{
    Part::motion,      Part::plane,       Part::units,       Part::distance, Part::centres,
    Part::feed_mode,   Part::feed,        Part::speed,       Part::spindle,  Part::tool,
    Part::cutter,      Part::tool_length, Part::work_system, Part::shift,    Part::saved_modes,
    Part::cycle_words, Part::x,           Part::y,           Part::z,        Part::end};

/// The position along an axis: 0 is X.
constexpr Part position_part(int axis) noexcept {
  return static_cast<Part>(static_cast<int>(Part::x) + axis);
}

}  // namespace softcnc::ipr
