// SPDX-License-Identifier: MIT
// What codes do. A handler acts where all that it reads is known (see lines/operands.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ipr/codes/axis_letters.hpp"
#include "ipr/codes/code_numbers.hpp"
#include "ipr/codes/gcode.hpp"
#include "ipr/flow/flow.hpp"
#include "ipr/lines/command.hpp"
#include "ipr/lines/options.hpp"
#include "ipr/lines/output.hpp"
#include "ipr/state/modal.hpp"
#include "ipr/state/tool_table.hpp"
#include "motion/geometry/spline.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipr {

/// One code of one line, as its handler sees it.
struct Task {
  const GCode& code;
  const Word& word;  // what called for it; for a modal motion the first coordinate
  const Command& command;
  const Values& values;
  const Machine& machine;
  const InterpreterOptions& options;
  Modal& modal;
  Output& out;
  Flow& flow;
};

// moves.cpp
void rapid(Task& task);
void feed_line(Task& task);
void cancel_motion(Task& task);
/// Records for each axis of a move that cannot be made, since something is unknown, whether its end
/// is known. Returns false if the code moves on more than its own line, or in a cycle.
bool follow_unmade_move(Task& task);
/// Records for each axis with a word of these letters whether the end of its move is known, and
/// where it is.
void follow_axes(const Command& command, Modal& modal, LetterSet letters);
/// Moves along a line to a place in machine coordinates, mm. A line of no length gives no block.
void move_straight(Task& task, const AxisVector& to, bool rapid);

// arcs.cpp
void arc_clockwise(Task& task);
void arc_counterclockwise(Task& task);

// bezier_words.cpp
void cubic(Task& task);
void quadratic(Task& task);
// cycles.cpp
void canned_cycle(Task& task);
void refuse_cycle(Task& task);
/// Makes the holes of the cycle in force at these places, which are programmed ones. Requires that
/// a cycle is in force.
void drill_at(Task& task, const std::vector<AxisVector>& places);
void retract_to_start(Task& task);
void retract_to_r(Task& task);

// nurbs_words.cpp
void nurbs(Task& task);
/// Reports codes of a line that do not belong to the pending curve, and ends the curve at some of
/// them.
void check_pending_curve(const Command& command, Dialect dialect, Modal& modal, Output& out);
/// Ends a pending curve at the end of the program.
void end_pending_curve(Modal& modal, Output& out);

// work_offsets.cpp
/// Returns the index of the work system that G54 to G59.3 select, by GCode::number.
constexpr int system_index(int number) noexcept {
  constexpr int kOfG59 = 5;
  return number > kG59 ? kOfG59 + number - kG59 : (number - kG54) / kCodesPerNumber;
}
void select_work_system(Task& task);
void select_further_system(Task& task);
void use_machine_coordinates(Task& task);
void set_local_shift(Task& task);
void name_position(Task& task);
void clear_shift(Task& task);
void suspend_shift(Task& task);
void resume_shift(Task& task);

// offset_table.cpp
void set_offsets(Task& task);

// tool_length.cpp
inline constexpr int kLastTool = 999'999'999;
ToolTable tools_of(Task& task);
void report_unknown_tool(Task& task, int number, SourcePos pos);
void use_tool_length(Task& task);
void use_given_length(Task& task);
void add_tool_length(Task& task);
void use_no_tool_length(Task& task);
void switch_look_ahead(Task& task);
void stop_once(Task& task);
void select_length(Task& task);

// circular_pocket.cpp
void circular_pocket(Task& task);

// reference_points.cpp
void go_home(Task& task);
void keep_home(Task& task);

// saved_modes.cpp
void save_modes(Task& task);
void forget_modes(Task& task);
void restore_modes(Task& task);

// probing.cpp
void probe(Task& task);
struct ProbeRefusal {
  Code code;
  std::string message;
};
/// Returns why this cannot be what a probing code has found; nothing if it may be.
std::optional<ProbeRefusal> refusal_of(const GCode& code, ProbeFound found, Dialect dialect);
/// Reports a straight move that leads a probe into a body of the machine file: SC2395.
void warn_of_contact(Task& task, const Path& path);

// machine_codes.cpp: what is refused
void refuse_thread(Task& task);
/// Notes that the code has no effect.
void pass_over(Task& task);
void refuse_rigid_tapping(Task& task);
void refuse_of_haas(Task& task);

// hole_patterns.cpp
void drill_pattern(Task& task);
/// Returns whether the line has one of G70 to G72, which uses the axes, I, J, K and L of the line.
bool has_hole_pattern(const Command& command) noexcept;

// signals.cpp
void set_digital_output(Task& task);
void set_analog_output(Task& task);
void read_input(Task& task);
void switch_input(Task& task);

// machine_codes.cpp
/// Returns a row for each M code of the machine, by number. Their words are texts of `machine`,
/// which must outlive them.
std::vector<GCode> machine_codes(const Machine& machine);

// point_words.cpp
void control_points(Task& task);
void end_control_points(Task& task);
void spline(Task& task);
/// Reports codes of a line that do not belong among the pending points, and ends them at others.
void check_pending_points(const Command& command, Modal& modal, Output& out);
/// Ends the pending points of a spline, which has no code of its own to end it.
void end_pending_spline(Modal& modal, Output& out);
/// Ends pending points at the end of the program.
void end_pending_points(Modal& modal, Output& out);

// surface_words.cpp
void ask_for_surface(Task& task);
void cancel_surface(Task& task);
/// Reads the words of G06.4 in the first block of G06.2; R is the weight there.
inline constexpr std::string_view kSurfaceWordsOfCurve = "DJHL";
void ask_for_surface_of_curve(Task& task);
/// Returns false, after one report, if a roughness is asked for while the spindle is at rest.
/// `word` and `line` are those of the move.
bool has_surface_speed(Modal& modal, Output& out, SourcePos word, std::string_view line);
/// Returns the roughness in force, at the speed of the spindle; nothing if none is asked for.
std::optional<Surface> surface_at_speed(const Modal& modal) noexcept;

// polar_words.cpp
void switch_polar(Task& task);
/// Puts words with the letters of the plane in the place of @ and ^. Reports what they may not
/// stand beside.
void begin_polar_words(Command& command, Modal& modal, Output& out);
/// Gives the words of a move in the plane the values that its polar coordinates stand for. Returns
/// false, after a report, if they stand for no point.
bool resolve_polar_words(Task& task, Command& command);

// transformation_words.cpp
void rotate(Task& task);
void end_rotation(Task& task);
void scale(Task& task);
void end_scaling(Task& task);
void mirror(Task& task);
void end_mirror(Task& task);
/// Returns false, after a report, for codes that must not act while coordinates are transformed.
bool may_be_transformed(Task& task);
/// Returns the compensation in force as the transformed contour needs it: a mirror changes its
/// side.
CutterSide placed_cutter(const Modal& modal);
/// What a path comes from, for reports; `line` is empty for the line in work.
struct PlacedWord {
  SourcePos pos;
  std::string_view line;
  std::string code;
};
/// Moves a path to where the transformation in force puts it. Returns false if nothing is left of
/// it, or after a report. Requires a transformation in force.
bool place_path(Modal& modal, Output& out, const PlacedWord& at, Path& path);

// modes.cpp
/// Returns the plane that G17, G18 or G19 selects.
constexpr Plane selected_plane(const GCode& code) noexcept {
  return code.number == kG17 ? Plane::xy : code.number == kG18 ? Plane::zx : Plane::yz;
}
void select_plane(Task& task);
void use_inches(Task& task);
void use_millimetres(Task& task);
void use_absolute(Task& task);
void use_incremental(Task& task);
void use_absolute_centres(Task& task);
void use_incremental_centres(Task& task);
void switch_override(Task& task);
void follow_exactly(Task& task);
void follow_path_within(Task& task);
void smooth_path(Task& task);
/// G05.1 Q1 and Q0.
void switch_smoothing(Task& task, bool on);
void stop_exactly(Task& task);
void set_feed(Task& task);
void select_feed_mode(Task& task);
void refuse_surface_speed(Task& task);

// actions.cpp
void dwell(Task& task);
void set_speed(Task& task);
void select_tool(Task& task);
void change_tool(Task& task);
void name_tool(Task& task);
void turn_spindle(Task& task);
void switch_coolant(Task& task);
/// Turns the spindle as M03, M04 or M05 does.
inline constexpr int kSpindleCw = 3, kSpindleCcw = 4, kSpindleOff = 5;
void turn_spindle_as(Task& task, int number);
/// Switches the coolant as M07, M08 or M09 does.
inline constexpr int kMist = 7, kFlood = 8, kCoolantOff = 9;
void switch_coolant_as(Task& task, int number);
void stop_program(Task& task);
void stop_optionally(Task& task);
void end_program(Task& task);

// compensation_words.cpp
void compensate(Task& task);
/// Returns the radius that D names for G12 and G13, mm; without D that of the last D. Returns
/// nothing, after a report, if it is not known.
std::optional<double> radius_of_pocket_tool(Task& task);
void select_radius(Task& task);
void end_compensation(Task& task);
/// Returns false, after a report, for codes that would move the contour or the tool while G41 or
/// G42 is in force, or that cannot lead away after G40. Motion acts all the same, so that its end
/// is known.
bool may_act(Task& task);

// corner_words.cpp
/// Asks for the chamfer or the rounding that the line has by ,C or ,R.
void ask_for_corner(const Command& command, const Modal& modal, Output& out);
/// Gives up the corner of an earlier line where this one cannot go on from it.
void check_pending_corner(const Command& command, const Modal& modal, Output& out);

// calls.cpp
void call_program(Task& task);
void call_lines(Task& task);
void call_macro(Task& task);
void refuse_modal_macro(Task& task);
void leave_program(Task& task);

inline constexpr double kLongestDwell = 1e9;  // s

// coordinate_range.cpp: what lies too far off is reported at its word
/// Returns the place, mm, if it is near enough. Otherwise reports it, and returns it with the
/// position in place of the coordinates that are too far.
AxisVector near_place(const Task& task, const AxisVector& place);
std::string leads_far(const std::string& who);
/// Sets an offset, mm. Returns false, after a report, if it is too large; it then stays as it was.
bool keep_offset(Task& task, AxisVector& offset, const AxisVector& wanted);
bool keep_offset(Task& task, char letter, double& offset, double wanted);
/// Returns false, after a report, if one of these words gives a length that is too large: the
/// radius or the centre of an arc, or a handle of a curve.
bool has_near_lengths(Task& task, std::string_view letters);

// handler_utilities.cpp: what several handlers need
/// Returns whether the dialect is fanuc, or haas, which is like it.
inline bool is_fanuc(const Task& task) noexcept { return is_fanuc_like(task.options.dialect); }
inline bool is_haas(const Task& task) noexcept { return task.options.dialect == Dialect::haas; }
/// Returns the place of the word with this letter, or of the code if the line has none.
SourcePos place_of(const Task& task, char letter);
/// Returns false, after a report, if the line has no word with this letter, which gives `what`.
bool has_word(Task& task, char letter, std::string_view what);
/// Returns whether the word is written with a decimal point.
bool has_point(const Task& task, const Word& word);
/// Returns whether the word of a dwell counts milliseconds: P in the fanuc dialect, and in the haas
/// dialect P without a decimal point.
bool counts_milliseconds(const Task& task, const Word& dwell);
/// Returns where the axis words lead from the position, in mm and machine coordinates.
AxisVector end_point(const Task& task);
/// Records where an offset that has been assigned to makes a difference between the dialects.
void compare_offsets(const Task& task);
/// Calls use(axis, mm) for every axis word of the line.
template <typename Use>
void for_named_axes(const Task& task, Use&& use) {
  for (int i = 0; i < kAxes; ++i) {
    const char letter = kAxisLetters[static_cast<std::size_t>(i)];
    if (task.values.has(letter)) use(i, task.values[letter] * task.modal.mm_per_unit);
  }
}
/// Emits a move along the path from the position, at the feed in force or as a rapid.
void emit_move(Task& task, Path&& path, bool rapid = false);
/// Returns a cutting move by the modes in force; `feed` is in mm/s.
Move cutting_move(const Modal& modal, Path&& path, double feed);
/// Returns false, after a report, if the machine does not have an axis of the plane.
bool has_plane_axes(Task& task, const PlaneAxes& axes);
/// Returns what a curve over several lines keeps of its first one.
CurveHead curve_head(Task& task);
/// The largest number of control points of a curve: all of it is held in memory until its end.
inline constexpr std::size_t kMostCurvePoints = 10'000;
void report_too_many(Task& task);
/// Returns how far the first point of a curve may be from the position, mm.
double start_tolerance(const Machine& machine);
/// Returns whether the line has another motion code, or one that stops or ends the program.
bool ends_curve(const Command& command, const GCode& curve) noexcept;
/// Returns false, after a report, if there is no feed. In G95 also sets the feed from the spindle's
/// speed.
bool has_feed(Task& task);
/// Returns the feed, mm/s, limited to that of the machine with one warning.
double held_feed(Task& task, double feed);
/// Returns whether the line has G28 or G30 in the fanuc dialect: G00 and G01 beside it come into
/// force and do not move.
bool fanuc_goes_home(const Command& command, Dialect dialect) noexcept;
/// Makes the code of the task the motion in force.
void begin_motion(Task& task);
/// Reports at the word with this letter, or at the code if the line has none.
void report_word(const Task& task, char letter, Code code, std::string message);
/// Returns the value as a whole number from 0; nothing, after a report, if it is not one.
std::optional<int> whole_number(Task& task, const Word& word);
/// Returns the same for a word that is a code, whatever else the line says.
std::optional<int> whole_number(Output& out, const Word& word);
/// Returns false, after a report, if the value is negative.
bool is_not_negative(Output& out, const Word& word);
/// Returns the value as a whole number of at most nine digits; nothing if it is not one, or is
/// below `least`.
std::optional<int> whole_from(double least, double value) noexcept;
/// Returns the range from the first to the last of these words.
SourcePos span_of(const Values& values, std::string_view letters) noexcept;
/// Returns the message about a feed above the machine's `limit`, mm/s.
std::string above_limit(const std::string& feed, double limit);

}  // namespace softcnc::ipr
