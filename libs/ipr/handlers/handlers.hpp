// SPDX-License-Identifier: MIT
// What codes do. A handler acts where all that it reads is known (see lines/operands.hpp).
#pragma once

#include <cstdint>
#include <span>

#include "ipr/codes/axis_letters.hpp"
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

/// One code of one line, at work.
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
/// Of a move that cannot be made, for something is unknown: keeps for each axis whether it is known
/// where it leads. False: the code moves on more than its own line, or in a cycle.
bool follow_unmade_move(Task& task);
/// Keeps for each axis with a word of these letters whether it is known where that leads, and
/// where.
void follow_axes(const Command& command, Modal& modal, Letters letters);
/// Along a line to a place in machine coordinates; a line of no length gives no block.
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
void retract_to_start(Task& task);
void retract_to_r(Task& task);

// nurbs_words.cpp
void nurbs(Task& task);
/// Reports codes of a line that do not belong into the pending curve, and ends it at some.
void check_pending_curve(const Command& command, Dialect dialect, Modal& modal, Output& out);
/// Ends a pending curve at the end of the program.
void end_pending_curve(Modal& modal, Output& out);

// work_offsets.cpp
void select_work_system(Task& task);
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

// reference_points.cpp
void go_home(Task& task);
void keep_home(Task& task);

// saved_modes.cpp
void save_modes(Task& task);
void forget_modes(Task& task);
void restore_modes(Task& task);

// refused.cpp
void refuse_thread(Task& task);
void refuse_signal(Task& task);
void refuse_rigid_tapping(Task& task);
void switch_input(Task& task);

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
/// The words of G06.4 in the first block of G06.2.
void ask_for_surface_of_curve(Task& task);
/// False, after one report, if a roughness is asked for while the spindle rests. `word` and `line`:
/// the move's.
bool has_surface_speed(Modal& modal, Output& out, SourcePos word, std::string_view line);
/// The roughness in force, at the speed of the spindle.
std::optional<Surface> surface_at_speed(const Modal& modal) noexcept;

// modes.cpp
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
void stop_program(Task& task);
void stop_optionally(Task& task);
void end_program(Task& task);

// compensation_words.cpp
void compensate(Task& task);
void select_radius(Task& task);
void end_compensation(Task& task);
/// Refuses codes that would move the contour or the tool while G41 or G42 is in force, or that
/// cannot lead away after G40. Motion acts all the same, so that it is known where it leads.
bool may_act(Task& task);

// calls.cpp
void call_program(Task& task);
void call_macro(Task& task);
void refuse_modal_macro(Task& task);
void leave_program(Task& task);

inline constexpr double kLongestDwell = 1e9;  // s

// coordinate_range.cpp: what lies too far off is reported at its word
/// The place, where it is near enough; otherwise what of it is, after a report.
AxisVector near_place(const Task& task, const AxisVector& place);
std::string leads_far(const std::string& who);
/// Sets an offset. False, after a report, where it is too large: then it stays.
bool keep_offset(Task& task, AxisVector& offset, const AxisVector& wanted);
bool keep_offset(Task& task, char letter, double& offset, double wanted);
/// False, after a report, where one of these words gives a length that is too large: of the radius
/// or the centre of an arc, or a handle of a curve.
bool has_near_lengths(Task& task, std::string_view letters);

// handler_utilities.cpp: what several handlers need
/// Of the word with this letter, or of the code where the line has none.
SourcePos place_of(const Task& task, char letter);
/// Whether the word is written with a decimal point.
bool has_point(const Task& task, const Word& word);
/// Where the axis words lead, in mm and machine coordinates, from the position in force.
AxisVector end_point(const Task& task);
/// Notes where an offset that has been assigned to makes a difference between the dialects.
void compare_offsets(const Task& task);
/// Calls use(axis, mm) for every axis word of the line.
template <typename Use>
void for_named_axes(const Task& task, Use&& use) {
  for (int i = 0; i < kAxes; ++i) {
    const char letter = kAxisLetters[static_cast<std::size_t>(i)];
    if (task.values.has(letter)) use(i, task.values[letter] * task.modal.mm_per_unit);
  }
}
/// Moves along the path from the position, at the feed in force or as a rapid.
void emit_move(Task& task, Path&& path, bool rapid = false);
/// A cutting move by the modes in force.
Move cutting_move(const Modal& modal, Path&& path, double feed);
/// False, after a report, if the machine lacks an axis of the plane.
bool has_plane_axes(Task& task, const PlaneAxes& axes);
/// What a curve over several lines keeps of its first one.
CurveHead curve_head(Task& task);
/// As many control points as a curve can have: all of it is held until its end.
inline constexpr std::size_t kMostCurvePoints = 10'000;
void report_too_many(Task& task);
/// How far the first point of a curve may lie off the position, mm.
double start_tolerance(const Machine& machine);
/// Whether the line has another motion code, or one that stops or ends the program.
bool ends_curve(const Command& command, const GCode& curve) noexcept;
/// False, after a report, if there is no feed. In G95 sets that of the spindle's speed.
bool has_feed(Task& task);
/// mm/s, held at the machine's limit with one warning.
double held_feed(Task& task, double feed);
/// FANUC: with G28 or G30, beside which G00 and G01 come into force and do not move.
bool fanuc_goes_home(const Command& command, Dialect dialect) noexcept;
/// Makes the code the motion in force.
void begin_motion(Task& task);
/// Reports at the word with this letter, or at the code where the line has none.
void report_word(const Task& task, char letter, Code code, std::string message);
/// The value as a whole number from 0; otherwise nothing, after a report.
std::optional<int> whole_number(Task& task, const Word& word);
/// The same of a word that is a code, whatever else the line says.
std::optional<int> whole_number(Output& out, const Word& word);
/// False, after a report, if the value is negative.
bool is_not_negative(Output& out, const Word& word);
/// The value as a whole number of nine digits at most; nothing where it is none, or below `least`.
std::optional<int> whole_from(double least, double value) noexcept;
/// From the first to the last of these words.
SourcePos span_of(const Values& values, std::string_view letters) noexcept;
/// What is reported of a feed above the machine's `limit`, mm/s.
std::string above_limit(const std::string& feed, double limit);

}  // namespace softcnc::ipr
