// SPDX-License-Identifier: MIT
// The modes that M70 saves and M72 restores: those of RS274 but the motion code.
#pragma once

#include <cstdint>
#include <optional>

#include "ipr/codes/transformation.hpp"
#include "motion/geometry/arc.hpp"
#include "motion/model/block.hpp"

namespace softcnc::ipr {

/// The meaning of F: G94, G93, G95.
enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_turn };

/// The cutter compensation that G41 and G42 ask for.
struct CutterSide {
  int side = 1;       // 1: the tool runs left of the contour, -1: right of it
  double radius = 0;  // mm, from 0; at 0 moves stay as they are
  Plane plane = Plane::xy;
  bool square_entry = false;  // FANUC: a first line leads to the beginning of the next move

  friend bool operator==(const CutterSide&, const CutterSide&) = default;
};

/// The modes; new Modes are those at the start of a program.
struct Modes {
  Plane plane = Plane::xy;
  double mm_per_unit = 1;  // of programmed lengths
  bool incremental = false;
  bool absolute_centres = false;  // G90.1
  PathMode path_mode = PathMode::follow;
  double corner_tolerance = 0, chord_tolerance = 0;  // mm: of G64
  bool exact_path = false;                           // G61 or G61.1
  FeedMode feed_mode = FeedMode::per_minute;
  double feed = 0;                      // mm/s; 0: not set
  double feed_word = 0;                 // G93: 1/min; G95: mm per turn; 0: not set
  bool zero_feed = false;               // the feed is not set since F was 0
  bool feed_override = true;            // off: M49, M50 P0, and within taps
  bool speed_override = true;           // off: M49, M51 P0, and within taps; there is none
  double adaptive_feed = 1;             // of M52 P1: the feed is multiplied by it
  std::optional<double> spindle_speed;  // rpm, as programmed by S, within the machine's range
  int spindle_direction = 0;            // 1: M03, -1: M04, 0: at rest
  bool mist = false, flood = false;     // coolant
  AxisVector tool_offset = AxisVector::Zero();  // mm: of G43, in force
  int length_number = 0;                        // H last used
  bool length_on = false;                       // G43 and its like
  std::optional<int> radius_number;             // D last used; unset: none was
  std::optional<bool> retract_to_r;             // G99; G98: false; unset: as the dialect has it
  std::optional<CutterSide> cutter;             // G41, G42, as programmed
  bool polar = false;                           // G16
  Transformation transformation;                // G51.1, G51, G68
};

}  // namespace softcnc::ipr
