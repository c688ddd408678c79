// SPDX-License-Identifier: MIT
// The parts of the state that an error has left open.
#pragma once

#include <cstdint>

#include "ipr/text/small_set.hpp"

namespace softcnc::ipr {

/// A part of what lasts from line to line. An error leaves open what its line would have done to
/// some of them; a code that sets a part again makes it known.
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
  shift,        // offsets of all work systems: G10 L2 and L20, G52, G92
  tool_data,    // lengths and radii of tools: G10 L1, L10 to L13
  saved_modes,  // M70, M73
  x,            // the position along each axis
  y,
  z,
  cycle_words,  // what a canned cycle keeps from hole to hole
  tangent,      // at the end of G05, where a G05 without I and J goes on
  polar,        // G15, G16
  mirror,       // G50.1, G51.1
  scaling,      // G50, G51
  rotation,     // G68, G69
  end,          // whether the program has ended: M02, M30
};

/// A set of parts. The one rule of errors: an operation with an unknown operand makes what it would
/// have set unknown, and reports nothing.
class Unknown : public SmallSet<Unknown, Part> {
 public:
  using SmallSet::SmallSet;
};

inline constexpr Unknown kPosition{Part::x, Part::y, Part::z};
/// The parts between programmed and machine coordinates.
inline constexpr Unknown kOffsets{Part::tool_length, Part::work_system, Part::shift,
                                  Part::mirror,      Part::scaling,     Part::rotation};
/// The parts by which a programmed coordinate is read.
inline constexpr Unknown kCoordinates = kOffsets | Unknown{Part::units, Part::distance};
inline constexpr Unknown kEverything = Unknown::up_to(Part::end);

/// Returns the part that is the position along an axis; 0 is X.
constexpr Part position_part(int axis) noexcept {
  return static_cast<Part>(static_cast<int>(Part::x) + axis);
}

}  // namespace softcnc::ipr
