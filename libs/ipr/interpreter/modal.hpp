// SPDX-License-Identifier: MIT
// What stays in force from line to line: modes, position, and a NURBS whose lines are still coming.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ipr/codes/gcode_table.hpp"
#include "ipr/codes/modes.hpp"
#include "ipr/interpreter/coordinates.hpp"
#include "ipr/text/letter_set.hpp"
#include "motion/geometry/nurbs.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

/// Where a curve over several lines began.
struct CurveHead {
  double feed = 0;   // mm/s
  SourcePos source;  // of its first line
  SourcePos word;    // its code
  std::string line;  // its text
};

/// A curve over several lines whose end is still to come, and what errors leave of it.
struct OpenCurve {
  CurveHead head;
  bool broken = false;     // something in it was reported: no block is made
  bool misshapen = false;  // what was reported is its shape: only its points are what they were
  Letters lost_axes;       // along which not all of its points are known
};

inline constexpr Letters kWordsOfCurveBlocks{"KR"};  // of G06.2, beside the axes

/// A curve of G06.2 between its first block and its last closing knot.
struct PendingCurve : OpenCurve {
  NurbsSpec spec;                // what has been read so far
  int order = 0;                 // 0: P was bad, and the end of the curve is not known
  int closing_knots = 0;         // read so far
  Letters axes;                  // of the curve; empty until a block names one
  bool knots_uncertain = false;  // its knots have been told: of them, only falls still are
  bool disordered = false;       // where its knots belong is not known: not even those are
  std::optional<double> knot;    // the last one that the next may not fall below
  bool full = false;             // it has been told that there are too many points
  bool repeats = false;          // LinuxCNC's form: G06.2 in its second block too
  double order_word = 0;         // P as written; 0: left out
  bool knotless = false;         // its first block lacks its knot, or has another code: told
  bool knot_told = false;        // of its last block another word, which may stand for it
  bool headless = false;         // points before its first may be those of a curve that was left
};

/// A curve of G05.2 or G06.1, whose points are still coming.
struct PendingPoints : OpenCurve {
  const GCode* code = nullptr;
  int order = 0;                   // of G05.2; 0: L was bad
  std::vector<AxisVector> points;  // mm, machine coordinates; the first is where it begins
  std::vector<double> weights;     // of G05.2
  int blocks = 0;                  // that named a point
};

/// The end of a curve of G05: the next one may go on from it without a bend.
struct CurveEnd {
  AxisVector position;  // mm, machine coordinates
  AxisVector handle;    // mm: from there to the first control point of the curve that goes on
  Plane plane;          // in which it lies
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
  Letters told;      // of which it has been told that they are missing or wrong
};

/// What M70 or M73 has saved.
struct SavedModes {
  Modes modes;
  int work_system = 0;  // index, of G54 to G59.3
  bool shift_on = false;
  Letters uncertain;  // as of Modal
  bool offsets_uncertain = false;
  bool automatic = false;  // by M73: the end of the call restores them
  bool lost = false;       // by what may have been M73: behind the call nobody knows the modes
};

/// Modes that the end of a call has restored, and nobody was told yet.
struct Restored {
  Modes before;
  SourcePos pos;  // of the end of the call
};

/// What a coordinate means.
inline constexpr Groups kOfCoordinates{Group::units, Group::distance};

/// The start state is that of a new Modal.
struct Modal : Modes {
  AxisVector position = AxisVector::Zero();     // mm, machine coordinates: the end of the last move
  MachineState state;                           // offsets and what else outlives the program
  AxisVector local_shift = AxisVector::Zero();  // mm: of G52 in the fanuc dialect
  AxisVector shift_of_g52 = AxisVector::Zero();  // mm: in linuxcnc, what of the shift G52 has set
  Coordinates coordinates;                       // made of these by update_coordinates()
  /// What the other dialect goes by, once an offset has been assigned to.
  std::optional<Coordinates> coordinates_there;
  bool machine_coordinates = false;     // on this line: G53
  bool stops_once = false;              // on this line: G09
  const GCode* motion = nullptr;        // the motion code in force
  const GCode* motion_below = nullptr;  // G00 to G03: in force but for a cycle
  std::optional<int> tool;              // as selected by T
  std::optional<int> loaded_tool;       // in the spindle
  std::optional<Beside> beside;
  std::optional<PendingCurve> curve;
  std::optional<PendingPoints> points;
  std::optional<CurveEnd> curve_end;
  std::optional<Surface> surface;  // of G06.4
  CycleWords cycle;
  std::vector<std::optional<SavedModes>> saved{1};  // by level of calls
  std::optional<Restored> restored;

  /// Words whose value an error has made uncertain (G: the motion code). What would be wrong only
  /// because of them is not reported.
  Letters uncertain;

  /// Groups of which an error has left open what is in force. The same holds for these.
  Groups doubted;

  /// An offset is wrong by an error: where the machine is in its own coordinates does not tell
  /// where it is in those of the program.
  bool offsets_uncertain = false;
  Letters doubted_axes;          // along which
  bool start_uncertain = false;  // where the machine was before the line is not known
  Letters end_in_doubt;          // of the last arc: axes along which it may be what is wrong
  bool centre_told = false;      // that the arcs of the code in force have none
  Letters across_told;           // of arcs across the plane in force, which may be what is wrong

  /// A curve that was left too early, which has been told: words that only its blocks have. Blocks
  /// of it that follow are not told for that.
  Letters words_of_left_curve;
  bool left_curve_may_go_on = false;  // by G06.2 in its next block, in LinuxCNC's form

  // Told once a file.
  bool feed_warned = false, spindle_warned = false, dwell_warned = false, peck_warned = false;
  bool look_ahead_told = false, chopping_told = false, order_told = false;
  bool rest_told = false;  // once a G06.4: that the spindle rests
  bool ended = false;      // M02 or M30 was read

  const WorkOffset& work() const noexcept {
    return state.work[static_cast<std::size_t>(state.active)];
  }
  AxisVector shift() const noexcept {
    return state.shift_on ? AxisVector(state.shift + local_shift) : local_shift;
  }
  /// After a change of an offset. The position of the machine stays.
  void update_coordinates() noexcept {
    coordinates = Coordinates(work(), shift(), tool_offset);
    coordinates_there.reset();
  }
  /// After an assignment to an offset, which counts at once or when coordinates are updated next.
  void assign_offset(bool at_once) noexcept {
    const Coordinates assigned(work(), shift(), tool_offset);
    if (!coordinates_there) coordinates_there = coordinates;
    (at_once ? coordinates : *coordinates_there) = assigned;
  }

  void doubt(Groups groups) noexcept {
    doubted |= groups;
    if (groups.has_any({Group::work_offset, Group::tool_length, Group::non_modal})) doubt_offsets();
    if (groups.has_any(kOfCoordinates)) uncertain |= kAxisWords;
  }
  void doubt_offsets(Letters axes = kAxisWords) noexcept {
    offsets_uncertain = true;
    uncertain |= kAxisWords;
    doubted_axes |= axes;
  }
  /// Where the machine is along these is not known.
  Letters unknown_axes() const noexcept {
    Letters unknown = doubted_axes;
    unknown |= uncertain;
    return coordinates.rotated() && unknown.has_any(kAxisWords) ? Letters(kAxisWords) : unknown;
  }
};

}  // namespace softcnc::ipr
