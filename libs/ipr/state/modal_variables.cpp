// SPDX-License-Identifier: MIT
// A table of names; numbers by their ranges.
#include "ipr/state/modal_variables.hpp"

#include <algorithm>
#include <limits>

#include "ipr/codes/gcode.hpp"
#include "ipr/state/offset_variables.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

// RS274.
constexpr int kShiftOn = 5210, kActive = 5220;
constexpr int kLoadedTool = 5400, kToolOffset = 5401, kDiameter = 5410, kToolEnd = 5414;
constexpr int kFirstPosition = 5420, kPositionEnd = 5429;
// FANUC: the end of the last block, and the same in machine coordinates; where the tool is; the
// tool offset; a work offset for all systems, which there is none of (Haas: the shift of G52).
constexpr int kBlockEnd = 5001, kMachine = 5021, kCurrent = 5041, kLength = 5081, kCommon = 5201;
// FANUC: switches of the control that change nothing here; codes in force.
constexpr int kNoSingleBlock = 3003, kNoHold = 3004;
constexpr int kCodeVariables = 4000;

bool is_local_shift(int number, Dialect dialect) {
  return dialect == Dialect::haas && axis_in(number, kCommon) >= 0;
}

double program_position(const Modal& modal, int axis) {
  if (modal.unknown.has(position_part(axis)) || modal.unknown.has_any(kOffsets)) return kUnknown;
  return modal.coordinates.to_program(modal.position)[axis] / modal.mm_per_unit;
}

/// Where a transformation is in force, each axis may depend on all.
bool knows_place(const Modal& modal, int axis) {
  if (!modal.placement) return !modal.unknown.has(position_part(axis));
  return !modal.unknown.has_any(kPosition | kOffsets);
}

double machine_position(const Modal& modal, int axis) {
  if (!knows_place(modal, axis)) return kUnknown;
  return modal.machine_position()[axis] / modal.mm_per_unit;
}

/// Where the tool is in the work system, after what is transformed.
double work_position(const Modal& modal, int axis) {
  if (!knows_place(modal, axis) || modal.unknown.has_any(kOffsets)) return kUnknown;
  return modal.coordinates.to_program(modal.machine_position())[axis] / modal.mm_per_unit;
}

double motion_mode(const Modal& modal) {
  constexpr double kNoMotion = 800;
  if (modal.unknown.has(Part::motion)) return kUnknown;
  return modal.motion != nullptr ? modal.motion->number : kNoMotion;
}

/// The value that depends on a part of the state.
double known(const Modal& modal, Part part, double value) {
  return modal.unknown.has(part) ? kUnknown : value;
}

double coordinate_system(const Modal& modal) {
  constexpr int kFirst = 540, kLastWhole = 5;  // G54 to G59, then G59.1 to G59.3
  const int active = modal.state.active;
  if (active >= kWorkSystems) return known(modal, Part::work_system, kFirst + 1);  // G54.1
  const double code =
      active <= kLastWhole ? kFirst + 10 * active : kFirst + 10 * kLastWhole + active - kLastWhole;
  return known(modal, Part::work_system, code);
}

double plane(const Modal& modal) {
  constexpr double kXy = 170, kZx = 180, kYz = 190;
  const double code = modal.plane == Plane::xy ? kXy : modal.plane == Plane::zx ? kZx : kYz;
  return known(modal, Part::plane, code);
}

double feed(const Modal& modal) {
  if (modal.unknown.has(Part::feed)) return kUnknown;
  if (modal.feed_mode == FeedMode::inverse_time) return modal.feed_word;
  const bool per_turn = modal.feed_mode == FeedMode::per_turn;
  return (per_turn ? modal.feed_word : mm_min_from_mm_s(modal.feed)) / modal.mm_per_unit;
}

template <FeedMode mode>
double has_feed_mode(const Modal& modal) {
  return known(modal, Part::feed_mode, modal.feed_mode == mode ? 1 : 0);
}

double spindle_speed(const Modal& modal) {
  return modal.unknown.has(Part::speed) ? kUnknown : modal.spindle_speed.value_or(0);
}

double selected_tool(const Modal& modal) {
  return modal.unknown.has(Part::tool) ? kUnknown : modal.tool.value_or(0);
}

/// Without a tool table with pockets of its own, a tool stands in the pocket of its number.
double selected_pocket(const Modal& modal) {
  constexpr double kNoPocket = -1;
  return modal.unknown.has(Part::tool) ? kUnknown : modal.tool.value_or(kNoPocket);
}

double loaded_tool(const Modal& modal) {
  return modal.unknown.has(Part::tool) ? kUnknown : modal.state.loaded_tool.value_or(0);
}

double compensation(const Modal& modal) {
  constexpr double kOff = 400, kLeft = 410, kRight = 420;
  const double code = !modal.cutter ? kOff : modal.cutter->side > 0 ? kLeft : kRight;
  return known(modal, Part::cutter, code);
}

bool retracts_to_r(const Modal& modal) { return modal.retract_to_r.value_or(true); }

template <int axis>
double at(const Modal& modal) {
  return program_position(modal, axis);
}

template <int axis>
double machine_at(const Modal& modal) {
  return machine_position(modal, axis);
}

struct Named {
  std::string_view name;
  double (*read)(const Modal&);
};

double zero(const Modal&) { return 0; }
double one(const Modal&) { return 1; }

/// Those of LinuxCNC 2.9. What nothing can change yet is constant.
constexpr Named kNamedVariables[] = {
    {"_a", zero},
    {"_abs_a", zero},
    {"_abs_b", zero},
    {"_abs_c", zero},
    {"_abs_u", zero},
    {"_abs_v", zero},
    {"_abs_w", zero},
    {"_abs_x", machine_at<0>},
    {"_abs_y", machine_at<1>},
    {"_abs_z", machine_at<2>},
    {"_absolute",
     [](const Modal& m) { return known(m, Part::distance, m.incremental ? 0.0 : 1.0); }},
    {"_adaptive_feed", zero},
    {"_b", zero},
    {"_c", zero},
    {"_ccomp", compensation},
    {"_coord_system", coordinate_system},
    {"_current_pocket", loaded_tool},
    {"_current_tool", loaded_tool},
    {"_feed", feed},
    {"_feed_hold", one},
    {"_feed_override", [](const Modal& m) { return m.feed_override ? 1.0 : 0.0; }},
    {"_flood", [](const Modal& m) { return m.flood ? 1.0 : 0.0; }},
    {"_ijk_absolute_mode",
     [](const Modal& m) { return known(m, Part::centres, m.absolute_centres ? 1.0 : 0.0); }},
    {"_imperial",
     [](const Modal& m) { return known(m, Part::units, m.mm_per_unit == 1 ? 0.0 : 1.0); }},
    {"_incremental",
     [](const Modal& m) { return known(m, Part::distance, m.incremental ? 1.0 : 0.0); }},
    {"_inverse_time", has_feed_mode<FeedMode::inverse_time>},
    {"_lathe_diameter_mode", zero},
    {"_lathe_radius_mode", one},
    {"_metric",
     [](const Modal& m) { return known(m, Part::units, m.mm_per_unit == 1 ? 1.0 : 0.0); }},
    {"_metric_machine", one},
    {"_mist", [](const Modal& m) { return m.mist ? 1.0 : 0.0; }},
    {"_motion_mode", motion_mode},
    {"_plane", plane},
    {"_remap_level", zero},
    {"_retract_old_z", [](const Modal& m) { return retracts_to_r(m) ? 0.0 : 1.0; }},
    {"_retract_r_plane", [](const Modal& m) { return retracts_to_r(m) ? 1.0 : 0.0; }},
    {"_rpm", spindle_speed},
    {"_selected_pocket", selected_pocket},
    {"_selected_tool", selected_tool},
    {"_speed_override", [](const Modal& m) { return m.speed_override ? 1.0 : 0.0; }},
    {"_spindle_css_mode", zero},
    {"_spindle_cw", [](const Modal& m) { return m.spindle_direction > 0 ? 1.0 : 0.0; }},
    {"_spindle_on", [](const Modal& m) { return m.spindle_direction != 0 ? 1.0 : 0.0; }},
    {"_spindle_rpm_mode", one},
    {"_task", zero},
    {"_tool_offset", [](const Modal& m) { return m.tool_offset.isZero(0) ? 0.0 : 1.0; }},
    {"_u", zero},
    {"_units_per_minute", has_feed_mode<FeedMode::per_minute>},
    {"_units_per_rev", has_feed_mode<FeedMode::per_turn>},
    {"_v", zero},
    {"_vmajor", [](const Modal&) { return 2.9; }},
    {"_vminor", zero},
    {"_w", zero},
    {"_x", at<0>},
    {"_y", at<1>},
    {"_z", at<2>},
};

/// #4001 to #4120 of FANUC: by the number of the group of codes, or that of the letter.
struct Coded {
  int number;
  double (*read)(const Modal&);
};

constexpr double kNoMotion = 80;
constexpr double kTenths = 10;  // G54.1 is 541 to LinuxCNC and 54.1 to FANUC

double feed_code(const Modal& modal) {
  constexpr double kCodesOfModes[] = {94, 93, 95};
  const double code = kCodesOfModes[static_cast<std::size_t>(modal.feed_mode)];
  return known(modal, Part::feed_mode, code);
}

/// P of G54.1; 0 in another system.
double further_system(const Modal& modal) {
  return known(modal, Part::work_system, std::max(modal.state.active - kWorkSystems + 1, 0));
}

bool in_cycle(const Modal& modal) {
  return modal.motion != nullptr && is_canned_cycle(*modal.motion);
}

double motion_code(const Modal& modal) {
  if (!in_cycle(modal) || modal.unknown.has(Part::motion)) return motion_mode(modal) / kTenths;
  return modal.motion_below != nullptr ? modal.motion_below->number / kTenths : kNoMotion;
}

double cycle_code(const Modal& modal) {
  if (modal.unknown.has(Part::motion)) return kUnknown;
  return in_cycle(modal) ? modal.motion->number / kTenths : kNoMotion;
}

constexpr Coded kFanucCodes[] = {
    {1, motion_code},
    {2, [](const Modal& m) { return plane(m) / kTenths; }},
    {3, [](const Modal& m) { return known(m, Part::distance, m.incremental ? 91.0 : 90.0); }},
    {5, feed_code},
    {6, [](const Modal& m) { return known(m, Part::units, m.mm_per_unit == 1 ? 21.0 : 20.0); }},
    {7, [](const Modal& m) { return compensation(m) / kTenths; }},
    {8, [](const Modal& m) { return m.length_on ? 43.0 : 49.0; }},
    {9, cycle_code},
    {10, [](const Modal& m) { return m.retract_to_r.value_or(false) ? 99.0 : 98.0; }},
    {11,
     [](const Modal& m) {
       return known(m, Part::scaling, m.transformation.scaling ? 51.0 : 50.0);
     }},
    {14, [](const Modal& m) { return coordinate_system(m) / kTenths; }},
    {16,
     [](const Modal& m) {
       return known(m, Part::rotation, m.transformation.rotation ? 68.0 : 69.0);
     }},
    {17, [](const Modal& m) { return known(m, Part::polar, m.polar ? 16.0 : 15.0); }},
    {22,
     [](const Modal& m) {
       return known(m, Part::mirror, m.transformation.mirrors() ? 51.1 : 50.1);
     }},
    {107, [](const Modal& m) -> double { return m.radius_number.value_or(0); }},
    {109, feed},
    {111, [](const Modal& m) -> double { return m.length_number; }},
    {119, spindle_speed},
    {120, selected_tool},
    {130, further_system},
};

}  // namespace

std::optional<double> ModalVariables::read(std::string_view name) const {
  for (const Named& row : kNamedVariables)
    if (row.name == name) return row.read(modal_);
  return std::nullopt;
}

std::optional<double> ModalVariables::read(int number) const {
  if (unknown_.count(number) > 0) return kUnknown;
  if ((modal_.unknown.has_any(kOffsets) || !knows_unit()) && is_offset(number)) return kUnknown;
  if (const auto offset = offset_variable(number, modal_.state, dialect_))
    return *offset->value / (offset->unit * unit());
  return is_fanuc_like(dialect_) ? read_fanuc(number) : read_linuxcnc(number);
}

/// Mm, of the lengths that are kept.
double ModalVariables::unit() const noexcept {
  return is_fanuc_like(dialect_) ? modal_.mm_per_unit : 1;
}

bool ModalVariables::knows_unit() const noexcept {
  return !is_fanuc_like(dialect_) || !modal_.unknown.has(Part::units);
}

double ModalVariables::fanuc_unit(int number) const {
  const bool offset =
      offset_variable(number, modal_.state, Dialect::fanuc) || further_system_variable(number);
  return offset ? modal_.mm_per_unit : 1;
}

std::optional<double> ModalVariables::read_linuxcnc(int number) const {
  if (number == kShiftOn) return modal_.state.shift_on ? 1 : 0;
  if (number == kActive) return modal_.state.active + 1;
  if (number == kLoadedTool) return loaded_tool(modal_);
  if (number == kDiameter) return diameter();
  if (const int axis = axis_in(number, kFirstPosition); axis >= 0)
    return program_position(modal_, axis);
  if (const int axis = axis_in(number, kToolOffset); axis >= 0) return tool_length(axis);
  const bool lacking = (number >= kFirstPosition && number < kPositionEnd) ||
                       (number >= kToolOffset && number < kToolEnd);
  return lacking ? std::optional(0.0) : std::nullopt;  // of axes and of a lathe's tools
}

/// Of the tool in the spindle, mm.
double ModalVariables::diameter() const {
  if (modal_.unknown.has_any({Part::tool, Part::tool_data})) return kUnknown;
  return 2 * tools().radius(modal_.state.loaded_tool.value_or(0)).value_or(0);
}

/// Of the tool in the spindle as the table has it, mm: whether G43 is in force or not.
double ModalVariables::tool_length(int axis) const {
  if (modal_.unknown.has_any({Part::tool, Part::tool_data})) return kUnknown;
  const auto tool = tools().find(modal_.state.loaded_tool.value_or(0));
  return tool ? tool->length[axis] : 0;
}

std::optional<double> ModalVariables::read_fanuc(int number) const {
  if (const int axis = axis_in(number, kBlockEnd); axis >= 0) return program_position(modal_, axis);
  if (const int axis = axis_in(number, kCurrent); axis >= 0) return work_position(modal_, axis);
  if (const int axis = axis_in(number, kMachine); axis >= 0) return machine_position(modal_, axis);
  if (const int axis = axis_in(number, kLength); axis >= 0)
    return knows_unit() ? modal_.tool_offset[axis] / unit() : kUnknown;
  if (const int axis = axis_in(number, kCommon); axis >= 0)
    return is_local_shift(number, dialect_) ? modal_.local_shift[axis] / unit() : 0;
  if (is_kept_variable(number, dialect_)) {
    const auto kept = modal_.state.parameters.find(number);
    return kept != modal_.state.parameters.end() ? kept->second : kVacant;
  }
  if (const auto of_tool = of_tool_in(number)) {
    ToolOffset tool = tools().find(of_tool->tool).value_or(ToolOffset{});
    return of_tool->of(tool) / (of_tool->unit * unit());
  }
  if (const auto of_system = further_system_variable(number))
    return modal_.state.work_system(of_system->index).origin[of_system->axis] / unit();
  if (number == kNoSingleBlock || number == kNoHold) return 0;
  for (const Coded& row : kFanucCodes)
    if (kCodeVariables + row.number == number) return row.read(modal_);
  return std::nullopt;
}

std::optional<ToolVariable> ModalVariables::of_tool_in(int number) const {
  return tool_variable(number, dialect_, machine_.program.cutter_offsets);
}

bool ModalVariables::is_offset(int number) const {
  return offset_variable(number, modal_.state, dialect_) ||
         (is_fanuc_like(dialect_) && (of_tool_in(number) || further_system_variable(number) ||
                                      is_local_shift(number, dialect_)));
}

bool ModalVariables::has(int number, Dialect dialect) const {
  if (offset_variable(number, modal_.state, dialect)) return true;
  const ModalVariables there(modal_, machine_, dialect);
  return (is_fanuc_like(dialect) ? there.read_fanuc(number) : read_linuxcnc(number)).has_value();
}

bool ModalVariables::is_read_only(int number) const {
  if (is_offset(number)) return false;
  return !is_fanuc_like(dialect_) ||
         !(is_kept_variable(number, dialect_) || number == kNoSingleBlock || number == kNoHold);
}

/// Lengths are none: #2001 to #2400.
bool ModalVariables::assumes_unit(int number) const {
  if (dialect_ != Dialect::haas || modal_.diameter_warned) return false;
  if (machine_.program.cutter_offsets != CutterOffset::unstated) return false;
  const auto of_tool = of_tool_in(number);
  modal_.diameter_warned = of_tool && of_tool->unit != 1;
  return modal_.diameter_warned;
}

double ModalVariables::limit(int number) const {
  if (!is_offset(number)) return std::numeric_limits<double>::max();
  const auto offset = offset_variable(number, modal_.state, dialect_);
  return (offset ? offset->limit : kFarthest) / unit();
}

/// A vacant offset is 0.
bool ModalVariables::write(int number, double value) {
  if (!is_offset(number) && !is_fanuc_like(dialect_)) return false;
  unknown_.erase(number);
  if (is_unknown(value) || (is_offset(number) && !knows_unit())) {
    unknown_.insert(number);
    if (is_offset(number)) modal_.unknown.add(of_tool_in(number) ? Part::tool_data : Part::shift);
    return true;
  }
  if (!is_offset(number)) return write_fanuc(number, value);
  write_offset(number, is_vacant(value) ? 0 : value);
  modal_.assign_offset(is_fanuc_like(dialect_));
  return true;
}

void ModalVariables::keep(int number, double value) {
  if (!is_unknown(value)) modal_.state.parameters[number] = value;
}

void ModalVariables::keep(std::string_view name, double value) {
  modal_.state.globals.insert_or_assign(std::string(name), value);
}

/// Expects a number that is_offset().
void ModalVariables::write_offset(int number, double value) {
  if (const auto offset = offset_variable(number, modal_.state, dialect_))
    *offset->value = value * offset->unit * unit();
  else if (const auto of_tool = of_tool_in(number))
    of_tool->of(tools().row(of_tool->tool)) = value * of_tool->unit * unit();
  else if (const auto of_system = further_system_variable(number))
    modal_.state.work_system_entry(of_system->index).origin[of_system->axis] = value * unit();
  else
    modal_.local_shift[axis_in(number, kCommon)] = value * unit();
}

bool ModalVariables::write_fanuc(int number, double value) {
  if (!is_kept_variable(number, dialect_)) return true;  // a switch
  if (is_vacant(value))
    modal_.state.parameters.erase(number);
  else
    modal_.state.parameters[number] = value;
  return true;
}

}  // namespace softcnc::ipr
