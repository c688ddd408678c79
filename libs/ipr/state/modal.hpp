// SPDX-License-Identifier: MIT
// What stays in force from line to line: modes, position, and a NURBS whose lines are still coming.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ipr/codes/gcode.hpp"
#include "ipr/codes/modes.hpp"
#include "ipr/state/coordinates.hpp"
#include "ipr/state/polar_point.hpp"
#include "ipr/state/simulated_inputs.hpp"
#include "ipr/state/unknown.hpp"
#include "ipr/text/letter_set.hpp"
#include "motion/geometry/nurbs.hpp"
#include "motion/geometry/spline.hpp"
#include "motion/model/contact.hpp"
#include "motion/model/machine_state.hpp"

namespace softcnc::ipr {

/// The beginning of a curve over several lines.
struct CurveHead {
  double feed = 0;   // mm/s
  SourcePos source;  // of its first line
  SourcePos word;    // its code
  std::string line;  // its text
};

/// A curve of G06.2 between its first block and its last closing knot.
struct PendingCurve {
  CurveHead head;
  NurbsSpec spec;  // what has been read so far
  int order = 0;
  int closing_knots = 0;  // read so far
  LetterSet axes;         // of the curve; empty until a block names one
  bool repeats = false;   // LinuxCNC's form: G06.2 in its second block too
  double order_word = 0;  // P as written; 0: left out
};

/// A curve of G05.2 or G06.1, whose points are still coming.
struct PendingPoints {
  CurveHead head;
  const GCode* code = nullptr;
  int order = 0;                   // of G05.2
  SplineParameter parameter{};     // of G06.1
  std::vector<AxisVector> points;  // mm, machine coordinates; the first is where it begins
  std::vector<double> weights;     // of G05.2
  int blocks = 0;                  // that named a point
};

/// The end of a curve of G05. The next one may go on from it without a jump of its direction.
struct CurveEnd {
  AxisVector position;  // mm, machine coordinates
  AxisVector handle;    // mm: from there to the first control point of the curve that goes on
  Plane plane;          // in which it lies
};

/// The transformation in force, as a map of machine coordinates: from where a point would be
/// without it to where it is.
struct Placement {
  AffineMap map;
  AxisVector reached;  // mm, machine coordinates: where the tool is
};

/// The place where G40 has left the tool: beside the programmed position, until a move leads away.
struct Beside {
  AxisVector tool;  // mm, machine coordinates, as Modal::position
  Plane plane;      // of the contour
};

/// The depths of pecks, mm: each is less than the one before, down to the least. With Q, and here
/// by default, all are alike.
struct Pecks {
  double first = 0, less_by = 0, least = 0;
  double out_after = 0;  // the depth after which the tool goes out of the hole; 0: never

  bool lessen() const noexcept { return less_by != 0 || least != 0; }
  double after(double peck) const noexcept {
    return lessen() ? std::max(peck - less_by, least) : peck;
  }
  /// Returns whether the tool goes out after pecks of this depth together.
  bool is_out_after(double depth) const noexcept {
    constexpr double kSame = 1e-9;  // mm
    return out_after > 0 && depth > out_after - kSame;
  }
  /// Returns what no peck is below.
  double at_least() const noexcept { return lessen() ? std::min(first, least) : first; }
};

/// The words of a canned cycle that stay in force with it: mm, s; as programmed.
struct CycleWords {
  std::optional<double> retract, bottom, dwell;
  std::optional<Pecks> pecks;
  double start = 0;  // mm, programmed: the height before the first cycle of a row
  /// Written in G91: FANUC's controls keep the height that the word had, whatever comes after it.
  bool retract_from_start = false, bottom_from_retract = false;
};

/// Where the control point was at the contact of a probe, or at the end of its move without one;
/// mm, as Modal::position.
struct ProbedPoint {
  AxisVector place;
  bool contact;
};

/// A probing move that waits for what the machine finds.
struct AwaitedProbe {
  ProbeRequest request;
  const GCode* code = nullptr;
  SourcePos word;    // its code
  std::string line;  // its text
};

/// The modes that M70 or M73 has saved.
struct SavedModes {
  Modes modes;
  int work_system = 0;  // index, of G54 to G59.3
  bool shift_on = false;
  Unknown unknown;         // as of Modal
  bool automatic = false;  // by M73: the end of the call restores them
};

/// Modes that the end of a call has restored, before blocks have followed them.
struct Restored {
  Modes before;
  SourcePos pos;                       // of the end of the call
  std::optional<Placement> placement;  // of before
};

/// The state from line to line; a new Modal is that at the start of a program.
struct Modal : Modes {
  /// mm, machine coordinates: the end of the last move, as if nothing were transformed.
  AxisVector position = AxisVector::Zero();
  std::optional<Placement> placement;  // where the position is; empty: nothing is transformed
  MachineState state;                  // offsets and what else outlives the program
  AxisVector local_shift = AxisVector::Zero();   // mm: of G52 in the fanuc dialect
  AxisVector shift_of_g52 = AxisVector::Zero();  // mm: in linuxcnc, what of the shift G52 has set
  Coordinates coordinates;                       // made of these by update_coordinates()
  /// The coordinates of the other dialect, once an offset has been assigned to.
  std::optional<Coordinates> coordinates_there;
  bool machine_coordinates = false;     // on this line: G53
  std::optional<PolarPoint> polar_end;  // on this line: of its move
  bool stops_once = false;              // on this line: G09
  const GCode* motion = nullptr;        // the motion code in force
  const GCode* motion_below = nullptr;  // G00 to G03: in force unless a cycle is
  std::optional<int> tool;              // as selected by T
  std::optional<Beside> beside;
  std::optional<PendingCurve> curve;
  std::optional<PendingPoints> points;
  std::optional<CurveEnd> curve_end;
  std::optional<Surface> surface;  // of G06.4
  CycleWords cycle;
  std::vector<std::optional<SavedModes>> saved{1};  // by level of calls
  std::optional<Restored> restored;

  SimulatedInputs inputs;
  std::optional<ProbedPoint> probed;  // by this line, for #5061 to #5070
  std::optional<AwaitedProbe> awaited;
  std::optional<double> input_value;  // that M66 of this line has read, for #5399

  Unknown unknown;  // what errors have left open

  // Reported once a file.
  bool feed_warned = false, spindle_warned = false, dwell_warned = false, peck_warned = false;
  bool look_ahead_reported = false, chopping_reported = false, order_reported = false;
  bool across_reported = false, corner_radius_reported = false;
  bool idle_dwell_reported = false, zero_reported = false;
  bool diameter_warned = false;  // of Haas: that offsets are taken for diameters
  bool rest_reported = false;    // once a G06.4: that the spindle rests
  bool ended = false;            // M02 or M30 was read

  WorkOffset work() const { return state.work_system(state.active); }
  AxisVector shift() const noexcept {
    return state.shift_on ? AxisVector(state.shift + local_shift) : local_shift;
  }
  /// Returns where the machine is at the position, mm, machine coordinates.
  AxisVector machine_position() const noexcept { return placement ? placed_position() : position; }
  /// Returns where the position would have to be for the machine to be at `place`.
  AxisVector unplaced(const AxisVector& place) const noexcept {
    return placement ? placement->map.inverse()(place) : place;
  }
  /// Recomputes the coordinates after a change of an offset, or of what M72 restores. The position
  /// of the machine stays.
  void update_coordinates() noexcept {
    use(Coordinates(work(), shift(), tool_offset));
    coordinates_there.reset();
  }
  /// Puts a transformation in force. The position of the machine stays.
  void transform(const Transformation& wanted) noexcept {
    transformation = wanted;
    use(coordinates);
  }
  /// Recomputes the coordinates after an assignment to an offset, which counts at once or when
  /// coordinates are updated next.
  void assign_offset(bool at_once) noexcept {
    const Coordinates assigned(work(), shift(), tool_offset);
    if (!coordinates_there) coordinates_there = coordinates;
    if (at_once)
      use(assigned);
    else
      *coordinates_there = assigned;
  }

 private:
  void use(const Coordinates& wanted) noexcept {
    if (!placement && transformation.empty())
      coordinates = wanted;
    else
      place_again(wanted);
  }
  AxisVector placed_position() const noexcept;
  void place_again(const Coordinates& wanted) noexcept;
};

}  // namespace softcnc::ipr
