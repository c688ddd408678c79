// SPDX-License-Identifier: MIT
// The table of codes, in order of letter and number, and the search in it.
#include "ipr/codes/gcode.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

/// When a code acts within its line: the order of RS274, but that units come first, so that they
/// count for every word of their line.
namespace order {
enum : int {
  units,
  feed_mode,
  feed,
  speed,
  signal,
  tool,
  tool_change,
  spindle,
  saving,
  coolant,
  override_,
  dwell,
  transformation_off,
  plane,
  compensation,
  tool_length,
  surface,
  work_offset,
  path_control,
  distance,
  transformation,
  offsets,
  cycle,
  motion,
  hole_pattern,
  stopping,
  count,
};
}  // namespace order

constexpr std::array<std::string_view, order::count> kOrderNames{
    "units",
    "feed mode",
    "feed",
    "speed",
    "signals",
    "tool",
    "tool change",
    "spindle",
    "saved modes",
    "coolant",
    "override",
    "dwell",
    "transformations off",
    "plane",
    "cutter compensation",
    "tool length",
    "roughness",
    "work system",
    "path control",
    "distance mode",
    "transformations",
    "offsets and reference points",
    "motion off",
    "motion",
    "patterns of holes",
    "stop",
};
static_assert(!kOrderNames.back().empty());

constexpr std::array<std::string_view, kGroups> kGroupNames{
    "none: for its line only",
    "motion",
    "motion off",
    "retract of cycles",
    "spindle mode",
    "plane",
    "distance mode",
    "feed mode",
    "units",
    "cutter compensation",
    "tool length",
    "work system",
    "path control",
    "roughness",
    "stop",
    "tool change",
    "spindle",
    "coolant",
    "override",
    "saved modes",
    "signals",
    "centres of arcs",
    "feed",
    "speed",
    "tool",
    "line number",
    "program number",
    "number of a radius",
    "number of a length",
    "polar coordinates",
    "scaling",
    "rotated coordinates",
};
static_assert(!kGroupNames.back().empty());

constexpr GCode kCodeTable[] = {
    {'G', 0, Group::motion, order::motion, "XYZ", rapid,
     "Straight move on which only the axes limit."},
    {'G', 10, Group::motion, order::motion, "XYZ", feed_line, "Straight move at the feed."},
    {'G', 20, Group::motion, order::motion, "XYZIJKRP", arc_clockwise,
     "Arc or helix clockwise, by centre (I J K from the start) or radius R (negative: the long "
     "way); P turns (1)."},
    {'G', 30, Group::motion, order::motion, "XYZIJKRP", arc_counterclockwise,
     "Arc or helix counter-clockwise, by centre or radius as G02."},
    {'G', 40, Group::non_modal, order::dwell, "P", dwell,
     "Dwell of P seconds; fanuc: P milliseconds, or X or U seconds.", "XU"},
    {'G', 50, Group::motion, order::motion, "XYZIJKPQ", cubic,
     "Cubic curve; its control points by I J (K) from the start and P Q from the end. fanuc: no "
     "effect."},
    {'G', 51, Group::motion, order::motion, "XYZIJKQR", quadratic,
     "Quadratic curve; its control point by I J (K) from the start. fanuc: smoothing on (Q1) or "
     "off."},
    {'G', 52, Group::motion, order::motion, "XYZPL", control_points,
     "NURBS of order L (3): one block per control point with weight P, then G05.3."},
    {'G', 53, Group::motion, order::motion, "", end_control_points, "Ends the curve of G05.2."},
    {'G', 61, Group::motion, order::motion, "XYZ", spline,
     "Cubic spline through the points, one per block, until another motion code."},
    {'G', 62, Group::motion, order::motion, "XYZKRPQDJHL", nurbs,
     "NURBS of order P (4): one block per control point with knot K and weight R (1), then P "
     "blocks of K."},
    {'G', 64, Group::surface, order::surface, "DJHLRQ", ask_for_surface,
     "Roughness asked for: tool radius D, pick-feed J, Rmax H in um, teeth L; R: radius of the "
     "surface across the feed, Q: its largest slope there in degrees."},
    {'G', 65, Group::surface, order::surface, "", cancel_surface, "No roughness asked for."},
    {'G', 80, Group::non_modal, order::path_control, "P", switch_look_ahead,
     "fanuc: switch of the look-ahead, P1 and P0; no effect."},
    {'G', 90, Group::non_modal, order::path_control, "", stop_once,
     "fanuc: the block of this line ends at rest."},
    {'G', 100, Group::non_modal, order::offsets, "LPXYZR", set_offsets,
     "Sets tables: L2, L20 work system P; L1, L10, L11 tool P; fanuc: L10 to L13 offset P."},
    {'G', 110, Group::non_modal, order::offsets, "", nullptr,
     "fanuc: ends the values that G10 L50 begins, which is refused."},
    {'G', 120, Group::non_modal, order::offsets, "XYZIKQDL", circular_pocket,
     "Circular pocket clockwise, about X Y: one pass of radius I, or passes from I in steps of Q "
     "to "
     "K, at Z, L times; D: number of the tool's radius."},
    {'G', 130, Group::non_modal, order::offsets, "XYZIKQDL", circular_pocket,
     "Circular pocket counter-clockwise: as G12."},
    {'G', 150, Group::polar, order::transformation_off, "", switch_polar,
     "Coordinates along the plane are no polar ones, as at the start."},
    {'G', 160, Group::polar, order::transformation, "", switch_polar,
     "Polar coordinates: the first axis of the plane gives the radius, the second the angle."},
    {'G', 170, Group::plane, order::plane, "", select_plane, "Arcs lie in the plane X Y."},
    {'G', 180, Group::plane, order::plane, "", select_plane, "Arcs lie in the plane Z X."},
    {'G', 190, Group::plane, order::plane, "", select_plane, "Arcs lie in the plane Y Z."},
    {'G', 200, Group::units, order::units, "", use_inches,
     "Lengths are in inches, feeds in inches per minute."},
    {'G', 210, Group::units, order::units, "", use_millimetres,
     "Lengths are in mm, feeds in mm per minute."},
    {'G', 280, Group::non_modal, order::offsets, "XYZ", go_home,
     "Rapid to the place of G28.1 in the axes named, via the point given; in all axes if "
     "none is given.",
     "P"},
    {'G', 281, Group::non_modal, order::offsets, "", keep_home,
     "Makes the position that of G28, in machine coordinates."},
    {'G', 300, Group::non_modal, order::offsets, "XYZ", go_home,
     "As G28, to the place of G30.1; fanuc: P2 the same, P3 and P4 to those of the state file.",
     "P"},
    {'G', 301, Group::non_modal, order::offsets, "", keep_home,
     "Makes the position that of G30, in machine coordinates."},
    {'G', 310, Group::non_modal, order::offsets, "XYZPQ", probe,
     "Straight to X Y Z at F, up to the contact of a probe; P and Q are not read."},
    {'G', 330, Group::motion, order::motion, "XYZKI", refuse_thread,
     "Refused: threads need a spindle with an encoder."},
    {'G', 331, Group::motion, order::motion, "XYZKI", refuse_thread,
     "Refused: threads need a spindle with an encoder."},
    {'G', 382, Group::motion, order::motion, "XYZ", probe,
     "Straight to X Y Z at F, up to a contact; without one it is an error."},
    {'G', 383, Group::motion, order::motion, "XYZ", probe,
     "As G38.2; without a contact it goes on."},
    {'G', 384, Group::motion, order::motion, "XYZ", probe,
     "Straight to X Y Z at F, up to where the probe touches nothing any more; if it never does, an "
     "error."},
    {'G', 385, Group::motion, order::motion, "XYZ", probe,
     "As G38.4; if it never does, it goes on."},
    {'G', 400, Group::cutter_compensation, order::compensation, "", end_compensation,
     "Cutter compensation off, as at the start."},
    {'G', 410, Group::cutter_compensation, order::compensation, "DL", compensate,
     "The tool runs left of the contour, by its radius; D: that of another tool (fanuc: without D "
     "the last)."},
    {'G', 411, Group::cutter_compensation, order::compensation, "DL", compensate,
     "The same by the diameter D."},
    {'G', 420, Group::cutter_compensation, order::compensation, "DL", compensate,
     "The tool runs right of the contour, by its radius; D: that of another tool (fanuc: without D "
     "the last)."},
    {'G', 421, Group::cutter_compensation, order::compensation, "DL", compensate,
     "The same by the diameter D."},
    {'G', 430, Group::tool_length, order::tool_length, "H", use_tool_length,
     "Length of tool H counts; without H, of the tool in the spindle (fanuc: the last H)."},
    {'G', 431, Group::tool_length, order::tool_length, "XYZ", use_given_length,
     "X Y Z count as the length of the tool."},
    {'G', 432, Group::tool_length, order::tool_length, "H", add_tool_length,
     "Length of tool H is added to what counts."},
    {'G', 470, Group::non_modal, order::offsets, "XYZEIJPR", refuse_of_haas,
     "haas: refused, engraving needs the letters of the control."},
    {'G', 490, Group::tool_length, order::tool_length, "", use_no_tool_length,
     "Tool length offset off, as at the start."},
    {'G', 500, Group::scaling, order::transformation_off, "", end_scaling,
     "Scaling off, as at the start."},
    {'G', 501, Group::scaling, order::transformation_off, "XYZ", end_mirror,
     "Mirror off in the axes named, in all if none is; as at the start."},
    {'G', 510, Group::scaling, order::transformation, "XYZPIJK", scale,
     "Scales from the point X Y Z (the position) by P, or by I J K along each axis."},
    {'G', 511, Group::scaling, order::transformation, "XYZ", mirror,
     "Mirrors the axes named at these places."},
    {'G', 520, Group::non_modal, order::offsets, "XYZ", set_local_shift,
     "Shifts all work systems by X Y Z."},
    {'G', 530, Group::non_modal, order::offsets, "", use_machine_coordinates,
     "G00 or G01 of this line goes to machine coordinates (fanuc: always a rapid)."},
    {'G', 540, Group::work_offset, order::work_offset, "", select_work_system,
     "Work system 1, as at the start; fanuc: with P, beside no code that takes it, as G54.1 P.",
     "P"},
    {'G', 541, Group::work_offset, order::work_offset, "P", select_further_system,
     "Further work system P, 1 to 300; without P the first."},
    {'G', 550, Group::work_offset, order::work_offset, "", select_work_system, "Work system 2."},
    {'G', 560, Group::work_offset, order::work_offset, "", select_work_system, "Work system 3."},
    {'G', 570, Group::work_offset, order::work_offset, "", select_work_system, "Work system 4."},
    {'G', 580, Group::work_offset, order::work_offset, "", select_work_system, "Work system 5."},
    {'G', 590, Group::work_offset, order::work_offset, "", select_work_system, "Work system 6."},
    {'G', 591, Group::work_offset, order::work_offset, "", select_work_system, "Work system 7."},
    {'G', 592, Group::work_offset, order::work_offset, "", select_work_system, "Work system 8."},
    {'G', 593, Group::work_offset, order::work_offset, "", select_work_system, "Work system 9."},
    {'G', 610, Group::path_control, order::path_control, "", follow_exactly,
     "The path is followed exactly; fanuc: every block ends at rest."},
    {'G', 611, Group::path_control, order::path_control, "", stop_exactly,
     "Every block ends at rest."},
    {'G', 640, Group::path_control, order::path_control, "PQR", follow_path_within,
     "Corners may be rounded within P, chords joined within Q (P); R has no effect."},
    {'G', 650, Group::non_modal, order::stopping, "PL", call_macro,
     "Calls the program O P, L times; the words after G65 are its variables #1 to #33."},
    {'G', 660, Group::non_modal, order::stopping, "PL", refuse_modal_macro,
     "Refused: a macro call after every move."},
    {'G', 661, Group::non_modal, order::stopping, "PL", refuse_modal_macro,
     "Refused: a macro call after every block."},
    {'G', 670, Group::non_modal, order::stopping, "", nullptr, "No macro calls after moves."},
    {'G', 680, Group::rotation, order::transformation, "XYZRIJK", rotate,
     "Turns the plane about a point (the position) by R degrees, counter-clockwise."},
    {'G', 690, Group::rotation, order::transformation_off, "", end_rotation,
     "Rotation off, as at the start."},
    {'G', 700, Group::non_modal, order::hole_pattern, "XYZIJL", drill_pattern,
     "haas: holes by the cycle in force on a circle of radius I about X Y: L of them, evenly, from "
     "the angle J on."},
    {'G', 710, Group::non_modal, order::hole_pattern, "XYZIJKL", drill_pattern,
     "haas: the same on an arc: L holes, K degrees apart."},
    {'G', 720, Group::non_modal, order::hole_pattern, "XYZIJL", drill_pattern,
     "haas: L holes by the cycle in force, I apart, from X Y on along the angle J."},
    {'G', 730, Group::motion, order::motion, "XYZRQLK", canned_cycle,
     "Drill to Z in pecks of Q, breaking the chip; the other words as G81; fanuc: P as G82; "
     "haas: pecks by I J K.",
     "P", "IJ"},
    {'G', 740, Group::motion, order::motion, "XYZRPLK", canned_cycle,
     "Tap a left-hand thread with a floating holder: as G84, the spindle the other way round.",
     "Q"},
    {'G', 760, Group::motion, order::motion, "XYZPIJKRQHEL", refuse_thread,
     "Refused: threads need a spindle with an encoder, fine boring one that can be oriented."},
    {'G', 800, Group::cycle, order::cycle, "", cancel_motion,
     "No motion code in force, unless one stands beside it; fanuc: that from before the cycle."},
    {'G', 810, Group::motion, order::motion, "XYZRLK", canned_cycle,
     "Drill: rapid over the hole, rapid to R, feed to Z, rapid out; L times (fanuc: K).", "P"},
    {'G', 820, Group::motion, order::motion, "XYZRPLK", canned_cycle,
     "Drill, with a dwell of P at the bottom."},
    {'G', 830, Group::motion, order::motion, "XYZRQLK", canned_cycle,
     "Drill to Z in pecks of Q, each time out to R; fanuc: P as G82; haas: pecks by I J K.", "P",
     "IJ"},
    {'G', 840, Group::motion, order::motion, "XYZRPLK", canned_cycle,
     "Tap a right-hand thread with a floating holder: feed to Z, spindle back, dwell P, feed out.",
     "Q"},
    {'G', 850, Group::motion, order::motion, "XYZRLK", canned_cycle,
     "Bore: feed to Z, feed out to R.", "P"},
    {'G', 860, Group::motion, order::motion, "XYZRPLK", canned_cycle,
     "Bore: feed to Z, dwell P, spindle stop, rapid out, spindle on."},
    {'G', 870, Group::motion, order::motion, "XYZRPQIJKL", refuse_cycle,
     "Refused: back boring needs a spindle that can be oriented."},
    {'G', 880, Group::motion, order::motion, "XYZRPQIJKL", refuse_cycle,
     "Refused: this boring cycle requires the operator to retract the tool by hand."},
    {'G', 890, Group::motion, order::motion, "XYZRPLK", canned_cycle,
     "Bore: feed to Z, dwell P, feed out."},
    {'G', 900, Group::distance, order::distance, "", use_absolute, "Coordinates are positions."},
    {'G', 901, Group::arc_distance, order::distance, "", use_absolute_centres,
     "I J K are positions."},
    {'G', 910, Group::distance, order::distance, "", use_incremental,
     "Coordinates are distances from the position."},
    {'G', 911, Group::arc_distance, order::distance, "", use_incremental_centres,
     "I J K are distances from the start of the arc, as at the start."},
    {'G', 920, Group::non_modal, order::offsets, "XYZ", name_position,
     "The position gets the coordinates X Y Z: a shift of all work systems."},
    {'G', 921, Group::non_modal, order::offsets, "", clear_shift, "No shift; it is forgotten.",
     "XYZ"},
    {'G', 922, Group::non_modal, order::offsets, "", suspend_shift, "No shift until G92.3."},
    {'G', 923, Group::non_modal, order::offsets, "", resume_shift,
     "The shift from before G92.2, or the one kept from an earlier program."},
    {'G', 930, Group::feed_mode, order::feed_mode, "", select_feed_mode,
     "F is one over the minutes of its own move."},
    {'G', 940, Group::feed_mode, order::feed_mode, "", select_feed_mode,
     "F is a speed per minute, as at the start."},
    {'G', 950, Group::feed_mode, order::feed_mode, "", select_feed_mode,
     "F is a length per turn of the spindle."},
    {'G', 960, Group::spindle_mode, order::feed_mode, "D", refuse_surface_speed,
     "Refused: a constant surface speed needs work that turns."},
    {'G', 970, Group::spindle_mode, order::feed_mode, "", nullptr,
     "S is in revolutions per minute, as at the start."},
    {'G', 980, Group::retract, order::distance, "", retract_to_start,
     "Cycles retract to the height at which the first of a series of cycles started."},
    {'G', 990, Group::retract, order::distance, "", retract_to_r, "Cycles retract to R."},
    {'G', 1030, Group::non_modal, order::path_control, "P", pass_over,
     "Look-ahead of P blocks; no effect."},
    {'G', 1100, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 1, as G154 P1."},
    {'G', 1110, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 2, as G154 P2."},
    {'G', 1120, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 3, as G154 P3."},
    {'G', 1130, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 4, as G154 P4."},
    {'G', 1140, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 5, as G154 P5."},
    {'G', 1150, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 6, as G154 P6."},
    {'G', 1160, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 7, as G154 P7."},
    {'G', 1170, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 8, as G154 P8."},
    {'G', 1180, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 9, as G154 P9."},
    {'G', 1190, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 10, as G154 P10."},
    {'G', 1200, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 11, as G154 P11."},
    {'G', 1210, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 12, as G154 P12."},
    {'G', 1220, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 13, as G154 P13."},
    {'G', 1230, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 14, as G154 P14."},
    {'G', 1240, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 15, as G154 P15."},
    {'G', 1250, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 16, as G154 P16."},
    {'G', 1260, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 17, as G154 P17."},
    {'G', 1270, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 18, as G154 P18."},
    {'G', 1280, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 19, as G154 P19."},
    {'G', 1290, Group::work_offset, order::work_offset, "", select_further_system,
     "Further work system 20, as G154 P20."},
    {'G', 1500, Group::non_modal, order::offsets, "XYZIJKPQRD", refuse_of_haas,
     "haas: refused, a pocket of any shape needs paths that clear it."},
    {'G', 1540, Group::work_offset, order::work_offset, "P", select_further_system,
     "Further work system P, 1 to 99, as G54.1 P."},
    {'G', 1870, Group::non_modal, order::path_control, "PE", smooth_path,
     "Rounds corners within E, or with P within the tolerance of the machine for smoothing."},
    {'M', 0, Group::stopping, order::stopping, "", stop_program,
     "Stop until the operator goes on."},
    {'M', 10, Group::stopping, order::stopping, "", stop_optionally,
     "Stop if optional stops are switched on."},
    {'M', 20, Group::stopping, order::stopping, "", end_program, "End of the program."},
    {'M', 30, Group::spindle, order::spindle, "", turn_spindle, "Spindle on, clockwise."},
    {'M', 40, Group::spindle, order::spindle, "", turn_spindle, "Spindle on, counter-clockwise."},
    {'M', 50, Group::spindle, order::spindle, "", turn_spindle, "Spindle off."},
    {'M', 60, Group::tool_change, order::tool_change, "", change_tool,
     "Spindle off, and change to the tool that T has selected."},
    {'M', 70, Group::coolant, order::coolant, "", switch_coolant, "Mist on."},
    {'M', 80, Group::coolant, order::coolant, "", switch_coolant, "Flood on."},
    {'M', 90, Group::coolant, order::coolant, "", switch_coolant, "Coolant off."},
    {'M', 290, Group::signal, order::signal, "", refuse_rigid_tapping,
     "Refused: rigid tapping needs a spindle in step with the axis."},
    {'M', 300, Group::stopping, order::stopping, "", end_program, "End of the program."},
    {'M', 480, Group::override_, order::override_, "", switch_override,
     "The feed override counts, as at the start."},
    {'M', 490, Group::override_, order::override_, "", switch_override,
     "The feed is as programmed, whatever the override."},
    {'M', 500, Group::override_, order::override_, "P", switch_override, "As M48; P0: as M49."},
    {'M', 510, Group::override_, order::override_, "P", switch_override,
     "Spindle speed override; ignored, since there is none."},
    {'M', 520, Group::override_, order::override_, "P", switch_input,
     "The feed is multiplied by the input adaptive-feed, as it is on this line; P0: it is not."},
    {'M', 530, Group::override_, order::override_, "P", switch_input,
     "Waits here while the input feed-hold is on; P0: does not."},
    {'M', 600, Group::stopping, order::stopping, "", stop_program,
     "Change of pallets: stop until the operator goes on."},
    {'M', 610, Group::tool_change, order::tool_change, "Q", name_tool,
     "Tool Q is the one in the spindle."},
    {'M', 620, Group::signal, order::signal, "P", set_digital_output,
     "Digital output P on, when the next move begins."},
    {'M', 630, Group::signal, order::signal, "P", set_digital_output,
     "Digital output P off, when the next move begins."},
    {'M', 640, Group::signal, order::signal, "P", set_digital_output, "Digital output P on."},
    {'M', 650, Group::signal, order::signal, "P", set_digital_output, "Digital output P off."},
    {'M', 660, Group::signal, order::signal, "PELQ", read_input,
     "Reads input P or E into #5399; waits Q seconds at most for L1 rise, L2 fall, L3 on, L4 off."},
    {'M', 670, Group::signal, order::signal, "EQ", set_analog_output,
     "Analog output E gets the value Q, when the next move begins."},
    {'M', 680, Group::signal, order::signal, "EQ", set_analog_output,
     "Analog output E gets the value Q."},
    {'M', 700, Group::saving, order::saving, "", save_modes,
     "Saves the modes, for M72 at the same level of calls."},
    {'M', 710, Group::saving, order::saving, "", forget_modes,
     "Forgets what M70 or M73 has saved."},
    {'M', 720, Group::saving, order::saving, "", restore_modes,
     "Restores the modes that M70 or M73 has saved."},
    {'M', 730, Group::saving, order::saving, "", save_modes,
     "As M70; the end of the subprogram restores the modes."},
    {'M', 970, Group::stopping, order::stopping, "PL", call_lines,
     "Calls the lines from N P of this program on, up to M99, L times."},
    {'M', 980, Group::stopping, order::stopping, "PLQ", call_program,
     "Calls the program O P, L times, from its line N Q on."},
    {'M', 990, Group::stopping, order::stopping, "P", leave_program,
     "Back after the call, or to the line N P there (haas: here); in the main program from its "
     "beginning."},
    {'M', 1090, Group::stopping, order::stopping, "P", refuse_of_haas,
     "haas: refused, it asks the operator for an answer."},
    {'F', kAnyNumber, Group::feed, order::feed, "", set_feed, "Feed along the path, per minute."},
    {'S', kAnyNumber, Group::speed, order::speed, "", set_speed,
     "Spindle speed in revolutions per minute."},
    {'T', kAnyNumber, Group::tool, order::tool, "", select_tool, "Selects the tool for M06."},
    {'N', kAnyNumber, Group::line_number, order::stopping, "", nullptr,
     "Number of the line; GOTO, M98 Q and M99 P go by it."},
    {'O', kAnyNumber, Group::program_number, order::stopping, "", nullptr,
     "Number of the program, alone on its line."},
    {'D', kAnyNumber, Group::radius_number, order::compensation, "D", select_radius,
     "fanuc, beside no code that takes it: number of the radius for G41 and G42 without D."},
    {'H', kAnyNumber, Group::length_number, order::tool_length, "H", select_length,
     "fanuc, beside no code that takes it: number of the length, at once while G43 is in force."},
};

constexpr int kNumbers = 2000;  // G0 to G199.9
constexpr std::uint8_t kNone = 0xFF;
static_assert(std::size(kCodeTable) < kNone);

using Index = std::array<std::uint8_t, kNumbers>;

constexpr Index index_of(char letter) {
  Index index{};
  index.fill(kNone);
  for (std::size_t row = 0; row < std::size(kCodeTable); ++row)
    if (kCodeTable[row].letter == letter && kCodeTable[row].number != kAnyNumber)
      index[static_cast<std::size_t>(kCodeTable[row].number)] = static_cast<std::uint8_t>(row);
  return index;
}

constexpr Index kGIndex = index_of('G');
constexpr Index kMIndex = index_of('M');

/// The rows of words that are codes whatever their number, from A on.
constexpr auto kWordIndex = [] {
  std::array<std::uint8_t, 26> index{};
  index.fill(kNone);
  for (std::size_t row = 0; row < std::size(kCodeTable); ++row)
    if (kCodeTable[row].number == kAnyNumber)
      index[static_cast<std::size_t>(kCodeTable[row].letter - 'A')] =
          static_cast<std::uint8_t>(row);
  return index;
}();

const GCode* row(std::uint8_t index) noexcept {
  return index == kNone ? nullptr : &kCodeTable[index];
}

}  // namespace

std::span<const GCode> gcode_table() noexcept { return kCodeTable; }
std::span<const std::string_view> order_names() noexcept { return kOrderNames; }

std::string_view group_name(Group group) noexcept {
  return kGroupNames[static_cast<std::size_t>(group)];
}

const GCode* find_gcode(char letter, double value) noexcept {
  if (letter != 'G' && letter != 'M')
    return letter < 'A' || letter > 'Z' ? nullptr  // @ and ^ are no codes
                                        : row(kWordIndex[static_cast<std::size_t>(letter - 'A')]);
  constexpr double kRounding = 1e-3;  // as LinuxCNC rounds: G1.00001 is G01
  const double tenths = value * 10;
  if (!(tenths > -kRounding && tenths + kRounding < kNumbers)) return nullptr;
  const auto nearest = static_cast<std::uint32_t>(tenths + 0.5);
  if (nearest >= kNumbers || std::abs(tenths - nearest) > kRounding) return nullptr;
  return row((letter == 'G' ? kGIndex : kMIndex)[nearest]);
}

std::string code_name(const GCode& code) {
  if (code.number == kAnyNumber) return {code.letter};
  return code_name(code.letter, code.number / 10.0);
}

std::string code_name(char letter, double value) {
  std::string name(1, letter);
  if (value >= 0 && value < 10) name += '0';
  return name += number_text(value);
}

}  // namespace softcnc::ipr
