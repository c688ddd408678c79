// SPDX-License-Identifier: MIT
// What stays in force from line to line: modes, position, and a NURBS whose lines are still coming.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ipr/coordinates.hpp"
#include "ipr/letters.hpp"
#include "motion/arc.hpp"
#include "motion/block.hpp"
#include "motion/machine_state.hpp"
#include "motion/nurbs.hpp"

namespace softcnc::ipr {

struct GCode;

/// Where a curve over several lines began.
struct CurveHead {
  double feed = 0;   // mm/s
  SourcePos source;  // of its first line
  SourcePos word;    // its code
  std::string line;  // its text
};

/// A curve of G06.2 between its first block and its last closing knot.
struct PendingCurve {
  NurbsSpec spec;                // what has been read so far
  int order = 0;                 // 0: P was bad, and the end of the curve is not known
  int closing_knots = 0;         // read so far
  Letters axes;                  // of the curve; empty until a block names one
  bool broken = false;           // something in it was reported: no block is made
  bool knots_uncertain = false;  // the same for its knots: no more is said about them
  bool repeats = false;          // LinuxCNC's form: G06.2 in its second block too
  double order_word = 0;         // P as written; 0: left out
  CurveHead head;
};

/// A curve of G05.2 or G06.1, whose points are still coming.
struct PendingPoints {
  const GCode* code = nullptr;
  int order = 0;                   // of G05.2; 0: L was bad
  std::vector<AxisVector> points;  // mm, machine coordinates; the first is where it begins
  std::vector<double> weights;     // of G05.2
  int blocks = 0;                  // that named a point
  bool broken = false;             // something in it was reported: no block is made
  CurveHead head;
};

/// The end of a curve of G05: the next one may go on from it without a bend.
struct CurveEnd {
  AxisVector position;  // mm, machine coordinates
  AxisVector handle;    // mm: from there to the first control point of the curve that goes on
};

/// Where G40 has left the tool: beside the programmed position, until a move leads away.
struct Beside {
  AxisVector tool;  // mm, machine coordinates
  Plane plane;      // of the contour
};

/// Words of a canned cycle that stay in force with it: mm, s; as programmed.
struct CycleWords {
  std::optional<double> retract, bottom, dwell, peck;
  double start = 0;  // mm, programmed: the height before the first cycle of a row
};

/// What F means: G94, G93, G95.
enum class FeedMode : std::uint8_t { per_minute, inverse_time, per_turn };

/// The start state is that of a new Modal.
struct Modal {
  AxisVector position = AxisVector::Zero();     // mm, machine coordinates: the end of the last move
  MachineState state;                           // offsets and what else outlives the program
  AxisVector tool_offset = AxisVector::Zero();  // mm: of G43, in force
  AxisVector local_shift = AxisVector::Zero();  // mm: of G52 in the fanuc dialect
  Coordinates coordinates;                      // made of these by update_coordinates()
  bool machine_coordinates = false;             // on this line: G53
  const GCode* motion = nullptr;                // the motion code in force
  Plane plane = Plane::xy;
  double mm_per_unit = 1;  // of programmed lengths
  bool incremental = false;
  bool absolute_centres = false;  // G90.1
  Join join = Join::follow;
  double corner_tolerance = 0, chord_tolerance = 0;  // mm: of G64
  double feed = 0;                                   // mm/s; 0: not set
  bool feed_override = true;                         // off: M49, M50 P0
  FeedMode feed_mode = FeedMode::per_minute;
  double feed_word = 0;                 // G93: 1/min; G95: mm per turn; 0: not set
  std::optional<double> spindle_speed;  // rpm, as programmed by S, within the machine's range
  int spindle_direction = 0;            // 1: M03, -1: M04, 0: at rest
  std::optional<int> tool;              // as selected by T
  std::optional<int> loaded_tool;       // in the spindle
  int length_number = 0;                // H last used
  std::optional<Beside> beside;
  std::optional<PendingCurve> curve;
  std::optional<PendingPoints> points;
  std::optional<CurveEnd> curve_end;
  std::optional<Surface> surface;  // of G06.4
  CycleWords cycle;
  std::optional<bool> retract_to_r;  // G99; G98: false; unset: as the dialect has it

  /// Words whose value an error has made uncertain (G: the motion code). What would be wrong only
  /// because of them is not reported.
  Letters uncertain;

  /// An offset is wrong by an error: where the machine is in its own coordinates does not tell
  /// where it is in those of the program.
  bool offsets_uncertain = false;

  // Told once a file.
  bool feed_warned = false, spindle_warned = false, dwell_warned = false;
  bool look_ahead_told = false, chopping_told = false, order_told = false, surface_told = false;
  bool ended = false;  // M02 or M30 was read

  const WorkOffset& work() const noexcept {
    return state.work[static_cast<std::size_t>(state.active)];
  }
  AxisVector shift() const noexcept {
    return state.shift_on ? AxisVector(state.shift + local_shift) : local_shift;
  }
  /// After a change of an offset. The position of the machine stays.
  void update_coordinates() noexcept { coordinates = Coordinates(work(), shift(), tool_offset); }

  void doubt_offsets() noexcept {
    offsets_uncertain = true;
    uncertain |= kAxisWords;
  }
};

}  // namespace softcnc::ipr
